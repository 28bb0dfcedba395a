#include "reports/shader_header.h"

#include <charconv>
#include <cmath>

#include "core/error.h"
#include "reports/text.h"

namespace plumb {
namespace {

constexpr std::string_view kGlslPrologue = R"(
#define PLUMB_FUNCTION
#define PLUMB_FLOAT3 vec3
)";

constexpr std::string_view kHlslPrologue = R"(
#define PLUMB_FUNCTION
#define PLUMB_FLOAT3 float3
)";

constexpr std::string_view kCppPrologue = R"(
#include <cmath>

#define PLUMB_FUNCTION inline
#define PLUMB_FLOAT3 Float3

namespace plumb_shader {

struct Float3 {
    float x, y, z;
    Float3(float s) : x(s), y(s), z(s) {}
    Float3(float r, float g, float b) : x(r), y(g), z(b) {}
};
inline Float3 operator+(Float3 a, Float3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Float3 operator-(Float3 a, Float3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Float3 operator*(Float3 a, Float3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline Float3 operator/(Float3 a, Float3 b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }
inline float max(float a, float b) { return a > b ? a : b; }
inline float min(float a, float b) { return a < b ? a : b; }
inline Float3 max(Float3 a, Float3 b) { return {max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)}; }
inline Float3 min(Float3 a, Float3 b) { return {min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)}; }
inline float pow(float x, float y) { return std::pow(x, y); }
inline float exp(float x) { return std::exp(x); }
inline float sqrt(float x) { return std::sqrt(x); }
)";

/// A comparison with NaN is false: NaN becomes 0.
constexpr std::string_view kUnit = R"(
// x clamped to [0, 1]; 0 if x is not a number.
PLUMB_FUNCTION float PlumbUnit(float x) { return x > 0.0f ? (x < 1.0f ? x : 1.0f) : 0.0f; }
PLUMB_FUNCTION PLUMB_FLOAT3 PlumbUnit(PLUMB_FLOAT3 x) {
    return PLUMB_FLOAT3(PlumbUnit(x.x), PlumbUnit(x.y), PlumbUnit(x.z));
}
)";

/// Text that may stand in a // comment of any shader language: printable ASCII on one line, and
/// no backslash, which would carry the comment on to the next line.
std::string Comment(std::string_view text) {
    std::string safe;
    for (const char c : text) safe += c == '\\' ? '/' : c < ' ' || c > '~' ? '?' : c;
    return safe;
}

std::string Literal(double value, const std::string& what) {
    const float rounded = float(value);
    if (!std::isfinite(rounded)) throw Error(MustBe(what, value, "finite as a float"));
    char buffer[40];
    const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, rounded);
    std::string text(buffer, end);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    text += 'f';
    return value < 0 ? std::string("(").append(text).append(")") : text;
}

