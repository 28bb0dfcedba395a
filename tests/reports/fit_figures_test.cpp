// Every figure of a fit's document, on its page, in JSON, CSV and terminal, is that of the report. The
// report is made (made_report.h) so that no two of its figures are the same.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "made_report.h"
#include "reports/fit_report.h"
#include "reports/render.h"
#include "reports/text.h"
#include "tests/reports/page_reader.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;
using made::MakeFitReport;

/// sqrt of the mean square.
double Quadratic(const std::vector<double>& list) {
    double sum = 0;
    for (const double x : list) sum += x * x;
    return std::sqrt(sum / double(list.size()));
}

class FitFigures : public testing::Test {
  protected:
    const FitReport report = MakeFitReport();
    const doc::Document document = DocumentOf(report);
    const Json json = ToJson(document);
    const std::string html = ToHtml(document);

    /// The page's table of that key.
    Rows Page(const std::string& key) const {
        const std::size_t at = html.find("<table id=\"" + key + "\">");
        EXPECT_NE(at, std::string::npos) << key;
        return TableOf(html.substr(at), {});
    }
    Json RowsOf(const std::string& key) const { return TableIn(json, key)["rows"]; }
};

const Score* HeldOut(const FormulaRecord& record) {
    if (record.held_out) return &record.held_out->pooled;
    return record.fitted ? nullptr : &record.in_sample.pooled;
}

TEST_F(FitFigures, TheSummaryOfScores) {
    const Rows rows = Page("formulas");
    const Json cells = RowsOf("formulas");
    ASSERT_EQ(rows.size(), 1 + report.formulas.size());
    ASSERT_EQ(cells.size(), report.formulas.size());
    for (std::size_t f = 0; f + 1 < rows.size(); ++f) {
        const FormulaRecord& record = report.formulas[f];
        const Score &in_sample = record.in_sample.pooled, &held_out = *HeldOut(record);
        const std::vector<std::string> expected{
            Html(record.name),
            f == 0   ? "recommended"
            : f == 1 ? "published"
                     : "",
            record.formula.model.inputs.alpha ? "α" : "V",
            record.fitted ? std::to_string(record.formula.values.size()) : "–",
            Digits(in_sample.rms),
            Digits(held_out.rms),
            Digits(Quadratic(record.facet_rms)),
            Digits(in_sample.max_abs),
            Digits(held_out.max_abs),
            Count(in_sample.poles),
            Count(in_sample.out_of_range)};
        EXPECT_EQ(rows[f + 1], expected);
        EXPECT_EQ(cells[f]["formula"], record.name);
        EXPECT_EQ(cells[f]["rms"], in_sample.rms);
        EXPECT_EQ(cells[f]["held_out_rms"], held_out.rms);
        EXPECT_EQ(cells[f]["facet_rms"], Quadratic(record.facet_rms));
        EXPECT_EQ(cells[f]["max_abs"], in_sample.max_abs);
        EXPECT_EQ(cells[f]["held_out_max_abs"], held_out.max_abs);
        EXPECT_EQ(cells[f]["poles"], in_sample.poles);
        EXPECT_EQ(cells[f]["out_of_range"], in_sample.out_of_range);
    }
}

