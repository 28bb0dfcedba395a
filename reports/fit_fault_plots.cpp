// Where constants break the formula in print: drawn near alpha = 1, and listed.
#include "reports/columns.h"
#include "reports/fit_plots.h"
#include "reports/fit_sections.h"
#include "reports/histogram_plots.h"
#include "reports/text.h"

namespace plumb::fit_sections {
namespace {

/// The formula as printed near its poles, and under its guard. Beyond the frame a line is broken
/// off, so that none joins the two sides of a pole.
Plot PolePlot(const Formula& printed, const Formula* guarded) {
    constexpr double kFrom = 0.9, kCut = 2.5;
    constexpr int kPoints = 2001;
    std::vector<double> alphas;
    for (int i = 0; i < kPoints; ++i)
        alphas.push_back(kFrom + (1 - kFrom) * i / double(kPoints - 1));
    const Column x = alphas;
    PlotView view = PlotView{};
    const auto draw = [&](const Formula& formula, double rho, Mark mark, std::string label) {
        std::vector<double> y;
        for (const double alpha : alphas) {
            const double E = formula({UniformVisibility(alpha), {}, Albedo(rho)});
            y.push_back(E > -kCut && E < kCut ? E : SurfaceFigures::kUnknown);
        }
        view.series.push_back(Series(std::move(label), mark, ScaleColor(rho), x, y));
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
                   doc::Verbatim(guarded->name) + ", which the tables score.";
    return {.id = "poles",
            .title = printed.name + ", as printed, near α = 1",
            .caption = caption,
            .x = {"uniform visibility α [–]", kFrom, 1},
            .y = {"E(ρ) [–, open ground = 1]", 0.4, 1.6},
            .views = {view}};
}

Plot BoundPlot(const FitReport& report) {
    constexpr double kFrom = 0.8;
    constexpr int kPoints = 401;
    std::vector<double> alphas, greatest;
    for (int i = 0; i < kPoints; ++i) {
        alphas.push_back(kFrom + (1 - kFrom) * i / double(kPoints - 1));
        greatest.push_back(GreatestCosineVisibility(UniformVisibility(alphas.back())));
    }
    const Column x = alphas;
    PlotView view = PlotView{};
    for (const DrawnCurve& curve : CurvesOf(report, 0)) {
        std::vector<double> y;
        for (const double alpha : alphas)
            y.push_back((*curve.formula)({UniformVisibility(alpha), {}, {}}));
        view.series.push_back(Series(curve.label, curve.mark, curve.color, x, y));
    }
    view.series.push_back(
        Series("greatest V, α(2 – α)", Mark::kDashed, kBoundColor, x, greatest));
    return {.id = "direct-bound",
            .title = "F₀ near α = 1",
            .caption =
                "Above the grey line F₀ promises more light than any sky of that α can "
                "send; above 1, more than an open sky.",
            .x = {"uniform visibility α [–]", kFrom, 1},
            .y = {"F₀ [–]", 0.92, 1.06},
            .views = {view}};
}

doc::Table FaultsTable(const FitReport& report) {
    doc::Table table{
        .key = "faults",
        .columns = {doc::Name("constants", "Constants"), doc::Name("rule", "Rule"),
                    doc::Name("albedo", "ρ"), doc::Value("low", "Broken from α", 6),
                    doc::Value("high", "to α", 6), doc::Value("worst_excess", "By"),
                    doc::Value("worst_at", "at α", 4)}};
    const doc::Cell none;
    for (const FormulaFaults& faults : report.faults) {
        for (const FormulaFaults::Pole& pole : faults.poles)
            for (const UniformVisibility& alpha : pole.alphas)
                table.Add({faults.name, "E(ρ) is finite", pole.rho.value, alpha.value,
                           alpha.value, none, none});
        for (const auto& [rule, intervals] : {std::pair{"F₀ ≤ 1", &faults.above_one},
                                              std::pair{"F₀ ≤ α(2 – α)", &faults.above_bound},
                                              std::pair{"F₀ ≥ α²", &faults.below_bound}})
            for (const BrokenInterval& i : *intervals)
                table.Add(
                    {faults.name, rule, none, i.low, i.high, i.worst_excess, i.worst_alpha});
    }
    return table;
}

}  // namespace

doc::Section Faults(const FitReport& report) {
    doc::Section section{
        .id = "faults",
        .title = "Where the formula in print breaks",
        .sentences = {
            "With τ = 1 – F₁ / (1 – F₀), eq. 12 of the paper divides by (1 – ρ)(1 – F₀) "
            "+ ρ F₁. Where F₀ exceeds 1 that can be zero: the formula has a pole, and "
            "programs that ship it guard it by hand."}};
    const Formula& published = RecordNamed(report, report.published).formula;
    doc::Plots plots;
    if (published.model.inputs == ModelInputs{.alpha = true, .V = false, .rho = true})
        plots.plots.push_back(
            report.printed.empty()
                ? PolePlot(published, nullptr)
                : PolePlot(RecordNamed(report, report.printed).formula, &published));
    plots.plots.push_back(BoundPlot(report));
    section.plots = {std::move(plots)};
    doc::Table table = FaultsTable(report);
    if (table.rows.empty()) {
        section.sentences.push_back("No fault was found in any set of constants.");
    } else {
        section.sections = {{.id = "every_fault",
                             .title = "Every fault found",
                             .folded = true,
                             .tables = {std::move(table)}}};
    }
    return section;
}

}  // namespace plumb::fit_sections
