// Wrong command lines of every subcommand: refused with status 2, at once, in words that name the
// flag or the file, before anything is written.
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <ostream>
#include <string>
#include <vector>

#include "tests/faults/program.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

using testing::HasSubstr;

struct Wrong {
    const char* line;
    const char* words;  ///< On standard error.
};

void PrintTo(const Wrong& wrong, std::ostream* out) {
    *out << wrong.line;
}

std::string Pfm(int width, int height, const std::vector<float>& pixels) {
    return "Pf\n" + std::to_string(width) + " " + std::to_string(height) + "\n-1\n" +
           std::string(reinterpret_cast<const char*>(pixels.data()),
                       pixels.size() * sizeof(float));
}

// To start takes a part of it; with a sanitizer some five times as much.
#ifdef __SANITIZE_ADDRESS__
constexpr double kMostCpuS = 5;
#else
constexpr double kMostCpuS = 1;
#endif

class CommandLines : public TempFolder, public testing::WithParamInterface<Wrong> {};

TEST_P(CommandLines, AreRefused) {
    Put("text.png", "not a picture");
    Put("empty.png", "");
    Put("void.json", "");
    Put("list.json", "[]");
    Put("nothing.json", "{}");
    Put("cut.json", R"({"generator": "wed)");
    Put("unknown.json", R"({"generator": "wedge", "colour": 1})");
    Put("no_mesh.json", R"({"meshes": [{"file": "gone.obj"}]})");
    Put("no_map.json", R"({"heights": [{"file": "gone.png"}]})");
    Put("no_sky.json", R"({"generator": "wedge", "environment": "gone.exr"})");
    Put("technique.json", R"({"generator": "wedge", "techniques": [{"name": "ssao"}]})");
    Put("far.json",
        R"({"generator": "wedge", "techniques": [{"name": "hbao", "radius_m": 1e9}]})");
    Put("table.csv", "bin,E0\n0,nan\n");
    Put("grey.pfm", Pfm(2, 1, {0.25F, 0.5F}));
    Put("wide.pfm", Pfm(3, 1, {0.25F, 0.5F, 1}));
    Put("nan.pfm", Pfm(2, 1, {0.25F, std::nanf("")}));
    Put("infinite.pfm", Pfm(2, 1, {0.25F, INFINITY}));
    Put("black.pfm", Pfm(2, 1, {0, 0}));
    Put("cut.pfm", "Pf\n2 1\n-1\n0000");
    const Ended ended = RunPlumb(Words(GetParam().line), {.folder = folder_});
    EXPECT_FALSE(ended.was_killed) << "after " << ended.clock_s << " s";
    EXPECT_LE(ended.cpu_s, kMostCpuS) << "it worked before it refused";
    EXPECT_EQ(ended.status, 2) << ended.errors;
    EXPECT_THAT(ended.errors, HasSubstr(GetParam().words));
    EXPECT_EQ(ended.output, "");
    EXPECT_FALSE(std::filesystem::exists(Path("out"))) << "something was written";
}

constexpr Wrong kPlumb[] = {
    {"", "--help"},
    {"nothing", "nothing"},
    {"--nothing", "--nothing"},
    {"fits make:bricks:16", "fits"},
    {"--threads 2 simulate make:bricks:16", "--threads"},
};

