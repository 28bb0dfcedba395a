// What the drawings and sentences of a scene's page say, from a report made by hand.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "reports/depth_html.h"
#include "reports/plot.h"
#include "reports/scene_report_page.h"
#include "reports/waterfall.h"

namespace plumb {
namespace {

Measured Time(double seconds) {
    return {.value = seconds, .interval = {seconds / 2, 2 * seconds}};
}

// The numbers of a series, by the label that it has in the legend.
std::vector<double> Numbers(const PlotSheet& sheet, const std::string& label,
                            const std::string& axis, std::size_t view = 0) {
    const nlohmann::ordered_json json = sheet.ToJson();
    for (const auto& plot : json["plots"]) {
        if (plot["views"].size() <= view) continue;
        for (const auto& series : plot["views"][view]["series"]) {
            if (series["label"] != label) continue;
            return json["columns"][series[axis].get<std::size_t>()].get<std::vector<double>>();
        }
    }
    ADD_FAILURE() << label << " " << json.dump().substr(0, 600);
    return {};
}

TEST(ScenePlots, OfTheSweepHaveTimesAndErrors) {
    SceneReport r;
    for (const double k : {1.0, 2.0, 3.0}) {
        SweepPoint p;
        p.technique = k < 3 ? "a" : "b";
        p.setting = "s";
        p.seconds = Time(0.001 * k);
        p.rmse.value = 0.1 / k;
        p.recalibrated_rmse.value = 0.01 * k;
        p.on_front = k != 2;
        r.sweep.push_back(p);
    }
    PlotSheet sheet;
    page::SweepHtml(r, sheet);
    EXPECT_EQ(Numbers(sheet, "a", "x"), (std::vector<double>{1, 2}));
    EXPECT_EQ(Numbers(sheet, "a", "y"), (std::vector<double>{0.1, 0.05}));
    EXPECT_EQ(Numbers(sheet, "a", "y", 1), (std::vector<double>{0.01, 0.02}));
    EXPECT_EQ(Numbers(sheet, "b", "y", 1), (std::vector<double>{0.03}));
    EXPECT_EQ(Numbers(sheet, "Pareto front", "x"), (std::vector<double>{1, 3}));
    EXPECT_EQ(Numbers(sheet, "Pareto front", "y"), (std::vector<double>{0.1, 0.0333333}));
}

TEST(ScenePlots, OfTheRadiusHaveTheirTimes) {
    SceneReport r;
    r.threads = 2;
    r.rounds = 5;
    r.raster_s = Time(0.0123);
    r.copy_bytes_per_second = Time(8.5e9);
    r.embree_rays_per_second = Time(6.75e6);
    r.radii_width_px = 2560;
    r.radii_height_px = 1600;
    r.radii.push_back({0.5, Time(0.01), Time(0.02), Time(0.04)});
    r.radii.push_back({2.0, Time(0.011), Time(0.05), Time(0.09)});
    PlotSheet sheet;
    const std::string html = page::TimesHtml(r, sheet);
    std::vector<std::vector<double>> columns;
    const nlohmann::ordered_json json = sheet.ToJson();
    for (const auto& series : json["plots"][0]["views"][0]["series"]) {
        columns.push_back(
            json["columns"][series["y"].get<std::size_t>()].get<std::vector<double>>());
    }
    EXPECT_EQ(columns, (std::vector<std::vector<double>>{{10, 11}, {20, 50}, {40, 90}}));
    EXPECT_NE(html.find("One G-buffer takes 12.3 ms"), std::string::npos);
    EXPECT_NE(html.find("copies 8.50 GB/s"), std::string::npos);
    EXPECT_NE(html.find("casts 6.75 million"), std::string::npos);
    EXPECT_NE(html.find("medians of 5 rounds"), std::string::npos);
    EXPECT_NE(html.find("2560 × 1600"), std::string::npos);
}

// By hand: the greatest is 0.4, over 560 px from x = 110. The first bar from 0 to 0.2 is 280 px wide;
// the second to 0.4 the same from 390; the third falls to 0.1: from 250, 420 wide, in the other colour.
TEST(Waterfall, BarsRunFromTheLastValueToTheNext) {
    const std::string svg =
        WaterfallSvg({{"one", 0.2, 0.1}, {"two", 0.4, 0.2}, {"three", 0.1, 0.05}});
    const auto has = [&](const std::string& text) {
        EXPECT_NE(svg.find(text), std::string::npos) << text << "\n" << svg;
    };
    has("x=\"110.00\" y=\"5.0000\" width=\"280.00\"");
    has("x=\"390.00\" y=\"31.000\" width=\"280.00\"");
    has("x=\"250.00\" y=\"57.000\" width=\"420.00\"");
    has(std::string("fill=\"") + kOursColor + "\"");
    has("x=\"249.00\"");  // The first tick, 0.1.
}

TEST(DepthHtml, HasTheRowsOfItsReport) {
    ZPrecisionReport report;
    ZErrorCurve curve{.host = "double",
                      .concatenated = true,
                      .order = "rows",
                      .clip = "D3D",
                      .format = "D24",
                      .far_is_infinite = true,
                      .distance_m = {1, 2},
                      .rms_m = {0.001, 0.0025},
                      .worst_m = {0.007, 0.004},
                      .mean_m = {0, 0}};
    report.curves.push_back(curve);
    DrawnPrecision drawn;
    drawn.camera = "court";
    drawn.vertices = "float";
    drawn.format = "D16";
    drawn.z_rms_m = 0.00111;
    drawn.z_worst_m = 0.0222;
    drawn.normal_rms_deg = 0.333;
    drawn.normal_99_deg = 0.444;
    drawn.normal_worst_deg = 5.55;
    drawn.within_paper_share = 0.6666;
    report.drawn.push_back(drawn);
    PlotSheet sheet;
    const std::string html = DepthHtml(report, sheet);
    const auto has = [&](const std::string& text) {
        EXPECT_NE(html.find(text), std::string::npos) << text;
    };
    has("<td>2.50</td><td>7.00</td></tr>");
    has("<td>1.11</td><td>22.2</td><td>0.333</td><td>0.444</td><td>5.55</td><td>66.66</td></"
        "tr>");
    EXPECT_EQ(Numbers(sheet, "D24, far plane infinite", "y"), (std::vector<double>{1, 2.5}));
}

}  // namespace
}  // namespace plumb
