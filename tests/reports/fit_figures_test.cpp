// Every figure of a fit report's page, CSV and terminal is that of its JSON. The report is made
// (made_report.h) so that no two of its figures are the same.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "made_report.h"
#include "reports/fit_report.h"
#include "reports/text.h"
#include "tests/reports/page_reader.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;
using made::MakeFitReport;

double Number(const Json& json) {
    return json.is_null() ? std::nan("") : json.get<double>();
}

/// sqrt of the mean square.
double Quadratic(const Json& list) {
    double sum = 0;
    for (const Json& x : list) sum += Number(x) * Number(x);
    return std::sqrt(sum / double(list.size()));
}

class FitFigures : public testing::Test {
  protected:
    const FitReport report = MakeFitReport();
    const Json json = ToJson(report);
    const std::string html = ToHtml(report);
};

/// The JSON of a score that was held out, or of one that never saw a map.
Json HeldOut(const Json& formula) {
    if (!formula["held_out"].is_null()) return formula["held_out"];
    return formula["fitted"].get<bool>() ? Json() : formula["in_sample"];
}

TEST_F(FitFigures, TheSummaryOfScores) {
    const Rows rows = TableOf(html, {"formula", "reads", "constants fitted", "RMS [–]"});
    ASSERT_EQ(rows.size(), 1 + json["formulas"].size());
    for (std::size_t f = 0; f + 1 < rows.size(); ++f) {
        const Json& formula = json["formulas"][f];
        const Json in_sample = formula["in_sample"]["all"], held_out = HeldOut(formula)["all"];
        const std::vector<std::string> expected{
            rows[f + 1][0],
            formula["formula"]["inputs"][0] == "uniform_visibility" ? "α" : "V",
            formula["fitted"].get<bool>()
                ? std::to_string(formula["formula"]["constants"].size())
                : "–",
            Digits(Number(in_sample["rms"])),
            Digits(Number(held_out["rms"])),
            Digits(Quadratic(formula["facet_rms"])),
            Digits(Number(in_sample["max_abs"])),
            Digits(Number(held_out["max_abs"])),
            Count(in_sample["poles"].get<int>()),
            Count(in_sample["out_of_range"].get<int>())};
        EXPECT_EQ(rows[f + 1], expected);
        EXPECT_EQ(rows[f + 1][0], Html(formula["name"].get<std::string>()));
    }
}

// Four tables of one form, one behind the other: RMS, held out, worst, facets with floors.
TEST_F(FitFigures, TheScoresOfEveryMap) {
    std::size_t at = html.find("<h3>Map by map</h3>");
    const auto next = [&] {
        at = html.find("<div class=\"tab\">", at + 1);
        return TableOf(html.substr(at), {"formula"});
    };
    const auto expect = [&](const Rows& rows, const auto& of) {
        ASSERT_GE(rows.size(), 1 + json["formulas"].size());
        for (std::size_t f = 0; f < json["formulas"].size(); ++f) {
            for (std::size_t m = 0; m < 2; ++m)
                EXPECT_EQ(rows[f + 1].at(m + 1), Digits(of(json["formulas"][f], m)));
        }
    };
    expect(next(), [](const Json& formula, std::size_t m) {
        return Number(formula["in_sample"]["maps"][m]["rms"]);
    });
    expect(next(), [](const Json& formula, std::size_t m) {
        return Number(HeldOut(formula)["maps"][m]["rms"]);
    });
    expect(next(), [](const Json& formula, std::size_t m) {
        return Number(formula["in_sample"]["maps"][m]["max_abs"]);
    });
    const Rows facets = next();
    expect(facets,
           [](const Json& formula, std::size_t m) { return Number(formula["facet_rms"][m]); });
    const std::size_t n = json["formulas"].size();
    ASSERT_EQ(facets.size(), n + 4);
    for (std::size_t m = 0; m < 2; ++m) {
        const Json& floors = json["floors"][m];
        EXPECT_EQ(facets[n + 1][m + 1], Digits(Number(floors["of_uniform_visibility"])));
        EXPECT_EQ(facets[n + 2][m + 1], Digits(Number(floors["of_cosine_visibility"])));
        EXPECT_EQ(facets[n + 3][m + 1], Digits(Number(floors["of_both"])));
    }
}