constexpr Wrong kSimulate[] = {
    {"simulate", "map"},
    {"simulate gone.png", "gone.png"},
    {"simulate gone/gone.png", "gone/gone.png"},
    {"simulate text.png", "text.png"},
    {"simulate empty.png", "empty.png"},
    {"simulate void.json", "void.json"},
    {"simulate make:", "surface \"\""},
    {"simulate make:nothing", "nothing"},
    {"simulate make:bricks:", "SIZE"},
    {"simulate make:bricks:0", "must be"},
    {"simulate make:bricks:-16", "must be"},
    {"simulate make:bricks:1e9", "SIZE"},
    {"simulate make:bricks:99999999", "must be"},
    {"simulate make:bricks:99999999999", "SIZE"},
    {"simulate make:bricks:16:x", "SEED"},
    {"simulate make:bricks:16:1:1", "make:KIND"},
    {"simulate make:bricks:16 make:bricks:16", "make:bricks:16"},
    {"simulate make:bricks:16 --slices", "--slices"},
    {"simulate make:bricks:16 --slices 0", "--slices"},
    {"simulate make:bricks:16 --slices -4", "--slices"},
    {"simulate make:bricks:16 --slices 1e3", "--slices"},
    {"simulate make:bricks:16 --slices four", "--slices"},
    {"simulate make:bricks:16 --slices 99999999999", "--slices"},
    {"simulate make:bricks:16 --method rays --rays 0", "--rays"},
    {"simulate make:bricks:16 --method rays --rays 2000000", "--rays"},
    {"simulate make:bricks:16 --method guess", "--method"},
    {"simulate make:bricks:16 --ray-distribution even", "--ray-distribution"},
    {"simulate make:bricks:16 --bounces -1", "--bounces"},
    {"simulate make:bricks:16 --bounces 100000", "--bounces"},
    {"simulate make:bricks:16 --bins 0", "--bins"},
    {"simulate make:bricks:16 --bins -1", "--bins"},
    {"simulate make:bricks:16 --spacing-m 0", "--spacing-m"},
    {"simulate make:bricks:16 --spacing-m -1", "--spacing-m"},
    {"simulate make:bricks:16 --spacing-m nan", "--spacing-m"},
    {"simulate make:bricks:16 --spacing-m inf", "--spacing-m"},
    {"simulate make:bricks:16 --amplitude-m -1", "--amplitude-m"},
    {"simulate make:bricks:16 --amplitude-m nan", "--amplitude-m"},
    {"simulate make:bricks:16 --amplitude-of-width -1", "--amplitude-of-width"},
    {"simulate make:bricks:16 --amplitude-m 0", "--amplitude-m = 0"},
    {"simulate make:bricks:16 --amplitude-m 1e9", "--amplitude-m 1e+09"},
    {"simulate make:bricks:16 --amplitude-of-width 0", "--amplitude-of-width = 0"},
    {"simulate make:bricks:16 --amplitude-of-width inf", "--amplitude-of-width"},
    {"simulate make:bricks:16 --cut-texels -1", "--cut-texels = -1"},
    {"simulate make:bricks:16 --cut-texels nan", "--cut-texels = nan"},
    {"simulate make:bricks:16 --cut-texels inf", "--cut-texels = inf"},
    {"simulate make:bricks:16 --albedo inf", "--albedo"},
    {"simulate make:bricks:16 --boundary round", "--boundary"},
    {"simulate make:bricks:16 --smooth-px -1", "--smooth-px"},
    {"simulate make:bricks:16 --smooth-px 100", "--smooth-px"},
    {"simulate make:bricks:16 --albedo 1.5", "--albedo"},
    {"simulate make:bricks:16 --albedo -0.1", "--albedo"},
    {"simulate make:bricks:16 --albedo nan", "--albedo"},
    {"simulate make:bricks:16 --albedo 0.5 0.5", "--albedo"},
    {"simulate make:bricks:16 --albedo-map gone.png", "--albedo-map"},
    {"simulate make:bricks:16 --albedo-map text.png", "text.png"},
    {"simulate make:bricks:16 --threads -1", "--threads"},
    {"simulate make:bricks:16 --threads 5000", "--threads"},
    {"simulate make:bricks:16 --seed x", "--seed"},
    {"simulate make:bricks:16 --seed -1", "--seed"},
    {"simulate make:bricks:16 --seed 18446744073709551616", "--seed"},
    {"simulate make:bricks:16 --out", "--out"},
    {"simulate make:bricks:16 --out ''", "--out"},
};