// Four tables of one form: a row a formula, a column a map, and all of them; then the floors.
TEST_F(FitFigures, TheScoresOfEveryMap) {
    const auto expect = [&](const std::string& key, const auto& of) {
        const Rows rows = Page("scores_" + key);
        const Json cells = RowsOf("scores");
        ASSERT_EQ(rows.size(), 1 + report.formulas.size()) << key;
        EXPECT_EQ(rows[0].back(), "all ↓");
        for (std::size_t f = 0; f < report.formulas.size(); ++f) {
            const FormulaRecord& record = report.formulas[f];
            ASSERT_EQ(rows[f + 1].size(), 4u);
            for (std::size_t m = 0; m <= 2; ++m) {
                const double x = of(record, m);
                EXPECT_EQ(rows[f + 1][m + 1], Digits(x)) << key;
                const Json& cell = cells[3 * f + m];
                EXPECT_EQ(cell["formula"], record.name);
                EXPECT_EQ(cell["map"], m < 2 ? report.maps[m].name : "all");
                if (std::isnan(x)) {
                    EXPECT_TRUE(cell[key].is_null());
                } else {
                    EXPECT_EQ(cell[key], x);
                }
            }
        }
    };
    const auto score = [](const ScoreRow& row, std::size_t m) {
        return m < 2 ? row.maps[m] : row.pooled;
    };
    expect("rms",
           [&](const FormulaRecord& r, std::size_t m) { return score(r.in_sample, m).rms; });
    expect("held_out_rms", [&](const FormulaRecord& r, std::size_t m) {
        return r.held_out ? score(*r.held_out, m).rms : std::nan("");
    });
    expect("max_abs", [&](const FormulaRecord& r, std::size_t m) {
        return score(r.in_sample, m).max_abs;
    });
    expect("facet_rms", [&](const FormulaRecord& r, std::size_t m) {
        return m < 2 ? r.facet_rms[m] : Quadratic(r.facet_rms);
    });
    const Rows floors = Page("floors");
    ASSERT_EQ(floors.size(), 3u);
    for (std::size_t m = 0; m < 2; ++m) {
        const Json row = RowsOf("floors")[m];
        const Floors& expected = report.floors[m];
        EXPECT_EQ(row["of_uniform_visibility"], expected.of_alpha);
        EXPECT_EQ(row["of_cosine_visibility"], expected.of_V);
        EXPECT_EQ(row["of_both"], expected.of_both);
        EXPECT_EQ(floors[m + 1][1], Digits(expected.of_alpha));
        EXPECT_EQ(floors[m + 1][2], Digits(expected.of_V));
        EXPECT_EQ(floors[m + 1][3], Digits(expected.of_both));
    }
}

struct Known {
    std::string title;
    const LeastSquaresFit& fit;
    const Formula* published;
    double published_rms;
    const BootstrapResult* bootstrap;
};

Known Of(const CurveFit& curve) {
    return {curve.title, curve.fit, curve.published ? &*curve.published : nullptr,
            curve.published_score ? curve.published_score->rms : std::nan(""), nullptr};
}
Known Of(const TotalFit& total) {
    return {total.formula, total.fit, nullptr, std::nan(""),
            total.bootstrap ? &*total.bootstrap : nullptr};
}

/// The fields of a row of constants, every digit; empty = not known.
std::vector<std::string> Fields(const Known& known, std::size_t j) {
    const FittedParameter& p = known.fit.parameters[j];
    const BootstrapInterval* over_maps =
        known.bootstrap ? &known.bootstrap->parameters[j] : nullptr;
    return {Csv(known.title),
            std::to_string(known.fit.samples),
            p.name,
            Exact(p.value),
            p.standard_error ? Exact(*p.standard_error) : "",
            over_maps ? Exact(over_maps->standard_error) : "",
            over_maps ? Exact(over_maps->low) : "",
            over_maps ? Exact(over_maps->high) : "",
            known.published ? Exact(known.published->values[j]) : "",
            Exact(known.fit.rmse),
            Exact(known.published_rms),
            Exact(known.fit.condition),
            known.fit.converged ? "yes" : "no",
            p.at_bound ? "yes" : "no"};
}

std::string Joined(const std::vector<std::string>& fields) {
    std::string line;
    for (const std::string& field : fields) line += (line.empty() ? "" : ",") + field;
    return line;
}