void ExpectCurves(const Rows& rows, const Json& curves) {
    std::size_t r = 1;
    for (const Json& curve : curves) {
        const Json& fit = curve["fit"];
        for (std::size_t j = 0; j < fit["parameters"].size(); ++j, ++r) {
            const Json& parameter = fit["parameters"][j];
            ASSERT_LT(r, rows.size());
            const std::string name = parameter["name"];
            EXPECT_EQ(rows[r][1], name);
            EXPECT_EQ(rows[r][2], WithError(Number(parameter["value"]),
                                            Number(parameter["standard_error"])));
            EXPECT_EQ(rows[r][3],
                      curve.contains("published")
                          ? Exact(Rounded(Number(curve["published"]["constants"][name]), 5))
                          : "–");
            if (j > 0) continue;
            EXPECT_EQ(rows[r][0], curve["title"]);
            EXPECT_EQ(rows[r][4], Digits(Number(fit["rms"])));
            EXPECT_EQ(rows[r][5], Digits(Number(fit["max_abs"])));
            EXPECT_EQ(rows[r][6], curve.contains("published_score")
                                      ? Digits(Number(curve["published_score"]["rms"]))
                                      : "–");
            EXPECT_EQ(rows[r][7], Digits(Number(fit["condition"]), 2));
        }
    }
    EXPECT_EQ(r, rows.size());
}

TEST_F(FitFigures, TheConstantsOfCurves) {
    ExpectCurves(TableOf(html, {"fit", "constant", "value ± standard error"}), json["curves"]);
    const std::size_t family = html.find("<summary>Constants of every bounce</summary>");
    ExpectCurves(TableOf(html.substr(family), {"fit", "constant"}), json["bounce_family"]);
}

TEST_F(FitFigures, TheConstantsOfTheTotal) {
    const Rows rows = TableOf(html, {"constant", "value [–]"});
    const Json& total = json["totals"][0];
    ASSERT_EQ(rows.size(), 3u);
    for (std::size_t j = 0; j < 2; ++j) {
        const Json &parameter = total["fit"]["parameters"][j],
                   &interval = total["bootstrap_over_maps"]["parameters"][j];
        EXPECT_EQ(rows[j + 1][0], parameter["name"]);
        EXPECT_EQ(rows[j + 1][1], Digits(Number(parameter["value"]), 6));
        EXPECT_EQ(rows[j + 1][2], Digits(Number(parameter["standard_error"]), 2));
        EXPECT_EQ(rows[j + 1][3], Digits(Number(interval["standard_error"]), 2));
        EXPECT_EQ(rows[j + 1][4], Digits(Number(interval["low"]), 4) + " … " +
                                      Digits(Number(interval["high"]), 4));
    }
    EXPECT_NE(html.find(Count(total["fit"]["samples"].get<int>()) + " samples, RMS " +
                        Digits(Number(total["fit"]["rms"])) + ", worst " +
                        Digits(Number(total["fit"]["max_abs"])) + ", condition number " +
                        Digits(Number(total["fit"]["condition"]), 2) + ", 3 of 4 starts agree"),
              std::string::npos);
}

std::vector<std::string> Cells(const std::string& line) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (const char c : line) {
        if (c == '"') quoted = !quoted;
        if (c == ',' && !quoted)
            cells.emplace_back();
        else
            cells.back() += c;
    }
    return cells;
}

std::vector<std::vector<std::string>> CsvOf(void (*write)(std::ostream&, const FitReport&),
                                            const FitReport& report) {
    std::ostringstream out;
    write(out, report);
    std::istringstream in(out.str());
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(in, line);) rows.push_back(Cells(line));
    return rows;
}