constexpr Wrong kFit[] = {
    {"fit", "--histogram"},
    {"fit gone.png", "gone.png"},
    {"fit make:bricks:16 gone.png", "gone.png"},
    {"fit make:bricks:16 --histogram table.csv", "--histogram"},
    {"fit --histogram gone.csv", "--histogram"},
    {"fit --histogram void.json", "void.json"},
    {"fit --histogram table.csv", "table.csv"},
    {"fit --histogram table.csv --abscissa middle", "--abscissa"},
    {"fit make:bricks:16 --weighting some", "--weighting"},
    {"fit make:bricks:16 --starts 0", "--starts"},
    {"fit make:bricks:16 --bootstrap -1", "--bootstrap"},
    {"fit make:bricks:16 --bootstrap 1", "--bootstrap = 1"},
    {"fit make:bricks:16 --bootstrap 9", "at least 10"},
    {"fit make:bricks:16 --bounces 0", "--bounces = 0"},
    {"fit make:bricks:16 --cut-texels nan", "--cut-texels = nan"},
    {"fit make:bricks:16 --slices 3", "--slices"},
    {"fit make:bricks:16 --out ''", "--out"},
};

constexpr Wrong kTruth[] = {
    {"truth", "scene"},
    {"truth gone.json", "gone.json"},
    {"truth sponza", "sponza"},
    {"truth make:", "scene \"\""},
    {"truth void.json", "void.json"},
    {"truth list.json", "list.json"},
    {"truth nothing.json", "nothing.json"},
    {"truth cut.json", "cut.json:1:"},
    {"truth unknown.json", "unknown.json: colour"},
    {"truth no_mesh.json", "no_mesh.json: meshes[0].file: gone.obj"},
    {"truth no_map.json", "no_map.json: heights[0].file: gone.png"},
    {"truth no_sky.json", "no_sky.json: environment: gone.exr"},
    {"truth wedge --camera none", "none"},
    {"truth wedge --width 0", "--width"},
    {"truth wedge --width 65537", "--width"},
    {"truth wedge --height -3", "--height"},
    {"truth wedge --width 65536 --height 65536", "width_px x height_px"},
    {"truth wedge --spp 100", "--spp"},
    {"truth wedge --spp 0", "--spp"},
    {"truth wedge --spp -64", "--spp"},
    {"truth wedge --spp 32", "--spp"},
    {"truth wedge --bounces 101", "--bounces"},
    {"truth wedge --bounces -1", "--bounces"},
    {"truth wedge --albedo 0.5", "albedo without bounces"},
    {"truth wedge --bounces 2 --albedo 2", "--albedo"},
    {"truth wedge --bounces 2 --albedo nan", "--albedo"},
    {"truth wedge --bounces 2 --albedo 0.5 0.2 0.5", "--albedo = 0.5, must be given once"},
    {"truth wedge --falloff sao", "--reach"},
    {"truth wedge --reach -1", "--reach = -1, must be finite and >= 0"},
    {"truth wedge --reach nan", "--reach"},
    {"truth wedge --reach inf", "--reach"},
    {"truth wedge --reach 1 --falloff steep", "--falloff"},
    {"truth wedge --target-error 0", "--target-error"},
    {"truth wedge --target-error nan", "--target-error"},
    {"truth wedge --target-error inf", "--target-error: inf, must be finite and > 0"},
    {"truth wedge --seconds -1", "--seconds: -1, must be finite and > 0"},
    {"truth wedge --seconds 0", "--seconds"},
    {"truth wedge --seconds nan", "--seconds"},
    {"truth wedge --resume --no-cache", "resume"},
    {"truth wedge --resume", "is missing"},
    {"truth wedge --no-alpha --no-v", "nothing to measure"},
    {"truth wedge --facets --spp 100", "--spp"},
    {"truth wedge --facets --reach 1", "--reach"},
    {"truth wedge --facets --bounces 1 --albedo 0.5", "--albedo"},
    {"truth wedge --facets --json", "--json"},
    {"truth wedge --out ''", "--out"},
};