TEST_F(FitFigures, TheCsvOfConstants) {
    std::istringstream lines(ToCsv(ConstantsTable(report)));
    std::string line;
    ASSERT_TRUE(std::getline(lines, line));
    const auto expect = [&](const Known& known) {
        for (std::size_t j = 0; j < known.fit.parameters.size(); ++j) {
            ASSERT_TRUE(std::getline(lines, line));
            EXPECT_EQ(line, Joined(Fields(known, j)));
        }
    };
    for (const CurveFit& curve : report.curves) expect(Of(curve));
    for (const CurveFit& curve : report.bounce_family) expect(Of(curve));
    for (const TotalFit& total : report.totals) expect(Of(total));
    EXPECT_FALSE(std::getline(lines, line));
}

// What the page shows of the same, rounded; columns that hold nothing are not there.
TEST_F(FitFigures, TheConstantsOnThePage) {
    const auto expect = [&](const std::string& key, const std::vector<Known>& fits,
                            bool published, bool bootstrap) {
        const Rows rows = Page(key);
        std::size_t r = 1;
        for (const Known& known : fits) {
            for (std::size_t j = 0; j < known.fit.parameters.size(); ++j, ++r) {
                ASSERT_LT(r, rows.size()) << key;
                const FittedParameter& p = known.fit.parameters[j];
                std::vector<std::string> expected{known.title, p.name, Digits(p.value, 6),
                                                  Digits(*p.standard_error, 2)};
                if (bootstrap) {
                    const BootstrapInterval& over_maps = known.bootstrap->parameters[j];
                    expected.insert(expected.end(),
                                    {Digits(over_maps.standard_error, 2),
                                     Digits(over_maps.low, 4), Digits(over_maps.high, 4)});
                }
                if (published) {
                    expected.push_back(known.published ? Digits(known.published->values[j], 5)
                                                       : "–");
                }
                expected.push_back(Digits(known.fit.rmse));
                if (published) expected.push_back(Digits(known.published_rms));
                expected.insert(expected.end(), {Digits(known.fit.condition, 2), "yes", "no"});
                EXPECT_EQ(rows[r], expected) << key;
            }
        }
        EXPECT_EQ(r, rows.size()) << key;
    };
    std::vector<Known> curves, family;
    for (const CurveFit& curve : report.curves) curves.push_back(Of(curve));
    for (const CurveFit& curve : report.bounce_family) family.push_back(Of(curve));
    expect("curve_constants", curves, true, false);
    expect("bounce_constants", family, false, false);
    expect("recommended_constants", {Of(report.totals[0])}, false, true);
}

TEST_F(FitFigures, HowEachFitWent) {
    const Json rows = RowsOf("fits"), pairs = RowsOf("correlations");
    std::size_t r = 0, c = 0;
    const auto expect = [&](const Known& known, const Json& bounce) {
        const Json& row = rows.at(r++);
        EXPECT_EQ(row["fit"], known.title);
        EXPECT_EQ(row["bounce"], bounce);
        EXPECT_EQ(row["samples"], known.fit.samples);
        EXPECT_EQ(row["rms"], known.fit.rmse);
        EXPECT_EQ(row["max_abs"], known.fit.max_abs);
        EXPECT_EQ(row["chi2_per_dof"], known.fit.chi2_per_dof);
        EXPECT_EQ(row["condition_unscaled"], known.fit.condition_unscaled);
        EXPECT_EQ(row["iterations"], known.fit.iterations);
        EXPECT_EQ(row["starts"], 4);
        EXPECT_EQ(row["starts_agreeing"], 3);
        EXPECT_EQ(row["termination"], "by hand");
        if (known.bootstrap) {
            EXPECT_EQ(row["replicates"], 100);
        } else {
            EXPECT_TRUE(row["replicates"].is_null());
        }
        for (std::size_t i = 0; i < known.fit.parameters.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j, ++c) {
                const Json& pair = pairs.at(c);
                EXPECT_EQ(pair["fit"], known.title);
                EXPECT_EQ(pair["constant"], known.fit.parameters[j].name);
                EXPECT_EQ(pair["other"], known.fit.parameters[i].name);
                EXPECT_EQ(pair["correlation"], i == 1 ? -0.75 : 0.0);
            }
        }
    };
    for (const CurveFit& curve : report.curves) expect(Of(curve), curve.bounce);
    for (const CurveFit& curve : report.bounce_family) expect(Of(curve), curve.bounce);
    for (const TotalFit& total : report.totals) expect(Of(total), nullptr);
    EXPECT_EQ(r, rows.size());
    EXPECT_EQ(c, pairs.size());
    EXPECT_EQ(rows[0]["published_max_abs"], 0.1);
}

