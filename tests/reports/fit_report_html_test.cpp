#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "made_report.h"
#include "reports/fit_report.h"
#include "reports/render.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;
using made::MakeFitReport;
using testing::HasSubstr;
using testing::Not;

Json PlotData(const std::string& html) {
    const std::string open = "<script type=\"application/json\" id=\"plumb-data\">";
    const std::size_t begin = html.find(open) + open.size();
    return Json::parse(html.substr(begin, html.find("</script>", begin) - begin));
}

const Json& PlotOf(const Json& data, const std::string& id) {
    for (const Json& plot : data["plots"])
        if (plot["id"] == id) return plot;
    ADD_FAILURE() << "no plot " << id;
    return data["plots"][0];
}

TEST(FitReportHtml, EscapesNames) {
    const std::string html = ToHtml(DocumentOf(MakeFitReport()));
    EXPECT_THAT(html, Not(HasSubstr("<b>\"x\"")));
    EXPECT_THAT(html, HasSubstr("&lt;b&gt;&quot;x&quot;&lt;/b&gt;, &lt;/script&gt;=1"));
}

// The scripts: data, Chart.js, page.js. A name that closed one would make a fourth.
TEST(FitReportHtml, HasThreeScripts) {
    const std::string html = ToHtml(DocumentOf(MakeFitReport()));
    std::size_t scripts = 0;
    for (std::size_t at = html.find("</script"); at != std::string::npos;
         at = html.find("</script", at + 1))
        ++scripts;
    EXPECT_EQ(scripts, 3u);
}

TEST(FitReportHtml, EveryPlotHasAPlaceAxesAndColumns) {
    const std::string html = ToHtml(DocumentOf(MakeFitReport()));
    const Json data = PlotData(html);
    std::set<std::string> ids;
    for (const Json& plot : data["plots"]) {
        const std::string id = plot["id"];
        EXPECT_TRUE(ids.insert(id).second) << id;
        EXPECT_THAT(html, HasSubstr("<canvas id=\"" + id + "\""));
        ASSERT_FALSE(plot["views"].empty()) << id;
        for (const Json& view : plot["views"]) {
            EXPECT_FALSE((view.contains("x") ? view["x"] : plot["x"])["label"].empty()) << id;
            EXPECT_FALSE((view.contains("y") ? view["y"] : plot["y"])["label"].empty()) << id;
            ASSERT_FALSE(view["series"].empty()) << id;
            for (const Json& series : view["series"]) {
                const auto column = [&](const char* which) {
                    return data["columns"].at(series[which].get<std::size_t>()).size();
                };
                EXPECT_EQ(column("x"), column("y")) << id;
                for (const char* other : {"minus", "high"})
                    EXPECT_TRUE(!series.contains(other) || column(other) == column("y")) << id;
            }
        }
    }
    for (const char* id : {"total-recommended", "total-compared", "total-recommended-residual",
                           "curve-0", "curve-1", "curve-0-residual", "family", "family-log",
                           "family-sum", "poles", "direct-bound", "amplitude-curves",
                           "amplitude-means", "time-visibility", "time-total"})
        EXPECT_TRUE(ids.contains(id)) << id;
}

TEST(FitReportHtml, EveryChoiceOfAReaderHasAView) {
    const std::string html = ToHtml(DocumentOf(MakeFitReport()));
    const Json data = PlotData(html);
    std::set<std::string> seen;
    for (const Json& view : PlotOf(data, "total-compared")["views"])
        seen.insert(view["keys"].dump());
    // (all maps + 2 maps) x 2 abscissae x 1 formula to compare with.
    EXPECT_EQ(seen.size(), 6u);
    EXPECT_THAT(html, HasSubstr("<option>all maps</option>"));
}

// The band of one map runs from the 5 % to the 95 % percentile of E_0: mean -+ 0.02 as made.
TEST(FitReportHtml, TheBandHoldsThePercentiles) {
    const Json data = PlotData(ToHtml(DocumentOf(MakeFitReport())));
    for (const Json& view : PlotOf(data, "curve-0")["views"]) {
        if (view["keys"]["map"] != "plain") continue;
        for (const Json& series : view["series"]) {
            if (series["mark"] != "band") continue;
            const Json& low = data["columns"][series["y"].get<std::size_t>()];
            const Json& high = data["columns"][series["high"].get<std::size_t>()];
            ASSERT_EQ(low.size(), 3u);  // The empty bin is not drawn.
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_NEAR(high[i].get<double>() - low[i].get<double>(), 0.04, 2e-6);
            return;
        }
    }
    FAIL() << "no band";
}

TEST(FitReportHtml, SaysTheHeadlinesInSentences) {
    const std::string html = ToHtml(DocumentOf(MakeFitReport()));
    EXPECT_THAT(html, HasSubstr("<em>escape of V</em> is recommended"));
    EXPECT_THAT(html, HasSubstr("RMS error of <em>0.00800</em> over 2 maps"));
    EXPECT_THAT(html, HasSubstr("and of <em>0.0100</em> on maps that it was not fitted to"));
    // 0.04 / 0.01
    EXPECT_THAT(html, HasSubstr("4.0 times the recommended one&#39;s on unseen maps."));
    EXPECT_THAT(html, HasSubstr("is <em>cavity</em>, RMS 0.0160: 1.6 times"));
    EXPECT_THAT(html, HasSubstr("α = 0.9703 (ρ = 0.5)"));
}

TEST(FitReportHtml, AdmitsWhenTheFitDoesNotPay) {
    FitReport report = MakeFitReport();
    report.formulas[2].in_sample.pooled.rms = 0.005;
    EXPECT_THAT(ToHtml(DocumentOf(report)),
                HasSubstr("the recommended formula does not beat it"));
    report.totals[0].fit.converged = false;
    EXPECT_THAT(ToHtml(DocumentOf(report)),
                HasSubstr("Not converged, do not use their constants: escape "
                          "of V."));
}

TEST(FitReportHtml, DoesWithOneMapAndNothingOptional) {
    FitReport report = MakeFitReport();
    report.maps.pop_back();
    report.provenance.maps.pop_back();
    for (FormulaRecord& record : report.formulas) {
        record.in_sample.maps.pop_back();
        record.held_out.reset();
        record.facet_rms.clear();
    }
    report.floors.clear();
    report.faults.clear();
    report.bounce_family.clear();
    report.totals.clear();
    report.amplitudes.reset();
    report.convergence.reset();
    const std::string html = ToHtml(DocumentOf(report));
    EXPECT_THAT(html, Not(HasSubstr("all maps</option>")));
    EXPECT_THAT(html, Not(testing::ContainsRegex("[^e]nan")));  // But "provenance".
    EXPECT_FALSE(PlotData(html)["plots"].empty());
}

}  // namespace
}  // namespace plumb