constexpr Wrong kRender[] = {
    {"render", "scene"},
    {"render gone.json", "gone.json"},
    {"render wedge --technique ssao", "--technique"},
    {"render technique.json", "technique.json"},
    {"render wedge --radius 0", "--radius"},
    {"render wedge --radius -1", "--radius"},
    {"render wedge --radius nan", "--radius"},
    {"render wedge --radius inf", "--radius"},
    {"render wedge --radius 1e9", "--radius = 1e+09, must be in [1e-4, 1e7]"},
    {"render wedge --radius 1e-30", "--radius = 1e-30"},
    {"render wedge --technique hbao --set hbao.radius_m=1e9", "--set hbao.radius_m = 1e9"},
    {"render far.json --technique hbao", "far.json: techniques[0].radius_m = 1000000000"},
    {"render wedge --samples 0", "--samples"},
    {"render wedge --samples -1", "--samples"},
    {"render wedge --samples 5000", "--samples"},
    {"render wedge --guard -1", "--guard"},
    {"render wedge --guard 5000", "--guard"},
    {"render wedge --camera none", "none"},
    {"render wedge --width 0", "--width"},
    {"render wedge --height 20000", "--height"},
    {"render wedge --out ''", "--out"},
};

constexpr Wrong kReport[] = {
    {"report", "scenes"},
    {"report gone.json", "gone.json"},
    {"report wedge gone.json", "gone.json"},
    {"report wedge --technique ssao", "--technique"},
    {"report technique.json", "technique.json"},
    {"report wedge --radius 0", "--radius"},
    {"report wedge --radius nan", "--radius"},
    {"report wedge --radius 1e9", "--radius = 1e+09, must be in [1e-4, 1e7]"},
    {"report wedge --radius 1e-30", "--radius = 1e-30"},
    {"report wedge --set hbao.radius_m=1e9", "--set hbao.radius_m = 1e9"},
    {"report wedge --set hbao.radius_m=nan", "--set hbao.radius_m = nan"},
    {"report far.json", "far.json: techniques[0].radius_m = 1000000000"},
    {"report wedge --technique hbao alchemy hbao", "--technique = hbao, given twice"},
    {"report wedge --camera main main", "main, given twice"},
    {"report wedge --spp 2097152", "--spp"},
    {"report wedge --other-spp 0", "--other-spp = 0"},
    {"report wedge --other-spp -1", "--other-spp = -1"},
    {"report wedge --other-spp 17", "--other-spp = 17"},
    {"report wedge --spp 100", "--spp"},
    {"report wedge --spp 8", "--spp"},
    {"report wedge --budget best", "--budget = best"},
    {"report wedge --rounds 0", "--rounds"},
    {"report wedge --camera none", "none"},
    {"report wedge --guard 5000", "--guard"},
    {"report wedge --out ''", "--out"},
};