TEST_F(FitFigures, TheCsvOfScores) {
    std::istringstream lines(ToCsv(doc::TableOf(document, "scores")));
    std::string line;
    ASSERT_TRUE(std::getline(lines, line));
    for (const FormulaRecord& record : report.formulas) {
        for (std::size_t m = 0; m <= 2; ++m) {
            ASSERT_TRUE(std::getline(lines, line));
            const Score& s = m < 2 ? record.in_sample.maps[m] : record.in_sample.pooled;
            const Score* held_out = !record.held_out ? nullptr
                                    : m < 2          ? &record.held_out->maps[m]
                                                     : &record.held_out->pooled;
            EXPECT_EQ(line,
                      Joined({Csv(record.name), Csv(m < 2 ? report.maps[m].name : "all"),
                              record.fitted ? "yes" : "no",
                              record.formula.model.inputs.alpha ? "alpha" : "V",
                              std::to_string(s.samples), Exact(s.rms), Exact(s.max_abs),
                              std::to_string(s.poles), std::to_string(s.out_of_range),
                              held_out ? Exact(held_out->rms) : "",
                              held_out ? Exact(held_out->max_abs) : "",
                              Exact(m < 2 ? record.facet_rms[m] : Quadratic(record.facet_rms)),
                              held_out ? std::to_string(held_out->samples) : "",
                              held_out ? std::to_string(held_out->poles) : "",
                              held_out ? std::to_string(held_out->out_of_range) : ""}));
        }
    }
    EXPECT_FALSE(std::getline(lines, line));
}

// The lines of the terminal's table of formulas, put together where it is broken.
TEST_F(FitFigures, TheTerminal) {
    const std::string terminal = ToTerminal(document);
    const std::size_t begin = terminal.find("Every formula on every map"),
                      end = terminal.find("The paper's curves", begin);
    for (const FormulaRecord& record : report.formulas) {
        std::istringstream in(terminal.substr(begin, end - begin));
        std::string line, all;
        while (std::getline(in, line))
            if (line.starts_with("  " + record.name + "  ")) all += line + " ";
        const Score& s = record.in_sample.pooled;
        for (const double x :
             {s.rms, s.max_abs, HeldOut(record)->rms, Quadratic(record.facet_rms)})
            EXPECT_THAT(all, testing::HasSubstr(" " + Digits(x) + " ")) << record.name;
        EXPECT_THAT(all, testing::HasSubstr(" " + std::to_string(s.poles) + " "));
    }
}

