// The study of depth precision: what it counts, and what it writes.
#include <gtest/gtest.h>

#include <algorithm>

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
    const doc::Document document{
        .kind = "z", .title = "z", .sections = {StudyZPrecision(scene, settings)}};
    const auto number = [](const doc::Table& table, std::size_t row, const char* key) {
        return doc::NumberOf(table.At(row, key));
    };
    const auto text = [](const doc::Table& table, std::size_t row, const char* key) {
        return std::get<std::string>(table.At(row, key));
    };
    const doc::Table& curves = doc::TableOf(document, "z_error");
    ASSERT_EQ(curves.rows.size(), 112u * 3);
    const doc::Table& greatest = doc::TableOf(document, "z_greatest");
    ASSERT_EQ(greatest.rows.size(), 112u);
    const std::vector<ZPipeline> ways = AllZPipelines();
    for (std::size_t k = 0; k < 112; ++k) {
        EXPECT_DOUBLE_EQ(number(curves, 3 * k + 2, "distance_m"), settings.curves.last_m);
        const std::vector<ZError> errors = MeasureZError(ways[k], settings.curves);
        double rms = 0, worst = 0;
        for (std::size_t d = 0; d < 3; ++d) {
            const ZError& e = errors[d];
            EXPECT_EQ(number(curves, 3 * k + d, "rms_mm"), 1e3 * e.rms_m);
            EXPECT_EQ(number(curves, 3 * k + d, "worst_mm"), 1e3 * e.worst_m);
            EXPECT_EQ(number(curves, 3 * k + d, "mean_mm"), 1e3 * e.mean_m);
            rms = std::max(rms, 1e3 * e.rms_m);
            worst = std::max(worst, 1e3 * e.worst_m);
        }
        EXPECT_EQ(number(greatest, k, "rms_mm"), rms);
        EXPECT_EQ(number(greatest, k, "worst_mm"), worst);
        const std::string name =
            text(greatest, k, "host") +
            (text(greatest, k, "product") == "one" ? " concatenated " : " separate ") +
            text(greatest, k, "order") + " " + text(greatest, k, "clip") + " " +
            text(greatest, k, "format") + " " + text(greatest, k, "far");
        EXPECT_EQ(name, NameOf(ways[k]));
    }
    // The four views of figure 3: 8 formats each, of rows and D3D.
    const Plot& plot = document.sections[0].plots[0].plots[0];
    ASSERT_EQ(plot.views.size(), 4u);
    int drawn_curves = 0;
    for (const PlotView& view : plot.views) {
        for (const PlotSeries& series : view.series) {
            ++drawn_curves;
            int same = 0;
            for (std::size_t k = 0; k < 112; ++k) {
                if (text(greatest, k, "host") != view.keys[0].second ||
                    text(greatest, k, "product") != view.keys[1].second ||
                    text(greatest, k, "order") != "rows" ||
                    text(greatest, k, "clip") != "D3D" ||
                    text(greatest, k, "format") + (text(greatest, k, "far") == "infinite"
                                                       ? ", far plane infinite"
                                                       : ", finite") !=
                        series.label) {
                    continue;
                }
                ++same;
                for (std::size_t d = 0; d < 3; ++d) {
                    EXPECT_EQ(series.x.Values()[d], number(curves, 3 * k + d, "distance_m"));
                    EXPECT_EQ(series.y.Values()[d], number(curves, 3 * k + d, "rms_mm"));
                }
            }
            EXPECT_EQ(same, 1) << series.label;
        }
    }
    EXPECT_EQ(drawn_curves, 4 * 8);

    const doc::Table& drawn = doc::TableOf(document, "drawn");
    ASSERT_EQ(drawn.rows.size(), 16u);  // 4 formats, 2 far planes, 2 vertex paths, 1 camera
    for (std::size_t row = 0; row < 16; ++row) {
        EXPECT_GT(number(drawn, row, "judged"), number(drawn, row, "pixels") / 2);
        EXPECT_LE(number(drawn, row, "normal_99_deg"), number(drawn, row, "normal_999_deg"));
        EXPECT_LE(number(drawn, row, "normal_999_deg"), number(drawn, row, "normal_worst_deg"));
        EXPECT_LE(number(drawn, row, "z_rms_mm"), number(drawn, row, "z_worst_mm"));
        const double within = number(drawn, row, "within_paper_share");
        if (text(drawn, row, "format") == "D32F reversed") {
            EXPECT_EQ(within, 1);
        }
        if (text(drawn, row, "format") == "D16") {
            EXPECT_LT(within, 0.9);
        }
    }
    EXPECT_EQ(doc::NumberOf(doc::FactOf(document, "poses")), 2);
    EXPECT_EQ(doc::NumberOf(doc::FactOf(document, "points")), 5);
}

}  // namespace
}  // namespace plumb
