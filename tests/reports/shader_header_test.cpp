#include "reports/shader_header.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "core/error.h"
#include "fit/models/escape_alternatives.h"
#include "fit/models/escape_bent_of_v.h"
#include "fit/models/escape_of_alpha_and_v.h"
#include "fit/models/escape_probability.h"
#include "fit/models/gtao_cubic.h"
#include "fit/models/mayaux_total.h"
#include "fit/models/uniform_cavity.h"

namespace plumb {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Every model with shader code, at constants that a fit may give, or else at its initial values.
std::vector<ShaderFormula> AllFormulas() {
    const auto at = [](const Model& model, std::vector<double> values, const char* function) {
        ShaderFormula one;
        one.formula = {.name = std::string(model.name), .model = model, .values = values};
        one.function = function;
        one.rms = 0.01;
        one.held_out_rms = 0.0125;
        return one;
    };
    std::vector<ShaderFormula> all{
        at(ModelOf<EscapeOfV>(), {0.6667, 0.6303}, "PlumbEscapeOfV"),
        at(ModelOf<EscapeOfAlpha>(), {0.3911, 1.25, 0.832, 1.04}, "PlumbEscapeOfAlpha"),
        at(ModelOf<EscapeOfAlphaClamped>(), {0.62, 0.71, 0.91, 0.52},
           "PlumbEscapeOfAlphaClamped"),
        at(ModelOf<EscapeOfAlphaAndV>(), {0.31, 0.44}, "PlumbEscapeOfBoth"),
        at(ModelOf<EscapeBentOfV>(), {0.42, 0.27}, "PlumbEscapeBentOfV"),
        at(ModelOf<UniformCavityModel>(), {}, "PlumbCavity"),
        at(ModelOf<GtaoCubicModel>(), {2.0404, -0.3324, -4.7951, 0.6417, 2.7552, 0.6903},
           "PlumbGtaoCubic"),
        at(ModelOf<MayauxTotalModel<PoleGuard::kPort>>(),
           {0.5, 0.75, 27.576937094210385, 3.3364392003423804}, "PlumbMayaux")};
    const auto listed = [&](const Model& model) {
        return std::any_of(all.begin(), all.end(), [&](const ShaderFormula& one) {
            return one.formula.model.name == model.name;
        });
    };
    for (const Model& model : AllModels()) {
        if (model.shader.empty() || listed(model)) continue;
        all.push_back(at(model, AtInitialValues(model, "").values, ""));
        all.back().function = "PlumbModel" + std::to_string(all.size());
    }
    return all;
}

ShaderHeader MakeHeader() {
    ShaderHeader header;
    header.provenance.tool_version = "1.2.3";
    header.provenance.command = "plumb fit \"a\\\nb\" caf\xc3\xa9 \\";
    header.provenance.maps.resize(1);
    header.provenance.maps[0].name = "map\n#error injected";
    header.provenance.maps[0].sha256 = std::string(64, 'f');
    header.provenance.sampling = {"slices", 32, 7, 1.5, 8};
    header.alternatives = AllFormulas();
    header.recommended = header.alternatives[0];
    header.published_rms = 0.0625;
    return header;
}

std::filesystem::path TestFolder() {
    const auto folder = std::filesystem::path(PLUMB_BINARY_DIR) / "shader_header_test" /
                        testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(folder);
    return folder;
}

void Save(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

int Execute(const std::string& command) {
    return std::system(command.c_str());
}

std::string Quoted(const std::filesystem::path& path) {
    return "\"" + path.string() + "\"";
}

/// Calls of every function with a scalar and with three albedos, summed into `sum` and `sum3`.
std::string Calls(const std::string& float3) {
    std::string text;
    const auto call = [&](const std::string& name, bool alpha, bool V) {
        const std::string arguments =
            std::string(alpha ? "visibility, " : "") + (V ? "visibility, " : "");
        text += "    sum += " + name + "(" + arguments + "albedo);\n    sum3 += " + name + "(" +
                arguments + float3 + "(albedo, 0.5, 1.0));\n";
    };
    call("PlumbTotal", false, true);
    for (const ShaderFormula& one : AllFormulas())
        call(one.function, one.formula.model.inputs.alpha, one.formula.model.inputs.V);
    return text;
}

// A body that is not tried is compared with nothing.
TEST(ShaderHeader, EveryModelWithShaderCodeIsTried) {
    const std::vector<ShaderFormula> tried = AllFormulas();
    for (const Model& model : AllModels()) {
        EXPECT_EQ(!model.shader.empty(), std::any_of(tried.begin(), tried.end(),
                                                     [&](const ShaderFormula& one) {
                                                         return one.formula.model.name ==
                                                                model.name;
                                                     }))
            << model.name;
    }
}

TEST(ShaderHeader, CompilesAsGlsl) {
    const std::string header = WriteShaderHeader(MakeHeader(), ShaderLanguage::kGlsl);
    const std::filesystem::path folder = TestFolder();
    const auto compile = [&](const std::string& name, const std::string& first_lines) {
        // Twice: the include guard must hold.
        Save(folder / name, first_lines + header + header +
                                "in float visibility;\nin float albedo;\nout vec4 color;\n"
                                "void main() {\n    float sum = 0.0;\n    vec3 sum3 = "
                                "vec3(0.0);\n" +
                                Calls("vec3") + "    color = vec4(sum3, sum);\n}\n");
        return Execute(std::string("\"") + PLUMB_GLSLANG_VALIDATOR + "\" -S frag " +
                       Quoted(folder / name) + " > " + Quoted(folder / (name + ".log")) +
                       " 2>&1");
    };
    EXPECT_EQ(compile("desktop.frag", "#version 130\n"), 0) << folder;
    EXPECT_EQ(compile("es.frag", "#version 300 es\nprecision highp float;\n"), 0) << folder;
    EXPECT_NE(compile("broken.frag", "#version 130\nfloat x = vec3(1.0);\n"), 0)
        << "the compiler is asked in vain";
}

TEST(ShaderHeader, CompilesAsHlsl) {
    const std::string header = WriteShaderHeader(MakeHeader(), ShaderLanguage::kHlsl);
    const std::filesystem::path folder = TestFolder();
    const auto compile = [&](const std::string& name, const std::string& first_lines) {
        Save(folder / name,
             first_lines + header + header +
                 "float4 main(float visibility : TEXCOORD0, float albedo : TEXCOORD1) : "
                 "SV_Target {\n    float sum = 0.0;\n    float3 sum3 = float3(0.0, 0.0, "
                 "0.0);\n" +
                 Calls("float3") + "    return float4(sum3, sum);\n}\n");
        return Execute(std::string("\"") + PLUMB_GLSLANG_VALIDATOR +
                       "\" -D -V -S frag -e main -o " + Quoted(folder / (name + ".spv")) + " " +
                       Quoted(folder / name) + " > " + Quoted(folder / (name + ".log")) +
                       " 2>&1");
    };
    EXPECT_EQ(compile("total.hlsl", ""), 0) << folder;
    EXPECT_NE(compile("broken.hlsl", "static float x = unknown;\n"), 0)
        << "the compiler is asked in vain";
}

// One line a point: the number of the function, its visibility and albedo as exact hexadecimal
// floats, E by the scalar function, E by the middle channel of the other.
std::string GridProgram(const std::string& header) {
    std::string text = header + header + R"(
#include <cstdio>
#include <initializer_list>
#include <limits>
using plumb_shader::Float3;
template <class F>
void Point(F f, int number, float visibility, float albedo) {
    std::printf("%d %a %a %a %a\n", number, visibility, albedo, f(visibility, albedo).x,
                f(visibility, Float3(0.25f, albedo, 0.75f)).y);
}
template <class F>
void Grid(F f, int number) {
    for (int i = 0; i <= 512; ++i)
        for (int j = 0; j <= 64; ++j) Point(f, number, float(i) / 512, float(j) / 64);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    for (float v : {-infinity, -1.0f, 0.0f, 1e-38f, 1e-7f, 0.9999999f, 1.0f, 2.0f, infinity, nan})
        for (float r : {-infinity, -1.0f, 0.0f, 1e-38f, 0.9999999f, 1.0f, 2.0f, infinity, nan})
            Point(f, number, v, r);
}
struct Both {
    float (*one)(float, float);
    Float3 (*three)(float, Float3);
    Float3 operator()(float v, float r) const { return Float3(one(v, r)); }
    Float3 operator()(float v, Float3 r) const { return three(v, r); }
};
// Two visibilities that are never the same but at 1/2: which is which shows.
struct OfBoth {
    float (*one)(float, float, float);
    Float3 (*three)(float, float, Float3);
    Float3 operator()(float v, float r) const { return Float3(one(v, 1.0f - v, r)); }
    Float3 operator()(float v, Float3 r) const { return three(v, 1.0f - v, r); }
};
int main() {
)";
    const std::vector<ShaderFormula> formulas = AllFormulas();
    for (std::size_t i = 0; i < formulas.size(); ++i) {
        const std::string name = "plumb_shader::" + formulas[i].function;
        const ModelInputs& reads = formulas[i].formula.model.inputs;
        text += std::string("    Grid(") + (reads.alpha && reads.V ? "OfBoth{" : "Both{") +
                name + ", " + name + "}, " + std::to_string(i) + ");\n";
    }
    return text + "}\n";
}

double Unit(double x) {
    return x > 0 ? std::min(x, 1.0) : 0;
}

// Expected: the library's formula in double, with inputs and result clamped to [0, 1] and NaN
// taken for 0, as the header says.
//
// Tolerance, eps = 2^-23, every operation and constant rounded by at most eps / 2, the library
// functions pow, exp, sqrt by eps. In E = 1 - (1 - V) q, q = (1 - rho) / ((1 - rho) + rho g) <=
// 1, g = a V^b carries the relative error eps (2 + b |ln V| / 2), of the rounded exponent; on
// the grid V >= 1/512 and b <= 1.1, so 5.5 eps; where V comes from F0, alpha >= 1/512 gives it
// 4 eps more, times b. q adds 3 eps, 1 - V one, the last two operations one each: 16 eps.
// Mayaux18: F1 <= 1/2 carries eps (6 + 3 B alpha^(1/4)) <= 16 eps, F0 <= 1.01 carries 3 eps,
// and the fraction has derivatives of at most 1 in F1 and in 1 - F0: 8 + 2 * 3 + 4 eps. The
// extreme points are clamped or lie where V = 0 or 1. 24 eps for all.
//
// The cubic cancels: its constants and their sums a <= 1.8, b <= 4.2, c <= 3.5 are rounded by
// eps / 2 of their size, 20 eps in all, the five operations after them by eps / 2 of at most
// 4.2 each, 9 eps: 32 eps.
TEST(ShaderHeader, TheCppHeaderAgreesWithTheLibrary) {
    const double tolerance = 24 * std::numeric_limits<float>::epsilon();
    const std::filesystem::path folder = TestFolder();
    Save(folder / "grid.cpp",
         GridProgram(WriteShaderHeader(MakeHeader(), ShaderLanguage::kCpp)));
    ASSERT_EQ(Execute(std::string("\"") + PLUMB_CXX_COMPILER +
                      "\" -std=c++11 -O1 -Wall -Wextra -Wconversion -Werror -o " +
                      Quoted(folder / "grid") + " " + Quoted(folder / "grid.cpp") + " > " +
                      Quoted(folder / "grid.log") + " 2>&1"),
              0)
        << folder;
    ASSERT_EQ(Execute(Quoted(folder / "grid") + " > " + Quoted(folder / "grid.txt")), 0);

    const std::vector<ShaderFormula> formulas = AllFormulas();
    std::vector<double> worst(formulas.size());
    std::ifstream in(folder / "grid.txt");
    int points = 0;
    for (std::string line; std::getline(in, line); ++points) {
        std::istringstream words(line);
        std::string number, visibility, albedo, one, three;
        words >> number >> visibility >> albedo >> one >> three;
        const auto value = [](const std::string& word) {
            return std::strtod(word.c_str(), nullptr);
        };
        const std::size_t f = std::stoul(number);
        const double v = value(visibility);
        const ModelInputs& reads = formulas[f].formula.model.inputs;
        const double V = reads.alpha && reads.V ? double(1.0F - float(v)) : v;
        const double expected =
            Unit(formulas[f].formula({UniformVisibility(Unit(v)), CosineVisibility(Unit(V)),
                                      Albedo(Unit(value(albedo)))}));
        const double E = value(one);
        ASSERT_TRUE(E >= 0 && E <= 1) << formulas[f].function << ": " << line;
        ASSERT_EQ(E, value(three)) << formulas[f].function << ": " << line;
        worst[f] = std::max(worst[f], std::abs(E - expected));
    }
    EXPECT_EQ(points, int(formulas.size()) * (513 * 65 + 10 * 9));
    for (std::size_t f = 0; f < formulas.size(); ++f)
        EXPECT_LE(worst[f],
                  (formulas[f].function == "PlumbGtaoCubic" ? 4 / 3.0 : 1) * tolerance)
            << formulas[f].function;
}

TEST(ShaderHeader, SaysWhereItComesFrom) {
    for (const ShaderLanguage language :
         {ShaderLanguage::kGlsl, ShaderLanguage::kHlsl, ShaderLanguage::kCpp}) {
        const std::string text = WriteShaderHeader(MakeHeader(), language);
        EXPECT_THAT(text, HasSubstr("// Generated by plumb 1.2.3: plumb fit "));
        EXPECT_THAT(text, HasSubstr("sha256 " + std::string(64, 'f')));
        EXPECT_THAT(text, HasSubstr("32 slices a facet, seed 7"));
        EXPECT_THAT(text, HasSubstr("RMS error of 0.0625 [-] on the same data"));
        EXPECT_THAT(text, HasSubstr("on the maps 0.0100, on maps not fitted to 0.0125 [-]"));
        EXPECT_THAT(text, HasSubstr("a = 0.6667, b = 0.6303"));
        EXPECT_EQ(text, WriteShaderHeader(MakeHeader(), language));
    }
}

// A formula that is not the best, or whose constant a bound holds, says so where it is pasted.
TEST(ShaderHeader, SaysWhatMustBeSaidOfAFormula) {
    ShaderHeader header = MakeHeader();
    header.recommended.caveats = {"b = 0 stands at a bound.", "line\nbreak"};
    header.alternatives[1].caveats = {"\"x\" has less error."};
    const std::string text = WriteShaderHeader(header, ShaderLanguage::kHlsl);
    const std::size_t recommended = text.find("// Beware: b = 0 stands at a bound.\n"),
                      function = text.find("float PlumbTotal("),
                      other = text.find("// Beware: \"x\" has less error.\n");
    ASSERT_NE(recommended, std::string::npos);
    EXPECT_LT(recommended, function);
    EXPECT_LT(text.find("float PlumbEscapeOfV("), other);
    EXPECT_LT(other, text.find("float PlumbEscapeOfAlpha("));
    EXPECT_THAT(text, HasSubstr("// Beware: line?break\n"));
}

// A line break or a trailing backslash in a name would put the name, or the next line, into or
// out of the code.
TEST(ShaderHeader, NamesStayInTheirComments) {
    const std::string text = WriteShaderHeader(MakeHeader(), ShaderLanguage::kGlsl);
    EXPECT_THAT(text, Not(HasSubstr("\n#error")));
    EXPECT_EQ(text.find('\\'), std::string::npos);
    for (const char c : text) ASSERT_TRUE(c == '\n' || (c >= ' ' && c <= '~'));
}

TEST(ShaderHeader, RefusesWhatItCannotWrite) {
    ShaderHeader header = MakeHeader();
    header.recommended.formula = AtInitialValues(ModelOf<EscapeLinearOfV>(), "a + b V");
    EXPECT_TRUE(header.recommended.formula.model.shader.empty());
    EXPECT_THROW(WriteShaderHeader(header, ShaderLanguage::kGlsl), Error);
    header = MakeHeader();
    header.recommended.formula.values[0] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(WriteShaderHeader(header, ShaderLanguage::kGlsl), Error);
}

}  // namespace
}  // namespace plumb
