// What a truth says of itself, on the terminal and in JSON: each number in the place of its name.
#include "reports/truth_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "reports/render.h"
#include "tests/reports/json_schema.h"
#include "tests/reports/page_reader.h"

namespace plumb {
namespace {

TruthReport Made() {
    TruthReport report;
    report.scene = "hall";
    report.width_px = 320;
    report.height_px = 200;
    report.seed = 7;
    report.nets = 8;
    report.spp = 256;
    report.stopped_by = "samples";
    report.quantities = {
        {.name = "V", .mean = 0.25, .rms_error = 0.0125, .rms_below = 0.02, .rms_above = 0.035},
        {.name = "E_1",
         .mean = 0.125,
         .rms_error = 0.0025,
         .rms_below = 0.001,
         .rms_above = 0.006}};
    report.pixels_seen = 60000;
    report.seen_from_behind = 12;
    report.zero_area_triangles = 34;
    report.lost_walks = 56;
    report.notes = {"a note"};
    return report;
}

// The words of the first line that starts with these.
std::vector<std::string> LineOf(const std::string& text, const std::string& start) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("  " + start + " ")) continue;
        std::istringstream in(line);
        std::vector<std::string> words;
        for (std::string word; in >> word;) words.push_back(word);
        return words;
    }
    return {};
}

TEST(TruthReport, TerminalHasEachNumberBelowItsTitle) {
    const std::string text = ToTerminal(DocumentOf(Made()));
    using Words = std::vector<std::string>;
    EXPECT_EQ(LineOf(text, "Quantity"), (Words{"Quantity", "Mean", "Standard", "error", "95",
                                               "%", "interval,", "below", "above"}));
    EXPECT_EQ(LineOf(text, "V"), (Words{"V", "0.25000", "0.0125", "0.0200", "0.0350"}));
    EXPECT_EQ(LineOf(text, "E_1"), (Words{"E_1", "0.12500", "0.00250", "0.00100", "0.00600"}));
    EXPECT_EQ(LineOf(text, "Samples a pixel").back(), "256");
    EXPECT_EQ(LineOf(text, "Stopped by").back(), "samples");
    EXPECT_EQ(LineOf(text, "Lost walks").back(), "56");
    EXPECT_NE(text.find("Note: a note."), std::string::npos);
}

TEST(TruthReport, JsonHasEachNumberUnderItsName) {
    const auto json = nlohmann::ordered_json::parse(ToJsonText(DocumentOf(Made())));
    EXPECT_EQ(FactIn(json, "width_px"), 320);
    EXPECT_EQ(FactIn(json, "height_px"), 200);
    EXPECT_EQ(json["provenance"]["seed"], 7);
    EXPECT_EQ(FactIn(json, "nets"), 8);
    EXPECT_EQ(FactIn(json, "spp"), 256);
    const auto rows = TableIn(json, "quantities")["rows"];
    EXPECT_EQ(rows[1]["mean"], 0.125);
    EXPECT_EQ(rows[1]["rms_standard_error"], 0.0025);
    EXPECT_EQ(rows[1]["rms_below_95"], 0.001);
    EXPECT_EQ(rows[1]["rms_above_95"], 0.006);
    EXPECT_EQ(FactIn(json, "pixels_that_show_a_surface"), 60000);
    EXPECT_EQ(FactIn(json, "pixels_that_show_a_back"), 12);
    EXPECT_EQ(FactIn(json, "zero_area_triangles_kept_out"), 34);
    EXPECT_EQ(FactIn(json, "lost_walks"), 56);
    EXPECT_TRUE(SchemaErrors(PublishedSchema("document-1.json"), nlohmann::json(json)).empty());
}

}  // namespace
}  // namespace plumb
