#include "reports/simulate_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "core/error.h"
#include "made_report.h"
#include "reports/json_text.h"

namespace plumb {
namespace {

using made::MakeSimulateReport;
using testing::HasSubstr;
using testing::Not;

TEST(SimulateReport, IsTheSameByteForByte) {
    EXPECT_EQ(ToHtml(MakeSimulateReport()), ToHtml(MakeSimulateReport()));
    EXPECT_EQ(JsonText(ToJson(MakeSimulateReport())), JsonText(ToJson(MakeSimulateReport())));
}

TEST(SimulateReport, EscapesTheNameOfTheMap) {
    const std::string html = ToHtml(MakeSimulateReport());
    EXPECT_THAT(html, Not(HasSubstr("<b>\"x\"")));
    EXPECT_THAT(html, HasSubstr("<h1>Light on &lt;b&gt;&quot;x&quot;&lt;/b&gt;"));
}

TEST(SimulateReport, DrawsEveryQuantityOverBothVisibilities) {
    const std::string html = ToHtml(MakeSimulateReport());
    for (const char* id : {"population", "visibility", "first-bounce", "bounces", "totals",
                           "amplitude-curves", "amplitude-means"})
        EXPECT_THAT(html, HasSubstr(std::string("<canvas id=\"") + id + "\""));
    EXPECT_THAT(html, HasSubstr("<option>α</option><option>V</option>"));
}

TEST(SimulateReport, JsonHasFiguresAndCurvesButNoPictures) {
    const nlohmann::ordered_json json = ToJson(MakeSimulateReport());
    EXPECT_EQ(json["surface"]["figures"]["facets"], 64);
    EXPECT_EQ(json["surface"]["figures"]["aperture"]["mean"], 1.0005);
    EXPECT_EQ(json["surface"]["over_cosine_visibility"]["binned_by"], "cosine visibility");
    EXPECT_FALSE(json.contains("timings"));
    EXPECT_THAT(json.dump(), Not(HasSubstr("base64")));
}

TEST(SimulateReport, TableShowsADashForWhatIsNotKnown) {
    std::ostringstream out;
    WriteTable(out, MakeSimulateReport());
    EXPECT_THAT(out.str(), testing::ContainsRegex("facets +64\n"));
    EXPECT_THAT(out.str(), testing::ContainsRegex("mean slope \\[deg\\] +–\n"));
    EXPECT_THAT(out.str(), HasSubstr("1.00050 ± 0.00020"));
}

TEST(SimulateReport, IsOfOneMap) {
    SimulateReport report = MakeSimulateReport();
    report.provenance.maps.clear();
    EXPECT_THROW(ToJson(report), Error);
}

}  // namespace
}  // namespace plumb