TEST_F(FitFigures, TheCsvOfScores) {
    const auto rows = CsvOf(&WriteScoresCsv, report);
    std::size_t r = 1;
    for (const Json& formula : json["formulas"]) {
        for (std::size_t m = 0; m <= 2; ++m, ++r) {
            const bool all = m == 2;
            const Json& in_sample =
                all ? formula["in_sample"]["all"] : formula["in_sample"]["maps"][m];
            const Json held_out = formula["held_out"].is_null() ? Json()
                                  : all                         ? formula["held_out"]["all"]
                                        : formula["held_out"]["maps"][m];
            const auto& row = rows.at(r);
            EXPECT_EQ(row[4], std::to_string(in_sample["samples"].get<int>()));
            EXPECT_EQ(row[5], Exact(Number(in_sample["rms"])));
            EXPECT_EQ(row[6], Exact(Number(in_sample["max_abs"])));
            EXPECT_EQ(row[7], std::to_string(in_sample["poles"].get<int>()));
            EXPECT_EQ(row[8], std::to_string(in_sample["out_of_range"].get<int>()));
            EXPECT_EQ(row[9], held_out.is_null() ? "" : Exact(Number(held_out["rms"])));
            EXPECT_EQ(row[10], held_out.is_null() ? "" : Exact(Number(held_out["max_abs"])));
            EXPECT_EQ(row[11], Exact(all ? Quadratic(formula["facet_rms"])
                                         : Number(formula["facet_rms"][m])));
        }
    }
    EXPECT_EQ(r, rows.size());
}

TEST_F(FitFigures, TheCsvOfConstants) {
    const auto rows = CsvOf(&WriteConstantsCsv, report);
    std::size_t r = 1;
    const auto expect = [&](const std::string& name, const Json& fit, const Json& published,
                            const Json& published_rms, const Json& intervals) {
        for (std::size_t j = 0; j < fit["parameters"].size(); ++j, ++r) {
            const Json& parameter = fit["parameters"][j];
            const std::string constant = parameter["name"];
            const auto& row = rows.at(r);
            if (name.find(',') == std::string::npos) {
                EXPECT_EQ(row[0], name);
            }
            EXPECT_EQ(row[1], std::to_string(fit["samples"].get<int>()));
            EXPECT_EQ(row[2], constant);
            EXPECT_EQ(row[3], Exact(Number(parameter["value"])));
            EXPECT_EQ(row[4], Exact(Number(parameter["standard_error"])));
            const auto of = [&](const char* key) {
                return intervals.is_null() ? "" : Exact(Number(intervals[j][key]));
            };
            EXPECT_EQ(row[5], of("standard_error"));
            EXPECT_EQ(row[6], of("low"));
            EXPECT_EQ(row[7], of("high"));
            EXPECT_EQ(row[8], published.is_null() ? "" : Exact(Number(published[constant])));
            EXPECT_EQ(row[9], Exact(Number(fit["rms"])));
            EXPECT_EQ(row[10], published_rms.is_null() ? "" : Exact(Number(published_rms)));
            EXPECT_EQ(row[11], Exact(Number(fit["condition"])));
        }
    };
    for (const char* list : {"curves", "bounce_family"}) {
        for (const Json& curve : json[list]) {
            const bool known = curve.contains("published");
            expect(curve["title"], curve["fit"],
                   known ? curve["published"]["constants"] : Json(),
                   known ? curve["published_score"]["rms"] : Json(), Json());
        }
    }
    for (const Json& total : json["totals"])
        expect(total["formula"], total["fit"], Json(), Json(),
               total["bootstrap_over_maps"]["parameters"]);
    EXPECT_EQ(r, rows.size());
}