TEST_F(FitFigures, ErrorAgainstTime) {
    const std::vector<ConvergencePoint>& points = report.convergence->points;
    const Rows rows = Page("convergence");
    const Json cells = RowsOf("convergence");
    ASSERT_EQ(rows.size(), points.size() + 1);
    const Json data = PlotDataOf(html);
    std::vector<double> seconds, rms_V, rms_E, counts;
    for (std::size_t p = 0; p < points.size(); ++p) {
        const ConvergencePoint& point = points[p];
        EXPECT_EQ(rows[p + 1],
                  (std::vector<std::string>{
                      point.method, Count(point.per_facet), Digits(point.seconds.value),
                      Digits(point.rms_V), Digits(point.max_abs_V), Digits(point.rms_E_half)}));
        EXPECT_EQ(cells[p]["time_s"]["value"], point.seconds.value);
        EXPECT_EQ(cells[p]["rms_v"], point.rms_V);
        EXPECT_EQ(cells[p]["max_abs_v"], point.max_abs_V);
        EXPECT_EQ(cells[p]["rms_e_half"], point.rms_E_half);
        if (point.method != "rays") continue;
        seconds.push_back(point.seconds.value);
        counts.push_back(point.per_facet);
        rms_V.push_back(point.rms_V);
        rms_E.push_back(point.rms_E_half);
    }
    // The error of 1024 rays, 0.01 after 4 s; slices fall from 0.02 (0.25 s) to 0.005 (1 s), so
    // they pass it half-way on logarithmic axes, at 0.5 s. Rays never reach that of 32 slices.
    const Json same = RowsOf("same_error");
    ASSERT_EQ(same.size(), 1u);
    EXPECT_EQ(same[0]["method"], "rays");
    EXPECT_EQ(same[0]["per_facet"], 1024);
    EXPECT_EQ(same[0]["rms_v"], 0.01);
    EXPECT_EQ(same[0]["time_s"], 4);
    EXPECT_EQ(same[0]["other"], "slices");
    EXPECT_NEAR(same[0]["reached_s"].get<double>(), 0.5, 1e-12);
    EXPECT_NEAR(same[0]["times_faster"].get<double>(), 8, 1e-12);
    const Json by_time{{"against", "simulation time"}},
        by_count{{"against", "rays or slices of a facet"}};
    EXPECT_EQ(SeriesOf(data, "time-visibility", by_time, "rays", "x"), seconds);
    EXPECT_EQ(SeriesOf(data, "time-visibility", by_count, "rays", "x"), counts);
    EXPECT_EQ(SeriesOf(data, "time-visibility", by_time, "rays", "y"), rms_V);
    EXPECT_EQ(SeriesOf(data, "time-total", by_time, "rays", "y"), rms_E);
}

/// A number of every bin that holds a facet.
template <class Get>
std::vector<double> List(const BounceHistogram& histogram, Get&& get) {
    std::vector<double> list;
    for (const BounceBin& bin : histogram.bins)
        if (bin.count > 0) list.push_back(get(bin));
    return list;
}
std::vector<double> Alphas(const BounceHistogram& histogram) {
    return List(histogram, [](const BounceBin& bin) { return bin.alpha; });
}
std::vector<double> Bounce(const BounceHistogram& histogram, std::size_t k,
                           double Spread::*value = &Spread::mean) {
    return List(histogram, [=](const BounceBin& bin) { return bin.bounce[k].*value; });
}

