// What a fit report claims, and what it admits beside it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "fit/models/escape_of_alpha_and_v.h"
#include "fit/models/mayaux_total.h"
#include "made_report.h"
#include "reports/fit_caveats.h"
#include "reports/fit_report.h"
#include "reports/render.h"
#include "reports/text.h"
#include "tests/reports/page_reader.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;
using made::MakeFitReport;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string Terminal(const FitReport& report) {
    return ToTerminal(DocumentOf(report));
}

TEST(Caveats, NoneWhereThereIsNothingToSay) {
    const FitReport report = MakeFitReport();
    EXPECT_THAT(CaveatsOf(report, report.formulas[0]), IsEmpty());
    EXPECT_THAT(CaveatsOf(report, report.formulas[1]), IsEmpty());  // Not fitted: no claim.
    EXPECT_EQ(Terminal(report).find("Beware"), std::string::npos);
}

// A formula of the same table with less error is named, wherever the recommended one is praised.
TEST(Caveats, NameABetterFormulaOfTheSameTable) {
    FitReport report = MakeFitReport();
    report.formulas[2].in_sample.pooled.rms = 0.0093;  // The cavity: never fitted.
    const std::string caveat =
        "\"cavity\" has less error on maps held out, 0.009300 against 0.01000.";
    EXPECT_THAT(CaveatsOf(report, report.formulas[0]), ElementsAre(caveat));
    EXPECT_THAT(Terminal(report), HasSubstr("  - Beware: " + caveat));
    EXPECT_THAT(ToHtml(DocumentOf(report)), HasSubstr("<em>Beware:</em> " + Html(caveat)));
    const Json caveats = TableIn(ToJson(DocumentOf(report)), "caveats")["rows"];
    ASSERT_EQ(caveats.size(), 1u);
    EXPECT_EQ(caveats[0]["formula"], "escape of V");
    EXPECT_EQ(caveats[0]["caveat"], caveat);
    // In sample the recommended one has 0.008: that a fitted one was not held out makes it no
    // rival.
    report.formulas[2].fitted = true;
    EXPECT_THAT(CaveatsOf(report, report.formulas[0]), IsEmpty());
}

TEST(Caveats, OneMapSaysNothingOfOthers) {
    FitReport report = MakeFitReport();
    report.maps.pop_back();
    report.formulas[0].held_out.reset();
    EXPECT_THAT(CaveatsOf(report, report.formulas[0]),
                ElementsAre("Fitted to one map: its error on any other is not known."));
    report.formulas[2].in_sample.pooled.rms = 0.007;
    EXPECT_THAT(CaveatsOf(report, report.formulas[0]),
                ElementsAre(testing::_,
                            "\"cavity\" has less error on the same maps, 0.007000 "
                            "against 0.008000."));
}

TEST(Caveats, TellOfBoundsAndOfFitsThatDidNotConverge) {
    FitReport report = MakeFitReport();
    FittedParameter& b = report.totals[0].fit.parameters[1];
    b.value = 0.01;
    b.at_bound = true;
    report.totals[0].fit.converged = false;
    EXPECT_THAT(
        CaveatsOf(report, report.formulas[0]),
        ElementsAre(
            "b = 0.01000 stands at the bound of its range [0.01, 6]: it has no error bar.",
            "The fit did not converge: do not use its constants."));
}

TEST(Caveats, TellWhichInputIsNotRead) {
    FitReport report = MakeFitReport();
    FormulaRecord& record = report.formulas[0];
    record.formula = {"both", ModelOf<EscapeOfAlphaAndV>(), {0, 0.7}};
    EXPECT_THAT(CaveatsOf(report, record),
                ElementsAre("With b = 0 the escape probability does not read V."));
    record.formula.values = {0.4, 0};
    EXPECT_THAT(CaveatsOf(report, record),
                ElementsAre("With c = 0 the escape probability does not read alpha."));
}

// A value that its range holds is none of the data's: the page says so where it is first read.
TEST(Constants, SayOnTheFirstScreenThatTheyStandAtABound) {
    FitReport report = MakeFitReport();
    EXPECT_EQ(ToHtml(DocumentOf(report)).find("(at its bound)"), std::string::npos);
    FittedParameter& parameter = report.curves[1].fit.parameters[1];
    parameter.at_bound = true;
    parameter.standard_error.reset();
    const std::string page = ToHtml(DocumentOf(report));
    EXPECT_THAT(
        page.substr(0, page.find("The recommended formula</h2>")),
        HasSubstr(parameter.name + " = " + WithError(parameter.value, 0) + " (at its bound)"));
}

TEST(Constants, SayInTheCsvWhichBoundHoldsThem) {
    FitReport report = MakeFitReport();
    report.curves[1].fit.parameters[1].at_bound = true;
    const std::string csv = ToCsv(ConstantsTable(report));
    EXPECT_THAT(csv, HasSubstr("converged,at_bound\n"));
    std::istringstream in(csv);
    int held = 0;
    for (std::string line; std::getline(in, line);) {
        if (!line.ends_with(",yes,yes")) continue;
        EXPECT_THAT(line, testing::StartsWith("F1,18,B,"));
        ++held;
    }
    EXPECT_EQ(held, 1);
}