TEST_F(FitFigures, TheTerminal) {
    std::ostringstream out;
    WriteTable(out, report);
    std::istringstream in(out.str());
    std::string line;
    while (std::getline(in, line) && !line.starts_with("formula ")) {
    }
    for (const Json& formula : json["formulas"]) {
        ASSERT_TRUE(std::getline(in, line));
        const Json& all = formula["in_sample"]["all"];
        const std::string held_out = formula["held_out"].is_null()
                                         ? "–"
                                         : Digits(Number(formula["held_out"]["all"]["rms"]));
        // From the right: poles, facets, held out, max, RMS.
        std::istringstream words(line.substr(56));
        std::vector<std::string> cells;
        for (std::string word; words >> word;) cells.push_back(word);
        EXPECT_EQ(cells, (std::vector<std::string>{Digits(Number(all["rms"])),
                                                   Digits(Number(all["max_abs"])), held_out,
                                                   Digits(Quadratic(formula["facet_rms"])),
                                                   std::to_string(all["poles"].get<int>())}));
    }
}

TEST_F(FitFigures, ErrorAgainstTime) {
    const Rows rows = TableOf(html, {"method", "a facet", "time [s]"});
    const Json& points = json["convergence"]["points"];
    ASSERT_EQ(rows.size(), points.size() + 1);
    const Json data = PlotDataOf(html);
    std::vector<double> seconds, rms_V, rms_E, counts;
    for (std::size_t p = 0; p < points.size(); ++p) {
        const Json& point = points[p];
        EXPECT_EQ(rows[p + 1], (std::vector<std::string>{
                                   point["method"], Count(point["per_facet"].get<int>()),
                                   Digits(Number(point["seconds"])),
                                   Digits(Number(point["rms_cosine_visibility"])),
                                   Digits(Number(point["max_abs_cosine_visibility"])),
                                   Digits(Number(point["rms_total_half_albedo"]))}));
        if (point["method"] != "rays") continue;
        seconds.push_back(Number(point["seconds"]));
        counts.push_back(Number(point["per_facet"]));
        rms_V.push_back(Number(point["rms_cosine_visibility"]));
        rms_E.push_back(Number(point["rms_total_half_albedo"]));
    }
    const Json by_time{{"against", "simulation time"}},
        by_count{{"against", "rays or slices of a facet"}};
    EXPECT_EQ(SeriesOf(data, "time-visibility", by_time, "rays", "x"), seconds);
    EXPECT_EQ(SeriesOf(data, "time-visibility", by_count, "rays", "x"), counts);
    EXPECT_EQ(SeriesOf(data, "time-visibility", by_time, "rays", "y"), rms_V);
    EXPECT_EQ(SeriesOf(data, "time-total", by_time, "rays", "y"), rms_E);
}

/// Bins that hold a facet, as the JSON lists them.
std::vector<double> List(const Json& list) {
    return list.get<std::vector<double>>();
}

void ExpectNear(const std::vector<double>& drawn, const std::vector<double>& expected,
                const std::string& what) {
    ASSERT_EQ(drawn.size(), expected.size()) << what;
    for (std::size_t i = 0; i < drawn.size(); ++i)  // Plots carry six digits.
        EXPECT_NEAR(drawn[i], expected[i], 1e-5 * std::abs(expected[i])) << what;
}

