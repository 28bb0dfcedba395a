// What a truth says of itself, on the terminal and in JSON: each number in the place of its name.
#include "reports/truth_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

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

// The words of a line.
std::vector<std::string> Words(const std::string& line) {
    std::istringstream in(line);
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    return words;
}

TEST(TruthReport, TerminalHasEachNumberBelowItsTitle) {
    std::ostringstream out;
    WriteTable(out, Made());
    std::istringstream lines(out.str());
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "quantity         mean  standard error (rms)  95 % interval (rms)");
    std::getline(lines, line);
    EXPECT_EQ(Words(line),
              (std::vector<std::string>{"V", "0.25000", "0.012500", "-0.020000", "+0.035000"}));
    std::getline(lines, line);
    EXPECT_EQ(Words(line), (std::vector<std::string>{"E_1", "0.12500", "0.002500", "-0.001000",
                                                     "+0.006000"}));
    EXPECT_NE(out.str().find("256 samples a pixel, stopped by samples; lost walks 56"),
              std::string::npos);
    EXPECT_NE(out.str().find("note: a note"), std::string::npos);
}

TEST(TruthReport, JsonHasEachNumberUnderItsName) {
    const auto json = nlohmann::json::parse(ToJsonText(Made()));
    EXPECT_EQ(json["camera"]["width_px"], 320);
    EXPECT_EQ(json["camera"]["height_px"], 200);
    EXPECT_EQ(json["seed"], 7);
    EXPECT_EQ(json["nets"], 8);
    EXPECT_EQ(json["spp"], 256);
    EXPECT_EQ(json["quantities"][1]["mean"], 0.125);
    EXPECT_EQ(json["quantities"][1]["rms_standard_error"], 0.0025);
    EXPECT_EQ(json["quantities"][1]["rms_below_95"], 0.001);
    EXPECT_EQ(json["quantities"][1]["rms_above_95"], 0.006);
    EXPECT_EQ(json["pixels_that_show_a_surface"], 60000);
    EXPECT_EQ(json["pixels_that_show_a_back"], 12);
    EXPECT_EQ(json["zero_area_triangles_kept_out"], 34);
    EXPECT_EQ(json["lost_walks"], 56);
}

}  // namespace
}  // namespace plumb
