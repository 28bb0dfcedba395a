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
#include "reports/render.h"
#include "tests/reports/json_schema.h"
#include "tests/reports/page_reader.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;
using made::MakeFitReport;

std::string ScoresCsv(const FitReport& report) {
    return ToCsv(doc::TableOf(DocumentOf(report), "scores"));
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

TEST(FitReportJson, IsByItsSchemaAndKeepsEveryDigitThroughItsText) {
    const std::string text = ToJsonText(DocumentOf(MakeFitReport()));
    EXPECT_EQ(JsonText(Json::parse(text)), text);
    EXPECT_THAT(SchemaErrors(PublishedSchema("document-1.json"), nlohmann::json::parse(text)),
                testing::IsEmpty());
}

TEST(FitReportJson, NumbersReadBackToTheSameDouble) {
    const Json json = Json::parse(ToJsonText(DocumentOf(MakeFitReport())));
    const Json surfaces = TableIn(json, "surfaces")["rows"];
    EXPECT_EQ(surfaces[0]["mean_cosine_visibility"].get<double>(), 0.1 + 0.2);
    EXPECT_EQ(surfaces[0]["map"], made::kHostileName);
    EXPECT_EQ(TableIn(json, "maps")["rows"][1]["spacing_y_m"].get<double>(), 0.1);
    const Json A = TableIn(json, "curve_constants")["rows"][2];
    EXPECT_EQ(A["constant"], "A");
    EXPECT_EQ(A["published"].get<double>(), 27.576937094210385);  // [Mayaux18 eq. 11]
    EXPECT_EQ(TableIn(json, "correlations")["rows"][0]["correlation"].get<double>(), -0.75);
    const Json constants = TableIn(json, "formula_constants")["values"];
    // Of the published formula, which was not fitted, too.
    EXPECT_THAT(constants["formula"].get<std::vector<std::string>>(),
                testing::Contains("Mayaux18"));
    EXPECT_THAT(constants["value"].get<std::vector<double>>(),
                testing::Contains(27.576937094210385));
}

TEST(FitReportJson, LeavesOutEmptyBins) {
    const Json histogram = TableIn(ToJson(DocumentOf(MakeFitReport())), "over_alpha")["values"];
    const Json &map = histogram["map"], &count = histogram["count"];
    ASSERT_EQ(count.size(), 6u);
    for (const std::size_t b : {0u, 1u, 2u}) {
        EXPECT_EQ(map[b], made::kHostileName);
        EXPECT_EQ(count[b], (std::vector{10, 30, 40}[b]));
    }
    EXPECT_EQ(histogram["e3"].size(), 6u);
    EXPECT_EQ(histogram["e_rho1_p95"].size(), 6u);
}

TEST(FitReportJson, WhatIsNotANumberIsNull) {
    const Json json = Json::parse(ToJsonText(DocumentOf(MakeFitReport())));
    const Json surface = TableIn(json, "surfaces")["rows"][1];
    EXPECT_TRUE(surface["mean_cosine_visibility"].is_null());
    EXPECT_TRUE(surface["aperture"].is_null());
    const Json score = TableIn(json, "scores")["rows"][5];
    EXPECT_EQ(score["formula"], "Mayaux18");
    EXPECT_TRUE(score["held_out_rms"].is_null());
}

TEST(FitReportJson, TimingsStandApartAndMayBeAbsent) {
    FitReport report = MakeFitReport();
    EXPECT_TRUE(PartOf(ToJson(DocumentOf(report))["sections"], "tables", "stages").is_null());
    report.timings = {{"plain", "links", 1.5}};
    EXPECT_EQ(TableIn(ToJson(DocumentOf(report)), "stages")["rows"][0]["seconds"], 1.5);
    FitReport again = report;
    again.timings[0].seconds = 2;
    again.convergence->points[1].seconds.value = 5;
    again.convergence->threads = 3;
    EXPECT_EQ(ToJsonText(WithoutTimes(DocumentOf(report))),
              ToJsonText(WithoutTimes(DocumentOf(again))));
}

TEST(FitReport, IsTheSameByteForByte) {
    const FitReport once = MakeFitReport(), again = MakeFitReport();
    const doc::Document first = DocumentOf(once), second = DocumentOf(again);
    EXPECT_EQ(ToJsonText(first), ToJsonText(second));
    EXPECT_EQ(ToHtml(first), ToHtml(second));
    EXPECT_EQ(ToCsv(first), ToCsv(second));
    EXPECT_EQ(ToTerminal(first), ToTerminal(second));
    EXPECT_EQ(ToCsv(ConstantsTable(once)), ToCsv(ConstantsTable(again)));
}

// One line a formula and map, one for all maps; as many fields as the head has.
TEST(FitReportCsv, ScoresHaveTheirColumns) {
    const std::vector<std::string> lines = Lines(ScoresCsv(MakeFitReport()));
    ASSERT_EQ(lines.size(), 1u + 3 * 3);
    EXPECT_EQ(lines[0],
              "formula,map,fitted,inputs,samples,rms,max_abs,poles,out_of_range,held_out_rms,"
              "held_out_max_abs,facet_rms,held_out_samples,held_out_poles,"
              "held_out_out_of_range");
    for (const std::string& line : lines) EXPECT_EQ(Fields(line).size(), 15u) << line;
    EXPECT_THAT(Fields(lines[1]), testing::ElementsAre("escape of V", made::kHostileName, "yes",
                                                       "V", "9", "0.008", "0.024", "0", "0",
                                                       "0.01", "0.03", "0.012", "9", "0", "0"));
    EXPECT_EQ(Fields(lines[6])[1], "all");
    EXPECT_EQ(Fields(lines[6])[9], "");  // Mayaux18 was not fitted: nothing held out.
}

TEST(FitReportCsv, ConstantsHaveTheirColumns) {
    const std::vector<std::string> lines = Lines(ToCsv(ConstantsTable(MakeFitReport())));
    // F0 2, F1 2, free F1 4, three bounces of 3, escape of V 2.
    ASSERT_EQ(lines.size(), 1u + 2 + 2 + 4 + 9 + 2);
    EXPECT_EQ(lines[0],
              "fit,samples,constant,value,standard_error,bootstrap_standard_error,"
              "bootstrap_low,bootstrap_high,published,rms,published_rms,condition,converged,"
              "at_bound");
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
    const std::string table = ToTerminal(DocumentOf(MakeFitReport()));
    // 1.1 times a = 1/2.
    EXPECT_THAT(table, testing::ContainsRegex("F0 +a +0.550000 +0.0050 +0.50000 "));
    EXPECT_THAT(table, testing::ContainsRegex("escape of V .*0.8000 +1.200"));
    EXPECT_THAT(table, testing::ContainsRegex("escape of V +recommended "));
    for (const std::string& line : Lines(table))
        EXPECT_LE(
            std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; }),
            100)
            << line;
}

std::string MessageOf(const FitReport& report) {
    try {
        DocumentOf(report);
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
