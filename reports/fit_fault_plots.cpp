// Where constants break the formula in print: drawn near alpha = 1, and listed.
#include "reports/fit_plots.h"
#include "reports/fit_report_page.h"
#include "reports/fit_report_parts.h"
#include "reports/page.h"
#include "reports/surface_html.h"
#include "reports/text.h"

namespace plumb::page {
namespace {

using parts::Find;

/// The formula as printed near its poles, and under its guard. Beyond the frame a line is broken
/// off, so that none joins the two sides of a pole.
Plot PolePlot(const Formula& printed, const Formula* guarded, PlotSheet& sheet) {
    constexpr double kFrom = 0.9, kCut = 2.5;
    constexpr int kPoints = 2001;
    std::vector<double> alphas;
    for (int i = 0; i < kPoints; ++i)
        alphas.push_back(kFrom + (1 - kFrom) * i / double(kPoints - 1));
    const Column x = sheet.Add(alphas);
    PlotView view = View({});
    const auto draw = [&](const Formula& formula, double rho, Mark mark, std::string label) {
        std::vector<double> y;
        for (const double alpha : alphas) {
            const double E = formula({UniformVisibility(alpha), {}, Albedo(rho)});
            y.push_back(E > -kCut && E < kCut ? E : SurfaceFigures::kUnknown);
        }
        view.series.push_back(Series(std::move(label), mark, ScaleColor(rho), x, sheet.Add(y)));
    };
    for (const double rho : {0.2, 0.5, 0.8, 0.95}) {
        const std::string label = "ρ = " + Exact(rho);
        draw(printed, rho, Mark::kLine, label);
        if (guarded) draw(*guarded, rho, Mark::kDashed, label + ", guarded");
    }
    std::string caption =
        "Light must lie between 0 and 1. Each albedo has an α at which the formula as printed "
        "(lines) leaves for infinity.";
    if (guarded)
        caption += " Dashed: the same under the guard of programs that ship it, " +
                   Html(guarded->name) + ", which the tables score.";
    return {.id = "poles",
            .title = printed.name + ", as printed, near α = 1",
            .caption = caption,
            .x = {"uniform visibility α [–]", kFrom, 1},
            .y = {"E(ρ) [–, open ground = 1]", 0.4, 1.6},
            .views = {view}};
}

Plot BoundPlot(const FitReport& report, PlotSheet& sheet) {
    constexpr double kFrom = 0.8;
    constexpr int kPoints = 401;
    std::vector<double> alphas, greatest;
    for (int i = 0; i < kPoints; ++i) {
        alphas.push_back(kFrom + (1 - kFrom) * i / double(kPoints - 1));
        greatest.push_back(GreatestCosineVisibility(UniformVisibility(alphas.back())));
    }
    const Column x = sheet.Add(alphas);
    PlotView view = View({});
    for (const DrawnCurve& curve : CurvesOf(report, 0)) {
        std::vector<double> y;
        for (const double alpha : alphas)
            y.push_back((*curve.formula)({UniformVisibility(alpha), {}, {}}));
        view.series.push_back(Series(curve.label, curve.mark, curve.color, x, sheet.Add(y)));
    }
    view.series.push_back(
        Series("greatest V, α(2 – α)", Mark::kDashed, kBoundColor, x, sheet.Add(greatest)));
    return {.id = "direct-bound",
            .title = "F₀ near α = 1",
            .caption =
                "Above the grey line F₀ promises more light than any sky of that α can "
                "send; above 1, more than an open sky.",
            .x = {"uniform visibility α [–]", kFrom, 1},
            .y = {"F₀ [–]", 0.92, 1.06},
            .views = {view}};
}

void AddIntervals(std::vector<std::vector<Cell>>& rows, const std::string& name,
                  const char* rule, const std::vector<BrokenInterval>& intervals) {
    for (const BrokenInterval& interval : intervals)
        rows.push_back(
            {{Html(name), "", ""},
             {rule, "", ""},
             {"α in (" + Digits(interval.low, 6) + ", " + Digits(interval.high, 6) + ")", "",
              ""},
             {"by " + Digits(interval.worst_excess) +
                  " at α = " + Digits(interval.worst_alpha, 4),
              "", ""}});
}

}  // namespace

std::string Faults(const FitReport& report, PlotSheet& sheet) {
    std::vector<std::vector<Cell>> rows;
    for (const FormulaFaults& faults : report.faults) {
        for (const FormulaFaults::Pole& pole : faults.poles)
            for (const UniformVisibility& alpha : pole.alphas)
                rows.push_back(
                    {{Html(faults.name), "", ""},
                     {"E(ρ) is finite", "", ""},
                     {"ρ = " + Exact(pole.rho.value) + ", α = " + Digits(alpha.value, 6), "",
                      ""},
                     {"pole", "", ""}});
        AddIntervals(rows, faults.name, "F₀ ≤ 1", faults.above_one);
        AddIntervals(rows, faults.name, "F₀ ≤ α(2 – α)", faults.above_bound);
        AddIntervals(rows, faults.name, "F₀ ≥ α²", faults.below_bound);
    }
    std::string html =
        "<p>With τ = 1 – F₁ / (1 – F₀), eq. 12 of the paper divides by (1 – ρ)(1 – F₀) + ρ F₁. "
        "Where F₀ exceeds 1 that can be zero: the formula has a pole, and programs that ship "
        "it "
        "guard it by hand.</p>\n";
    const Formula& published = Find(report, report.published).formula;
    std::vector<Plot> plots;
    if (published.model.inputs == ModelInputs{.alpha = true, .V = false, .rho = true})
        plots.push_back(report.printed.empty() ? PolePlot(published, nullptr, sheet)
                                               : PolePlot(Find(report, report.printed).formula,
                                                          &published, sheet));
    plots.push_back(BoundPlot(report, sheet));
    html += sheet.Group({}, std::move(plots));
    if (rows.empty()) return html + "<p>No fault was found in any set of constants.</p>\n";
    return html + "<details><summary>Every fault found</summary>\n" +
           Table({{"constants"}, {"rule", true}, {"broken at", true}, {"how badly", true}},
                 rows) +
           "</details>\n";
}

}  // namespace plumb::page
