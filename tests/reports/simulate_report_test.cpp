#include "reports/simulate_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "made_report.h"
#include "reports/render.h"
#include "tests/reports/json_schema.h"
#include "tests/reports/page_reader.h"

namespace plumb {
namespace {

using made::MakeSimulateReport;
using testing::HasSubstr;
using testing::Not;

TEST(SimulateReport, IsTheSameByteForByte) {
    const doc::Document once = DocumentOf(MakeSimulateReport()),
                        again = DocumentOf(MakeSimulateReport());
    EXPECT_EQ(ToHtml(once), ToHtml(again));
    EXPECT_EQ(ToJsonText(once), ToJsonText(again));
    EXPECT_EQ(ToCsv(once), ToCsv(again));
}

TEST(SimulateReport, EscapesTheNameOfTheMap) {
    const std::string html = ToHtml(DocumentOf(MakeSimulateReport()));
    EXPECT_THAT(html, Not(HasSubstr("<b>\"x\"")));
    EXPECT_THAT(html, HasSubstr("<h1>Light on &lt;b&gt;&quot;x&quot;&lt;/b&gt;"));
}

TEST(SimulateReport, DrawsEveryQuantityOverBothVisibilities) {
    const std::string html = ToHtml(DocumentOf(MakeSimulateReport()));
    for (const char* id : {"population", "visibility", "first-bounce", "bounces", "totals",
                           "amplitude-curves", "amplitude-means"})
        EXPECT_THAT(html, HasSubstr(std::string("<canvas id=\"") + id + "\""));
    EXPECT_THAT(html, HasSubstr("<option>α</option><option>V</option>"));
}

TEST(SimulateReport, JsonHasFiguresAndCurvesButNoPictures) {
    const nlohmann::ordered_json json = ToJson(DocumentOf(MakeSimulateReport()));
    EXPECT_EQ(FactIn(json, "facets"), 64);
    EXPECT_EQ(FactIn(json, "aperture")["value"], 1.0005);
    EXPECT_EQ(TableIn(json, "over_v")["values"]["count"].size(), 3u);
    EXPECT_TRUE(PartOf(json["sections"], "tables", "stages").is_null());
    EXPECT_THAT(json.dump(), Not(HasSubstr("base64")));
    EXPECT_THAT(SchemaErrors(PublishedSchema("document-1.json"), json), testing::IsEmpty());
}

TEST(SimulateReport, TerminalShowsADashForWhatIsNotKnown) {
    const std::string text = ToTerminal(DocumentOf(MakeSimulateReport()));
    EXPECT_THAT(text, testing::ContainsRegex("Facets +64\n"));
    EXPECT_THAT(text, testing::ContainsRegex("Mean slope \\[°\\] +–\n"));
    EXPECT_THAT(text, HasSubstr("1.00050 ± 0.00020"));
}

TEST(SimulateReport, IsOfOneMap) {
    SimulateReport report = MakeSimulateReport();
    report.provenance.maps.clear();
    EXPECT_THROW(DocumentOf(report), Error);
}

}  // namespace
}  // namespace plumb
