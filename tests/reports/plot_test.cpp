#include "reports/plot.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "reports/histogram_plots.h"

namespace plumb {
namespace {

Plot MakePlot(const PlotSheet&, Column x, Column y) {
    PlotView view;
    view.keys = {{"map", "a"}};
    PlotSeries series;
    series.label = "s";
    series.x = x;
    series.y = y;
    view.series = {series};
    Plot plot;
    plot.id = "p";
    plot.title = "A <title>";
    plot.x = {"x [m]", 0, 1};
    plot.y = {"y [s]", {}, {}};
    plot.views = {view};
    return plot;
}

TEST(PlotSheet, RoundsToSixDigitsAndKeepsGaps) {
    PlotSheet sheet;
    const std::vector<double> values{0.123456789, std::numeric_limits<double>::quiet_NaN(),
                                     std::numeric_limits<double>::infinity()};
    sheet.Add(values);
    EXPECT_EQ(sheet.ToJson()["columns"].dump(), "[[0.123457,null,null]]");
}

TEST(PlotSheet, PointsIntoItsColumns) {
    PlotSheet sheet;
    const Column x = sheet.Add(std::vector<double>{1, 2});
    const Column y = sheet.Add(std::vector<double>{3, 4});
    const std::string html =
        sheet.Group({{"map", "Map", {"a", "<b>"}}}, {MakePlot(sheet, x, y)});
    const nlohmann::ordered_json plot = sheet.ToJson()["plots"][0];
    EXPECT_EQ(plot["views"][0]["series"][0]["x"], 0);
    EXPECT_EQ(plot["views"][0]["series"][0]["y"], 1);
    EXPECT_EQ(plot["views"][0]["keys"]["map"], "a");
    EXPECT_EQ(plot["x"]["max"], 1);
    EXPECT_FALSE(plot["y"].contains("max"));
    EXPECT_NE(html.find("<option>&lt;b&gt;</option>"), std::string::npos);
    EXPECT_NE(html.find("A &lt;title&gt;"), std::string::npos);
    EXPECT_NE(html.find("<canvas id=\"p\""), std::string::npos);
}

TEST(PlotSheet, ASelectorWithOneOptionIsNotShown) {
    PlotSheet sheet;
    const Column x = sheet.Add(std::vector<double>{1});
    EXPECT_EQ(sheet.Group({{"map", "Map", {"a"}}}, {MakePlot(sheet, x, x)}).find("<select"),
              std::string::npos);
}

TEST(ScaleColor, StaysWithinItsEnds) {
    EXPECT_EQ(ScaleColor(0), "#440154");  // The first colour of viridis.
    EXPECT_EQ(ScaleColor(-1), ScaleColor(0));
    EXPECT_EQ(ScaleColor(2), ScaleColor(1));
    EXPECT_NE(ScaleColor(1), ScaleColor(0.9));
}

BounceHistogram OneBin(std::int64_t count, std::int64_t elsewhere, double V) {
    BounceHistogram histogram;
    histogram.albedos = {0.5};
    for (int b = 0; b < 2; ++b) {
        BounceBin bin;
        bin.low = b / 2.0;
        bin.high = (b + 1) / 2.0;
        bin.count = b == 0 ? count : elsewhere;
        bin.alpha = bin.V = b == 0 ? V : 0.75;
        bin.bounce = {{.mean = bin.V}};
        bin.total = {{.mean = bin.V / 2}};
        histogram.bins.push_back(bin);
    }
    return histogram;
}

// By hand: bin 0 holds 10 of 20 facets of a, and 30 of 40 of b: w = 1/2 and 3/4, so the mean is
// (0.1 / 2 + 0.2 * 3/4) / (1/2 + 3/4) = 0.16. Weights by count would give 0.175, none 0.15.
TEST(PooledMeans, GivesEveryMapTheSameSay) {
    const BounceHistogram a = OneBin(10, 10, 0.1), b = OneBin(30, 10, 0.2);
    const std::vector<const BounceHistogram*> maps{&a, &b};
    const std::optional<BounceHistogram> pooled = PooledMeans(maps);
    ASSERT_TRUE(pooled.has_value());
    EXPECT_NEAR(pooled->bins[0].V, 0.16, 4e-16);  // Five roundings of numbers below 1.
    EXPECT_NEAR(pooled->bins[0].bounce[0].mean, 0.16, 4e-16);
    EXPECT_NEAR(pooled->bins[0].total[0].mean, 0.08, 4e-16);
    EXPECT_EQ(pooled->bins[0].count, 40);
}

TEST(PooledMeans, RefusesBinsThatDiffer) {
    const BounceHistogram a = OneBin(1, 1, 0.1);
    BounceHistogram b = a;
    b.bins[0].high = b.bins[1].low = 0.4;
    const std::vector<const BounceHistogram*> maps{&a, &b};
    EXPECT_FALSE(PooledMeans(maps).has_value());
}

TEST(PlottedAlbedos, AreTheTenthsWhereThereAreEnough) {
    std::vector<double> albedos;
    for (int i = 0; i <= 20; ++i) albedos.push_back(i / 20.0);
    const std::vector<std::size_t> shown = PlottedAlbedos(albedos);
    ASSERT_EQ(shown.size(), 11u);
    EXPECT_EQ(shown[1], 2u);
    EXPECT_EQ(PlottedAlbedos({0.05, 0.5, 0.95}).size(), 3u);
}

}  // namespace
}  // namespace plumb