// Curves: the constants of the JSON put into [Mayaux18 eq. 7] and [Mayaux18 eq. 11] here, beside
// the means of the map chosen; a residual is the one minus the other.
TEST_F(FitFigures, TheCurvesAndTheirData) {
    const Json data = PlotDataOf(html);
    for (std::size_t m = 0; m < 2; ++m) {
        const Json& histogram = json["maps"][m]["over_uniform_visibility"];
        const Json keys{{"map", json["maps"][m]["name"]}};
        const std::vector<double> alpha = List(histogram["mean_uniform_visibility"]);
        for (const std::size_t k : {0u, 1u}) {
            const std::string plot = "curve-" + std::to_string(k);
            const Json& spread = histogram["bounces"][k];
            ExpectNear(SeriesOf(data, plot, keys, "mean", "x"), alpha, plot);
            ExpectNear(SeriesOf(data, plot, keys, "mean", "y"), List(spread["mean"]), plot);
            ExpectNear(SeriesOf(data, plot, keys, "median", "y"), List(spread["p50"]), plot);
            ExpectNear(SeriesOf(data, plot, keys, "5 to 95 % of facets", "y"),
                       List(spread["p05"]), plot);
            ExpectNear(SeriesOf(data, plot, keys, "5 to 95 % of facets", "high"),
                       List(spread["p95"]), plot);
            const Json& curve = json["curves"][k];
            for (const bool published : {false, true}) {
                const Json& c =
                    published ? curve["published"]["constants"] : curve["formula"]["constants"];
                std::vector<double> y;
                for (const double x : alpha)
                    y.push_back(k == 0
                                    ? x * (1 + Number(c["a"]) * std::pow(1 - x, Number(c["p"])))
                                    : Number(c["A"]) * x * std::pow(1 - x, 1.5) *
                                          std::exp(-Number(c["B"]) * std::pow(x, 0.25)));
                const std::string label = published ? "published"
                                          : k       ? "F1, refitted"
                                                    : "F0, refitted";
                ExpectNear(SeriesOf(data, plot + "-residual", keys, label, "y"), y, label);
                ExpectNear(SeriesOf(data, plot + "-residual", keys, label, "minus"),
                           List(spread["mean"]), label);
                // The line itself, at 201 even steps: its middle and its third quarter.
                const std::vector<double> line = SeriesOf(data, plot, keys, label, "y");
                ASSERT_EQ(line.size(), 201u);
                const double x = 0.75;
                const double at =
                    k == 0 ? x * (1 + Number(c["a"]) * std::pow(1 - x, Number(c["p"])))
                           : Number(c["A"]) * x * std::pow(1 - x, 1.5) *
                                 std::exp(-Number(c["B"]) * std::pow(x, 0.25));
                EXPECT_NEAR(line[150], at, 1e-5 * at) << label;
            }
        }
        for (const std::size_t k : {1u, 2u, 3u}) {
            const std::string label = "bounce " + std::to_string(k);
            ExpectNear(SeriesOf(data, "family-residual", keys, label, "minus"),
                       List(histogram["bounces"][k]["mean"]), label);
            const Json& c = json["bounce_family"][k - 1]["formula"]["constants"];
            std::vector<double> y;
            for (const double x : alpha)
                y.push_back(Number(c["A"]) * x * std::pow(1 - x, 1.5) *
                            std::exp(-Number(c["B"]) * std::pow(x, Number(c["C"]))));
            ExpectNear(SeriesOf(data, "family", keys, label, "y", "line"), y, label);
        }
        std::vector<double> sum(alpha.size());
        for (std::size_t k = 0; k <= 3; ++k) {
            for (std::size_t b = 0; b < sum.size(); ++b)
                sum[b] += Number(histogram["bounces"][k]["mean"][b]);
            ExpectNear(SeriesOf(data, "family-sum", keys,
                                k == 0 ? "direct" : "to bounce " + std::to_string(k), "y"),
                       sum, "family-sum");
        }
    }
}