constexpr Wrong kScore[] = {
    {"score", "files"},
    {"score grey.pfm", "at least two files"},
    {"score gone.png grey.pfm", "gone.png"},
    {"score grey.pfm gone.exr", "gone.exr"},
    {"score grey.pfm gone.hdr", "gone.hdr"},
    {"score grey.pfm text.png", "text.png"},
    {"score empty.png grey.pfm", "empty.png"},
    {"score void.json grey.pfm", "void.json"},
    {"score cut.pfm grey.pfm", "cut.pfm"},
    {"score wide.pfm grey.pfm", "wide.pfm: is 3 x 1 pixels, must be 2 x 1 as grey.pfm"},
    {"score nan.pfm grey.pfm", "nan.pfm: 1 pixels are not finite, the first at (1, 0)"},
    {"score grey.pfm infinite.pfm", "infinite.pfm: 1 pixels are not finite"},
    {"score nan.pfm grey.pfm --mask black.pfm", "no pixel is left"},
    {"score grey.pfm grey.pfm --mask wide.pfm", "--mask wide.pfm: is 3 x 1"},
    {"score grey.pfm grey.pfm --mask gone.png", "gone.png"},
    {"score grey.pfm:V grey.pfm", "channel = V, must be one of"},
    {"score grey.pfm: grey.pfm", "no channel"},
    {"score grey.pfm grey.pfm --channel V", "channel = V"},
    {"score grey.pfm grey.pfm --region seen", "depth_m"},
    {"score grey.pfm grey.pfm --region all", "--region = all"},
    {"score grey.pfm grey.pfm --crop 0 0 3 1", "--crop"},
    {"score grey.pfm grey.pfm --crop 0 0 0 0", "--crop"},
    {"score grey.pfm grey.pfm --crop 0 0 1", "--crop"},
    {"score grey.pfm grey.pfm --crop -1 0 1 1", "--crop"},
    {"score grey.pfm grey.pfm --encoding gamma", "--encoding"},
    {"score grey.pfm grey.pfm --bad-pixels keep", "--bad-pixels"},
    {"score grey.pfm grey.pfm --flip best", "--flip"},
    {"score black.pfm black.pfm --flip hdr --like oiio-flop", "--like oiio-flop"},
    {"score grey.pfm grey.pfm --tone filmic", "--tone"},
    {"score grey.pfm grey.pfm --pixels-per-degree 0", "--pixels-per-degree = "},
    {"score grey.pfm grey.pfm --pixels-per-degree nan", "--pixels-per-degree = "},
    {"score grey.pfm grey.pfm --peak 0", "--peak"},
    {"score grey.pfm grey.pfm --peak inf", "--peak"},
    {"score grey.pfm grey.pfm --like idif", "did you mean idiff?"},
    {"score grey.pfm grey.pfm --fail-under psnr", "--fail-under psnr"},
    {"score grey.pfm grey.pfm --fail-under psnr=x", "--fail-under psnr=x"},
    {"score grey.pfm grey.pfm --fail-over fl1p=0.1", "did you mean flip?"},
    {"score grey.pfm grey.pfm --out ''", "--out"},
};

constexpr Wrong kBench[] = {
    {"bench", "--help"},
    {"bench nothing", "nothing"},
    {"bench light gone.png", "gone.png"},
    {"bench light make:bricks:16 --slices 1", "--slices"},
    {"bench light make:bricks:16 --rays 0", "--rays"},
    {"bench light make:bricks:16 --rounds 0", "--rounds"},
    {"bench light make:bricks:16 --out ''", "--out"},
    {"bench raster make:nothing", "nothing"},
    {"bench raster gone.json", "gone.json"},
    {"bench raster wedge --width 0", "--width"},
    {"bench raster wedge --rounds 5000", "--rounds"},
    {"bench truth gone.json", "gone.json"},
    {"bench truth wedge --rows 0", "--rows"},
    {"bench truth wedge --paths -1", "--paths"},
    {"bench truth wedge --height 0", "--height"},
    {"bench score --width 0", "--width"},
    {"bench score --rounds 0", "--rounds"},
    {"bench ao gone.json", "gone.json"},
    {"bench ao wedge --radius 0", "--radius"},
    {"bench ao wedge --radius nan", "--radius"},
    {"bench ao wedge --radius 1e9", "--radius = 1e+09, must be in [1e-4, 1e7]"},
    {"bench ao wedge --width 100", "--height"},
    {"bench ao wedge --camera none", "none"},
    {"bench ao wedge --rounds 0", "--rounds"},
    {"bench ao wedge --width 100000 --height 1", "--width"},
};

INSTANTIATE_TEST_SUITE_P(Plumb, CommandLines, testing::ValuesIn(kPlumb));
INSTANTIATE_TEST_SUITE_P(Simulate, CommandLines, testing::ValuesIn(kSimulate));
INSTANTIATE_TEST_SUITE_P(Fit, CommandLines, testing::ValuesIn(kFit));
INSTANTIATE_TEST_SUITE_P(Truth, CommandLines, testing::ValuesIn(kTruth));
INSTANTIATE_TEST_SUITE_P(Render, CommandLines, testing::ValuesIn(kRender));
INSTANTIATE_TEST_SUITE_P(Report, CommandLines, testing::ValuesIn(kReport));
INSTANTIATE_TEST_SUITE_P(Score, CommandLines, testing::ValuesIn(kScore));
INSTANTIATE_TEST_SUITE_P(Bench, CommandLines, testing::ValuesIn(kBench));

}  // namespace
}  // namespace plumb
