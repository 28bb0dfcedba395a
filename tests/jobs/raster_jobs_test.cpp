// The jobs about the rasterizer: what they count, and what they write.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/parallel.h"
#include "jobs/screen_space/bench_raster.h"
#include "jobs/screen_space/z_precision.h"
#include "scenes/simple.h"

namespace plumb {
namespace {

// Expected: with a clock that goes on by 1 s at each look every time is 1 s, so a rate is the
// count itself.
TEST(BenchRaster, CountsWhatItTimes) {
    double now_s = 0;
    const Scene scene = BoxOnPlane();
    const int threads = ThreadCount();
    const RasterBench bench = BenchRaster(
        scene, {.width_px = 64, .height_px = 48, .rounds = 3, .legs_px = {100, 300}},
        [&] { return now_s += 1; });
    EXPECT_EQ(ThreadCount(), threads);
    EXPECT_EQ(bench.triangles, 812);  // docs/scenes.md
    ASSERT_EQ(bench.views.size(), 1u);
    EXPECT_EQ(bench.views[0].camera, "main");
    EXPECT_EQ(bench.views[0].visibility_s, 1);
    EXPECT_GT(bench.views[0].covered, 0.5);
    EXPECT_LT(bench.views[0].covered, 1);
    ASSERT_EQ(bench.sizes.size(), 2u);
    EXPECT_EQ(bench.sizes[0].triangles, 20000);  // 1e8 pixels of 5000 a triangle
    EXPECT_EQ(bench.sizes[0].triangles_per_second, 20000);
    EXPECT_EQ(bench.sizes[0].pixels_per_second, 1e8);
    EXPECT_EQ(bench.sizes[1].triangles, 2222);
    // 1 s for 4 bytes read and 4 written a pixel, beside 1 s for 2^28 bytes.
    EXPECT_NEAR(bench.sizes[0].copy_ratio, 0x1p28 / 8e8, 1e-12);
    const auto json = nlohmann::json::parse(ToJsonText(bench));
    EXPECT_EQ(json["sizes"][1]["legs_px"], 300);
    EXPECT_EQ(json["views"][0]["camera"], "main");
    std::ostringstream table;
    WriteTable(table, bench);
    EXPECT_NE(table.str().find("box_on_plane, 812 triangles"), std::string::npos);
}

TEST(StudyZPrecision, HasEveryWayAndEveryView) {
    ZPrecisionSettings settings;
    settings.curves.poses = 2;
    settings.curves.points = 5;
    settings.curves.distances = 3;
    settings.width_px = 160;
    settings.height_px = 90;
    const Scene scene = BoxOnPlane();
    const ZPrecisionReport report = StudyZPrecision(scene, settings);
    EXPECT_EQ(report.curves.size(), 112u);
    for (const ZErrorCurve& curve : report.curves) {
        ASSERT_EQ(curve.distance_m.size(), 3u);
        EXPECT_DOUBLE_EQ(curve.distance_m.back(), settings.curves.last_m);
    }
    ASSERT_EQ(report.drawn.size(), 16u);  // 4 formats, 2 far planes, 2 vertex paths, 1 camera
    for (const DrawnPrecision& row : report.drawn) {
        EXPECT_GT(row.judged, row.pixels / 2);
        EXPECT_LE(row.normal_99_deg, row.normal_999_deg);
        EXPECT_LE(row.normal_999_deg, row.normal_worst_deg);
        if (row.format == "D32F reversed") {
            EXPECT_EQ(row.within_paper_share, 1);
        }
        if (row.format == "D16") {
            EXPECT_LT(row.within_paper_share, 0.9);
        }
    }
    const auto json = nlohmann::json::parse(ToJsonText(report));
    EXPECT_EQ(json["curves"].size(), 112u);
    EXPECT_EQ(json["drawn"].size(), 16u);
    const std::string csv = CurvesCsv(report);
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 112 * 3);
    const std::string drawn = DrawnCsv(report);
    EXPECT_EQ(std::count(drawn.begin(), drawn.end(), '\n'), 1 + 16);
}

}  // namespace
}  // namespace plumb
