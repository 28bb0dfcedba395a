// The study of depth precision: what it counts, and what it writes.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "jobs/screen_space/z_precision.h"
#include "scenes/simple.h"

namespace plumb {
namespace {

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
