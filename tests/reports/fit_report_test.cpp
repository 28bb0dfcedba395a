#include "reports/fit_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/error.h"
#include "made_report.h"
#include "reports/json_text.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;
using made::MakeFitReport;

std::string Written(void (*write)(std::ostream&, const FitReport&), const FitReport& report) {
    std::ostringstream out;
    write(out, report);
    return out.str();
}

std::vector<std::string> Lines(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

/// Fields of a CSV line [RFC 4180].
std::vector<std::string> Fields(const std::string& line) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') {
            if (quoted && i + 1 < line.size() && line[i + 1] == '"')
                fields.back() += line[i++];
            else
                quoted = !quoted;
        } else if (line[i] == ',' && !quoted) {
            fields.emplace_back();
        } else {
            fields.back() += line[i];
        }
    }
    return fields;
}

TEST(FitReportJson, KeepsEveryDigitThroughItsText) {
    const FitReport report = MakeFitReport();
    const Json json = Json::parse(JsonText(ToJson(report)));
    EXPECT_EQ(JsonText(json), JsonText(ToJson(report)));
}

TEST(FitReportJson, NumbersReadBackToTheSameDouble) {
    const Json json = Json::parse(JsonText(ToJson(MakeFitReport())));
    EXPECT_EQ(json["maps"][0]["figures"]["mean_cosine_visibility"].get<double>(), 0.1 + 0.2);
    EXPECT_EQ(json["provenance"]["maps"][1]["spacing_y_m"].get<double>(), 0.1);
    EXPECT_EQ(json["maps"][0]["name"], made::kHostileName);
    EXPECT_EQ(json["curves"][1]["published"]["constants"]["A"].get<double>(),
              27.576937094210385);  // [Mayaux18 eq. 11]
    EXPECT_EQ(json["curves"][0]["fit"]["correlation"][1][0].get<double>(), -0.75);
}

TEST(FitReportJson, LeavesOutEmptyBins) {
    const Json json = ToJson(MakeFitReport());
    const Json& histogram = json["maps"][0]["over_uniform_visibility"];
    EXPECT_EQ(histogram["count"].dump(), "[10,30,40]");
    EXPECT_EQ(histogram["bounces"].size(), 4u);
    EXPECT_EQ(histogram["bounces"][3]["mean"].size(), 3u);
    EXPECT_EQ(histogram["totals"][2]["p95"].size(), 3u);
}

TEST(FitReportJson, WhatIsNotANumberIsNull) {
    const Json json = Json::parse(JsonText(ToJson(MakeFitReport())));
    EXPECT_TRUE(json["maps"][1]["figures"]["mean_cosine_visibility"].is_null());
    EXPECT_TRUE(json["maps"][1]["figures"]["aperture"].is_null());
    EXPECT_TRUE(json["formulas"][1]["held_out"].is_null());
}

TEST(FitReportJson, TimingsStandApartAndMayBeAbsent) {
    FitReport report = MakeFitReport();
    EXPECT_FALSE(ToJson(report).contains("timings"));
    report.timings.stages = {{"plain", "links", 1.5}};
    EXPECT_EQ(ToJson(report)["timings"]["stages"][0]["seconds"], 1.5);
}

TEST(FitReport, IsTheSameByteForByte) {
    const FitReport once = MakeFitReport(), again = MakeFitReport();
    EXPECT_EQ(JsonText(ToJson(once)), JsonText(ToJson(again)));
    EXPECT_EQ(ToHtml(once), ToHtml(again));
    for (auto write : {&WriteScoresCsv, &WriteConstantsCsv, &WriteTable})
        EXPECT_EQ(Written(write, once), Written(write, again));
}

// One line a formula and map, one for all maps; as many fields as the head has.
TEST(FitReportCsv, ScoresHaveTheirColumns) {
    const std::vector<std::string> lines = Lines(Written(&WriteScoresCsv, MakeFitReport()));
    ASSERT_EQ(lines.size(), 1u + 3 * 3);
    EXPECT_EQ(lines[0],
              "formula,map,fitted,inputs,samples,rms,max_abs,poles,out_of_range,held_out_rms,"
              "held_out_max_abs,facet_rms");
    for (const std::string& line : lines) EXPECT_EQ(Fields(line).size(), 12u) << line;
    EXPECT_THAT(Fields(lines[1]),
                testing::ElementsAre("escape of V", made::kHostileName, "yes", "V", "9",
                                     "0.008", "0.024", "0", "0", "0.01", "0.03", "0.012"));
    EXPECT_EQ(Fields(lines[6])[1], "all");
    EXPECT_EQ(Fields(lines[6])[9], "");  // Mayaux18 was not fitted: nothing held out.
}

TEST(FitReportCsv, ConstantsHaveTheirColumns) {
    const std::vector<std::string> lines = Lines(Written(&WriteConstantsCsv, MakeFitReport()));
    // F0 2, F1 2, free F1 4, three bounces of 3, escape of V 2.
    ASSERT_EQ(lines.size(), 1u + 2 + 2 + 4 + 9 + 2);
    for (const std::string& line : lines) EXPECT_EQ(Fields(line).size(), 14u) << line;
    const std::vector<std::string> A = Fields(lines[3]);
    EXPECT_EQ(A[0], "F1");
    EXPECT_EQ(A[2], "A");
    EXPECT_EQ(std::strtod(A[8].c_str(), nullptr), 27.576937094210385);
    EXPECT_EQ(A[10], "0.0625");
    const std::vector<std::string> a = Fields(lines[18]);
    EXPECT_EQ(a[0], "escape of V");
    EXPECT_EQ(a[5], "0.1");
    EXPECT_EQ(a[6], "0.8");
    EXPECT_EQ(a[7], "1.2");
}

TEST(FitReportTable, ShowsConstantsBesideThePublishedOnes) {
    const std::string table = Written(&WriteTable, MakeFitReport());
    EXPECT_THAT(table, testing::HasSubstr("0.5500 ± 0.0050"));  // 1.1 times a = 1/2.
    EXPECT_THAT(table, testing::HasSubstr(" 0.5\n"));
    EXPECT_THAT(table, testing::HasSubstr("0.8000 ... 1.200"));
    EXPECT_THAT(table, testing::HasSubstr("escape of V *"));
    for (const std::string& line : Lines(table))
        EXPECT_LE(
            std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; }),
            100)
            << line;
}

std::string MessageOf(const FitReport& report) {
    try {
        ToJson(report);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(FitReport, SaysWhichPartsDisagree) {
    FitReport report = MakeFitReport();
    report.recommended = "nothing";
    EXPECT_EQ(MessageOf(report), "FitReport::recommended = nothing, must name one of formulas");
    report = MakeFitReport();
    report.floors.pop_back();
    EXPECT_EQ(MessageOf(report),
              "FitReport::floors has 1 entries, must have one for each of 2 maps");
    report = MakeFitReport();
    report.formulas[0].in_sample.maps.pop_back();
    EXPECT_EQ(
        MessageOf(report),
        "FitReport::formulas[escape of V].in_sample has 1 entries, must have one for each "
        "of 2 maps");
    report = MakeFitReport();
    report.formulas[2].name = "Mayaux18";
    EXPECT_EQ(MessageOf(report),
              "FitReport::formulas[Mayaux18] stands there twice, must be one record");
}

}  // namespace
}  // namespace plumb