// The recommended total, its constants put into the escape family here, over either abscissa.
TEST_F(FitFigures, TheTotalAndItsData) {
    const Json data = PlotDataOf(html);
    const Json& c = json["formulas"][0]["formula"]["constants"];
    for (std::size_t m = 0; m < 2; ++m) {
        for (const bool over_V : {true, false}) {
            const Json& histogram =
                json["maps"][m][over_V ? "over_cosine_visibility" : "over_uniform_visibility"];
            const Json keys{{"map", json["maps"][m]["name"]}, {"over", over_V ? "V" : "α"}};
            const std::vector<double> V = List(histogram["mean_cosine_visibility"]);
            const std::vector<double> x =
                List(histogram[over_V ? "mean_cosine_visibility" : "mean_uniform_visibility"]);
            for (const std::size_t r : {0u, 1u, 2u}) {
                const double rho = Number(histogram["albedos"][r]);
                const std::string label = "ρ = " + Exact(rho);
                std::vector<double> y;
                for (const double v : V) {
                    const double g =
                        std::min(1.0, Number(c["a"]) * std::pow(v, Number(c["b"])));
                    y.push_back(rho < 1 ? v + (1 - v) * rho * g / (1 - rho * (1 - g)) : 1);
                }
                ExpectNear(SeriesOf(data, "total-recommended", keys, label, "x"), x, label);
                ExpectNear(SeriesOf(data, "total-recommended", keys, label, "y"), y, label);
                ExpectNear(SeriesOf(data, "total-recommended-residual", keys, label, "minus"),
                           List(histogram["totals"][r]["mean"]), label);
            }
        }
    }
}

// All maps together: every map the same say, w = n_bin / n_map.
TEST_F(FitFigures, PooledBinsWeighEveryMapAlike) {
    const Json data = PlotDataOf(html);
    const Json keys{{"map", "all maps"}};
    const Json *one = &json["maps"][0]["over_uniform_visibility"],
               *two = &json["maps"][1]["over_uniform_visibility"];
    double n_1 = 0, n_2 = 0;
    for (const double n : List((*one)["count"])) n_1 += n;
    for (const double n : List((*two)["count"])) n_2 += n;
    std::vector<double> x, y;
    for (std::size_t b = 0; b < (*one)["count"].size(); ++b) {
        const double w_1 = Number((*one)["count"][b]) / n_1,
                     w_2 = Number((*two)["count"][b]) / n_2;
        const auto mean = [&](const Json& first, const Json& second) {
            return (w_1 * Number(first[b]) + w_2 * Number(second[b])) / (w_1 + w_2);
        };
        x.push_back(mean((*one)["mean_uniform_visibility"], (*two)["mean_uniform_visibility"]));
        y.push_back(mean((*one)["bounces"][1]["mean"], (*two)["bounces"][1]["mean"]));
    }
    ExpectNear(SeriesOf(data, "curve-1-residual", keys, "F1, refitted", "x"), x, "pooled x");
    ExpectNear(SeriesOf(data, "curve-1-residual", keys, "F1, refitted", "minus"), y,
               "pooled y");
}

TEST_F(FitFigures, ProvenanceAndFaults) {
    const Rows maps = TableOf(html, {"map", "file", "texels"});
    ASSERT_EQ(maps.size(), 3u);
    for (std::size_t m = 0; m < 2; ++m) {
        const Json& map = json["provenance"]["maps"][m];
        const auto number = [&](const char* key) { return Number(map[key]); };
        EXPECT_EQ(maps[m + 1][2], std::to_string(map["width_texels"].get<int>()) + " × " +
                                      std::to_string(map["height_texels"].get<int>()));
        EXPECT_EQ(maps[m + 1][3],
                  Digits(number("spacing_x_m")) + " × " + Digits(number("spacing_y_m")));
        EXPECT_EQ(maps[m + 1][4], Digits(number("amplitude_m")));
        EXPECT_EQ(maps[m + 1][5], map["boundary"]);
        EXPECT_EQ(maps[m + 1][8], map["sha256"]);
    }
    EXPECT_NE(html.find("32 slices a facet, seed 7; 3 bounces; 4 bins; 3 albedos from " +
                        Digits(0, 2) + " to " + Digits(1, 2)),
              std::string::npos);
    const Rows faults = TableOf(html, {"constants", "rule", "broken at"});
    ASSERT_EQ(faults.size(), 3u);
    EXPECT_EQ(faults[1][2], "ρ = 0.5, α = 0.970264");
    EXPECT_EQ(faults[2][2], "α in (0.949253, 1.00000)");
    EXPECT_EQ(faults[2][3], "by 0.00600 at α = 0.9830");
}

}  // namespace
}  // namespace plumb