double Constant(const Formula& formula, const std::string& name) {
    for (std::size_t j = 0; j < formula.values.size(); ++j)
        if (formula.model.parameters[j].name == name) return formula.values[j];
    return std::nan("");
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
        const BounceHistogram& histogram = report.maps[m].over_alpha;
        const Json keys{{"map", report.maps[m].name}};
        const std::vector<double> alpha = Alphas(histogram);
        for (const std::size_t k : {0u, 1u}) {
            const std::string plot = "curve-" + std::to_string(k);
            ExpectNear(SeriesOf(data, plot, keys, "mean", "x"), alpha, plot);
            ExpectNear(SeriesOf(data, plot, keys, "mean", "y"),
                       Bounce(histogram, k, &Spread::mean), plot);
            ExpectNear(SeriesOf(data, plot, keys, "median", "y"),
                       Bounce(histogram, k, &Spread::p50), plot);
            ExpectNear(SeriesOf(data, plot, keys, "5 to 95 % of facets", "y"),
                       Bounce(histogram, k, &Spread::p05), plot);
            ExpectNear(SeriesOf(data, plot, keys, "5 to 95 % of facets", "high"),
                       Bounce(histogram, k, &Spread::p95), plot);
            const CurveFit& curve = report.curves[k];
            for (const bool published : {false, true}) {
                const Formula& c = published ? *curve.published : curve.fitted;
                std::vector<double> y;
                for (const double x : alpha)
                    y.push_back(
                        k == 0 ? x * (1 + Constant(c, "a") * std::pow(1 - x, Constant(c, "p")))
                               : Constant(c, "A") * x * std::pow(1 - x, 1.5) *
                                     std::exp(-Constant(c, "B") * std::pow(x, 0.25)));
                const std::string label = published ? "published"
                                          : k       ? "F1, refitted"
                                                    : "F0, refitted";
                ExpectNear(SeriesOf(data, plot + "-residual", keys, label, "y"), y, label);
                ExpectNear(SeriesOf(data, plot + "-residual", keys, label, "minus"),
                           Bounce(histogram, k, &Spread::mean), label);
                // The line itself, at 201 even steps: its middle and its third quarter.
                const std::vector<double> line = SeriesOf(data, plot, keys, label, "y");
                ASSERT_EQ(line.size(), 201u);
                const double x = 0.75;
                const double at =
                    k == 0 ? x * (1 + Constant(c, "a") * std::pow(1 - x, Constant(c, "p")))
                           : Constant(c, "A") * x * std::pow(1 - x, 1.5) *
                                 std::exp(-Constant(c, "B") * std::pow(x, 0.25));
                EXPECT_NEAR(line[150], at, 1e-5 * at) << label;
            }
        }
        for (const std::size_t k : {1u, 2u, 3u}) {
            const std::string label = "bounce " + std::to_string(k);
            ExpectNear(SeriesOf(data, "family-residual", keys, label, "minus"),
                       Bounce(histogram, k), label);
            const Formula& c = report.bounce_family[k - 1].fitted;
            std::vector<double> y;
            for (const double x : alpha)
                y.push_back(Constant(c, "A") * x * std::pow(1 - x, 1.5) *
                            std::exp(-Constant(c, "B") * std::pow(x, Constant(c, "C"))));
            ExpectNear(SeriesOf(data, "family", keys, label, "y", "line"), y, label);
        }
        std::vector<double> sum(alpha.size());
        for (std::size_t k = 0; k <= 3; ++k) {
            for (std::size_t b = 0; b < sum.size(); ++b) sum[b] += Bounce(histogram, k)[b];
            ExpectNear(SeriesOf(data, "family-sum", keys,
                                k == 0 ? "direct" : "to bounce " + std::to_string(k), "y"),
                       sum, "family-sum");
        }
    }
}

// The recommended total, its constants put into the escape family here, over either abscissa.
TEST_F(FitFigures, TheTotalAndItsData) {
    const Json data = PlotDataOf(html);
    const Formula& c = report.formulas[0].formula;
    for (std::size_t m = 0; m < 2; ++m) {
        for (const bool over_V : {true, false}) {
            const BounceHistogram& histogram =
                over_V ? report.maps[m].over_V : report.maps[m].over_alpha;
            const Json keys{{"map", report.maps[m].name}, {"over", over_V ? "V" : "α"}};
            const std::vector<double> V =
                List(histogram, [](const BounceBin& bin) { return bin.V; });
            const std::vector<double> x = over_V ? V : Alphas(histogram);
            for (const std::size_t r : {0u, 1u, 2u}) {
                const double rho = histogram.albedos[r];
                const std::string label = "ρ = " + Exact(rho);
                std::vector<double> y;
                for (const double v : V) {
                    const double g =
                        std::min(1.0, Constant(c, "a") * std::pow(v, Constant(c, "b")));
                    y.push_back(rho < 1 ? v + (1 - v) * rho * g / (1 - rho * (1 - g)) : 1);
                }
                ExpectNear(SeriesOf(data, "total-recommended", keys, label, "x"), x, label);
                ExpectNear(SeriesOf(data, "total-recommended", keys, label, "y"), y, label);
                ExpectNear(
                    SeriesOf(data, "total-recommended-residual", keys, label, "minus"),
                    List(histogram, [r](const BounceBin& bin) { return bin.total[r].mean; }),
                    label);
            }
        }
    }
}