void ReplaceAll(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

std::string Arguments(const ModelInputs& inputs, bool typed, const std::string& albedo_type) {
    const std::string real = typed ? "float " : "";
    std::string list;
    if (inputs.alpha) list += real + "uniform_visibility, ";
    if (inputs.V) list += real + "cosine_visibility, ";
    return list + (typed ? albedo_type + " " : "") + "albedo";
}

/// Both overloads, for one albedo and for three.
std::string Functions(const ModelInputs& inputs, const std::string& name, std::string body) {
    std::string text;
    for (const char* type : {"float", "PLUMB_FLOAT3"}) {
        std::string typed = body;
        ReplaceAll(typed, "{T}", type);
        text += std::string("PLUMB_FUNCTION ") + type + " " + name + "(" +
                Arguments(inputs, true, type) + ") {" + typed + "}\n";
    }
    return text;
}

std::string Constants(const Formula& formula) {
    std::string list;
    for (std::size_t j = 0; j < formula.values.size(); ++j)
        list.append(j ? ", " : "")
            .append(formula.model.parameters[j].name)
            .append(" = ")
            .append(Exact(formula.values[j]));
    return list.empty() ? "no constants" : list;
}

std::string Described(const ShaderFormula& one) {
    std::string text = "// " + Comment(one.formula.name);
    if (!one.comment.empty()) text += ": " + Comment(one.comment);
    text += "\n// " + Constants(one.formula) + "\n";
    if (std::isfinite(one.rms)) text += "// RMS error of E(rho) on the maps " + Digits(one.rms);
    if (std::isfinite(one.rms) && std::isfinite(one.held_out_rms))
        text += ", on maps not fitted to " + Digits(one.held_out_rms);
    if (std::isfinite(one.rms)) text += " [-]\n";
    for (const std::string& caveat : one.caveats)
        text += "// Beware: " + Comment(caveat) + "\n";
    return text;
}

std::string Definition(const ShaderFormula& one, const std::string& name) {
    const Model& model = one.formula.model;
    if (model.shader.empty())
        throw Error("model = " + std::string(model.name) + ", must be one with shader code");
    std::string body(model.shader);
    for (std::size_t j = 0; j < one.formula.values.size(); ++j) {
        const std::string parameter(model.parameters[j].name);
        ReplaceAll(body, "{" + parameter + "}",
                   Literal(one.formula.values[j], one.formula.name + ": " + parameter));
    }
    std::string text = "\n";
    return text.append(Described(one)).append(Functions(model.inputs, name, body));
}

std::string Origin(const ShaderHeader& header) {
    const Provenance& from = header.provenance;
    std::string text =
        "// Generated by plumb " + Comment(from.tool_version) + ": " + Comment(from.command) +
        "\n//\n"
        "// The light that reaches a point of an uneven surface under a uniform "
        "sky, all bounces\n// included, over what reaches open ground: E(rho). "
        "Domain: visibilities and albedo rho in\n// [0, 1]; what lies outside is "
        "clamped. Multiply by the irradiance of open ground.\n//\n"
        "//   uniform_visibility  alpha, the open share of the hemisphere's "
        "solid angle\n"
        "//   cosine_visibility   V, the same weighted by the cosine: direct "
        "diffuse light\n//\n"
        "// They are not the same number: do not feed one for the other.\n//\n"
        "// Fitted to light simulated on\n";
    for (const MapSource& map : from.maps)
        text += "//   " + Comment(map.name) + ", " + std::to_string(map.width_texels) + " x " +
                std::to_string(map.height_texels) + " texels of " + Digits(map.spacing_x_m) +
                " x " + Digits(map.spacing_y_m) + " m, amplitude " + Digits(map.amplitude_m) +
                " m, " + Comment(map.boundary) +
                (map.sha256.empty() ? "" : ",\n//     sha256 " + Comment(map.sha256)) + "\n";
    text += "// with " + std::to_string(from.sampling.per_facet) + " " +
            Comment(from.sampling.method) + " a facet, seed " +
            std::to_string(from.sampling.seed) + ".\n";
    if (std::isfinite(header.published_rms))
        text += "// The formula in print [Mayaux18 eq. 12] has an RMS error of " +
                Digits(header.published_rms) + " [-] on the same data.\n";
    return text;
}

}  // namespace

std::string WriteShaderHeader(const ShaderHeader& header, ShaderLanguage language) {
    std::string text = Origin(header);
    text += "#ifndef PLUMB_TOTAL_INCLUDED\n#define PLUMB_TOTAL_INCLUDED\n";
    text += language == ShaderLanguage::kGlsl   ? kGlslPrologue
            : language == ShaderLanguage::kHlsl ? kHlslPrologue
                                                : kCppPrologue;
    text += kUnit;
    text += Definition(header.recommended, "PlumbTotal");
    for (const ShaderFormula& one : header.alternatives) text += Definition(one, one.function);
    text += "\n";
    if (language == ShaderLanguage::kCpp) text += "}  // namespace plumb_shader\n\n";
    return text + "#undef PLUMB_FUNCTION\n#undef PLUMB_FLOAT3\n\n#endif\n";
}

std::string Extension(ShaderLanguage language) {
    return language == ShaderLanguage::kGlsl   ? "glsl"
           : language == ShaderLanguage::kHlsl ? "hlsl"
                                               : "h";
}

}  // namespace plumb