FitReport WithChoice() {
    FitReport report = MakeFitReport();
    report.choice = FormChoice{.choosing = {"a", "c"},
                               .reporting = {"b"},
                               .forms = {{"cavity", 0, 0.021, 0.033},
                                         {"escape of V", 2, 0.0181, 0.0302},
                                         {"escape alpha^c", 1, 0.0172, 0.0313}}};
    return report;
}

// The winner has the least error on the choosing half (0.0172), and two forms lie before or
// behind it on the other: 0.0302 < 0.0313 < 0.033.
TEST(Choice, IsToldEverywhereInTheSameFigures) {
    const FitReport report = WithChoice();
    const std::string html = ToHtml(DocumentOf(report));
    EXPECT_THAT(html,
                HasSubstr("Of 3 forms, <em>escape alpha^c</em> wins on the choosing half of "
                          "the maps (a and c; RMS held out 0.0172)."));
    EXPECT_THAT(html, HasSubstr("its RMS is <em>0.0313</em>, rank 2."));
    EXPECT_THAT(html,
                HasSubstr("The recommended form has 0.0181 on the choosing half and 0.0302 "
                          "on the other, rank 1."));
    EXPECT_THAT(html, HasSubstr("On the other half (b), which"));
    const Json forms = TableIn(ToJson(DocumentOf(report)), "forms")["rows"];
    EXPECT_EQ(forms[1]["choosing_rms"], 0.0181);
    EXPECT_EQ(forms[1]["reporting_rms"], 0.0302);
    EXPECT_EQ(forms[2]["winner"], "yes");
    EXPECT_EQ(ToCsv(doc::TableOf(DocumentOf(report), "forms")),
              "form,constants,choosing_rms,reporting_rms,winner\n"
              "cavity,0,0.021,0.033,no\n"
              "escape of V,2,0.0181,0.0302,no\n"
              "escape alpha^c,1,0.0172,0.0313,yes\n");
    EXPECT_THAT(Terminal(report),
                testing::ContainsRegex("escape alpha\\^c +1 +0.01720 +0.03130 +yes\n"));
}

const Json& ColumnOf(const Json& data, const Json& series, const char* which) {
    return data["columns"].at(series[which].get<std::size_t>());
}

// Expected: [Mayaux18 eq. 12] as printed, worked out here, with its pole at rho = 1/2 between
// 0.9702 and 0.9703 (tests/fit/mayaux_faults_test.cpp); the guarded formula is drawn dashed and
// stays finite. Tolerance: plots carry six digits.
TEST(Poles, ThePlotShowsTheFormulaAsPrinted) {
    FitReport report = MakeFitReport();
    report.printed = "Mayaux18";
    FormulaRecord guarded = report.formulas[1];
    guarded.formula =
        AtInitialValues(ModelOf<MayauxTotalModel<PoleGuard::kPort>>(), "Mayaux18, guard 1e-5");
    guarded.name = guarded.formula.name;
    report.formulas.push_back(guarded);
    report.published = guarded.name;
    const std::string html = ToHtml(DocumentOf(report));
    const std::string open = "<script type=\"application/json\" id=\"plumb-data\">";
    const std::size_t begin = html.find(open) + open.size();
    const Json data = Json::parse(html.substr(begin, html.find("</script>", begin) - begin));
    int printed = 0, dashed = 0;
    for (const Json& plot : data["plots"]) {
        if (plot["id"] != "poles") continue;
        for (const Json& series : plot["views"][0]["series"]) {
            const Json &x = ColumnOf(data, series, "x"), &y = ColumnOf(data, series, "y");
            int differ = 0;
            for (std::size_t i = 0; i + 1 < x.size(); ++i) {
                const double alpha = 0.9 + 0.1 * double(i) / 2000;
                const double F0 = alpha * (1 + 0.5 * std::pow(1 - alpha, 0.75));
                const double F1 = 27.576937094210385 * alpha * std::pow(1 - alpha, 1.5) *
                                  std::exp(-3.3364392003423804 * std::pow(alpha, 0.25));
                const double tau = 1 - F1 / (1 - F0);
                const double E = F0 + 0.5 * F1 / (1 - 0.5 * tau);
                const bool drawn = std::abs(E) < 2.5;
                differ += y[i].is_null() == drawn ||
                          (drawn && std::abs(y[i].get<double>() - E) > 2e-5 * std::abs(E));
            }
            if (series["label"] == "ρ = 0.5") {
                EXPECT_EQ(series["mark"], "line");
                EXPECT_EQ(differ, 0);
                ++printed;
            } else if (series["label"] == "ρ = 0.5, guarded") {
                EXPECT_EQ(series["mark"], "dashed");
                EXPECT_GT(differ, 5);
                for (const Json& value : y) EXPECT_FALSE(value.is_null());
                ++dashed;
            }
        }
    }
    EXPECT_EQ(printed, 1);
    EXPECT_EQ(dashed, 1);
}

}  // namespace
}  // namespace plumb