// All maps together: every map the same say, w = n_bin / n_map.
TEST_F(FitFigures, PooledBinsWeighEveryMapAlike) {
    const Json data = PlotDataOf(html);
    const Json keys{{"map", "all maps"}};
    const BounceHistogram &one = report.maps[0].over_alpha, &two = report.maps[1].over_alpha;
    const auto count = [](const BounceBin& bin) { return double(bin.count); };
    double n_1 = 0, n_2 = 0;
    for (const double n : List(one, count)) n_1 += n;
    for (const double n : List(two, count)) n_2 += n;
    std::vector<double> x, y;
    for (std::size_t b = 0; b < List(one, count).size(); ++b) {
        const double w_1 = List(one, count)[b] / n_1, w_2 = List(two, count)[b] / n_2;
        const auto mean = [&](double first, double second) {
            return (w_1 * first + w_2 * second) / (w_1 + w_2);
        };
        x.push_back(mean(Alphas(one)[b], Alphas(two)[b]));
        y.push_back(mean(Bounce(one, 1)[b], Bounce(two, 1)[b]));
    }
    ExpectNear(SeriesOf(data, "curve-1-residual", keys, "F1, refitted", "x"), x, "pooled x");
    ExpectNear(SeriesOf(data, "curve-1-residual", keys, "F1, refitted", "minus"), y,
               "pooled y");
}

TEST_F(FitFigures, ProvenanceAndFaults) {
    const Rows maps = Page("maps");
    const Json cells = RowsOf("maps");
    ASSERT_EQ(maps.size(), 3u);
    for (std::size_t m = 0; m < 2; ++m) {
        const MapSource& map = report.provenance.maps[m];
        EXPECT_EQ(maps[m + 1][2], std::to_string(map.width_texels));
        EXPECT_EQ(maps[m + 1][3], std::to_string(map.height_texels));
        EXPECT_EQ(maps[m + 1][4], Digits(map.spacing_x_m));
        EXPECT_EQ(maps[m + 1][5], Digits(map.spacing_y_m));
        EXPECT_EQ(maps[m + 1][6], Digits(map.amplitude_m));
        EXPECT_EQ(maps[m + 1][7], map.boundary);
        EXPECT_EQ(cells[m]["spacing_y_m"], map.spacing_y_m);
        EXPECT_EQ(json["provenance"]["inputs"][m]["sha256"], map.sha256);
        EXPECT_EQ(json["provenance"]["inputs"][m]["name"], map.name);
    }
    EXPECT_THAT(html, testing::HasSubstr(", seed 7."));
    EXPECT_EQ(FactIn(json, "method"), "slices");
    EXPECT_EQ(FactIn(json, "per_facet"), 32);
    EXPECT_EQ(FactIn(json, "cut_texels"), 1.5);
    EXPECT_EQ(FactIn(json, "most_pieces"), 8);
    EXPECT_EQ(FactIn(json, "bounces"), 3);
    EXPECT_EQ(FactIn(json, "bins"), 4);
    EXPECT_EQ(TableIn(json, "albedos")["values"]["albedo"].dump(), "[0.0,0.5,1.0]");
    const Rows faults = Page("faults");
    ASSERT_EQ(faults.size(), 3u);
    EXPECT_EQ(faults[1], (std::vector<std::string>{"published", "E(ρ) is finite", "0.500",
                                                   "0.970264", "0.970264", "–", "–"}));
    EXPECT_EQ(faults[2], (std::vector<std::string>{"published", "F₀ ≤ 1", "–", "0.949253",
                                                   "1.00000", "0.00600", "0.9830"}));
}

}  // namespace
}  // namespace plumb
