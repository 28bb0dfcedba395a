// E(rho) of all bounces: simulation, recommended formula, any other formula beside it.
#include <algorithm>

#include "reports/fit_plots.h"
#include "reports/fit_sections.h"
#include "reports/histogram_plots.h"
#include "reports/text.h"

namespace plumb::fit_sections {
namespace {

/// Recommended, published, and what the caller wants drawn.
std::vector<const FormulaRecord*> Compared(const FitReport& report) {
    std::vector<const FormulaRecord*> list{&RecordNamed(report, report.published)};
    for (const FormulaRecord& record : report.formulas)
        if (record.plotted && record.name != report.published &&
            record.name != report.recommended)
            list.push_back(&record);
    return list;
}

struct TotalColumns {
    Column x;
    std::vector<Column> data;  ///< One an albedo shown.
};

/// Data as dots and one formula as lines, and their difference; the colour is the albedo.
struct TotalViews {
    PlotView value, residual;
};

TotalViews DrawTotal(const Choice& choice, const TotalColumns& columns,
                     const std::vector<std::size_t>& shown, const FormulaRecord& record,
                     std::vector<std::pair<std::string, std::string>> keys, double& largest) {
    TotalViews views{{.keys = keys}, {.keys = keys}};
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const std::size_t r = shown[i];
        const double rho = choice.histogram.albedos[r];
        const std::string color = ScaleColor(rho), label = "ρ = " + Exact(rho);
        const Column y = BinColumn(choice.histogram, [&](const BounceBin& bin) {
            const double predicted = record.formula(At(bin, rho));
            TakeLargest(largest, predicted - bin.total[r].mean);
            return predicted;
        });
        views.value.series.push_back(
            Series("", Mark::kDots, color, columns.x, columns.data[i]));
        views.value.series.push_back(Series(label, Mark::kLine, color, columns.x, y));
        views.residual.series.push_back(
            Series(label, Mark::kLine, color, columns.x, y, columns.data[i]));
    }
    return views;
}

}  // namespace

doc::Section Totals(const FitReport& report) {
    const FormulaRecord& ours = RecordNamed(report, report.recommended);
    const std::vector<const FormulaRecord*> compared = Compared(report);
    const std::string over_V = "V", over_alpha = "α";

    Plot value{
        .id = "total-recommended",
        .title = "Recommended: " + ours.name,
        .caption =
            "Dots: simulated light, mean of each bin. Lines of the same colour: "
            "the formula, evaluated at the bin's own mean α and V. A perfect "
            "formula runs through its dots; at ρ = 1 all must lie at 1.",
        .x = {},
        .y = {"E(ρ) [–, open ground = 1]", 0, 1.1},
    };
    Plot value_compared = value;
    value_compared.id = "total-compared";
    value_compared.title = "To compare: the formula chosen above";
    value_compared.caption =
        "The same data under another formula. Lines that leave the frame go to a pole.";
    Plot residual{
        .id = "total-recommended-residual",
        .title = "What the recommended formula leaves",
        .caption = "Formula minus simulation. Above 0 the formula is too bright.",
        .x = {},
        .y = {},
    };
    Plot residual_compared = residual;
    residual_compared.id = "total-compared-residual";
    residual_compared.title = "What the other formula leaves";
    residual_compared.caption =
        "The same scale as on the left: narrower is better. What is cut off is worse still.";

    double largest = 0, largest_compared = 0;
    std::vector<std::string> names;
    for (const bool by_V : {true, false}) {
        const std::vector<Choice> choices =
            Choices(report, by_V ? &SurfaceReport::over_V : &SurfaceReport::over_alpha);
        names = Names(choices);
        for (const Choice& choice : choices) {
            const std::vector<std::size_t> shown = PlottedAlbedos(choice.histogram.albedos);
            TotalColumns columns{Abscissae(choice.histogram), {}};
            for (const std::size_t r : shown)
                columns.data.push_back(BinColumn(
                    choice.histogram, [&](const BounceBin& bin) { return bin.total[r].mean; }));
            const Axis x{AbscissaLabel(choice.histogram.binned_by), 0, 1};
            const auto draw = [&](const FormulaRecord& record, Plot& values, Plot& residuals,
                                  std::vector<std::pair<std::string, std::string>> keys) {
                TotalViews views = DrawTotal(choice, columns, shown, record, std::move(keys),
                                             &record == &ours ? largest : largest_compared);
                views.value.x = views.residual.x = x;
                values.views.push_back(std::move(views.value));
                residuals.views.push_back(std::move(views.residual));
            };
            const std::pair<std::string, std::string> map{"map", choice.name},
                over{"over", by_V ? over_V : over_alpha};
            draw(ours, value, residual, {map, over});
            for (const FormulaRecord* record : compared)
                draw(*record, value_compared, residual_compared,
                     {map, over, {"formula", record->name}});
        }
    }
    // Both on one scale, but a pole of the other formula must not flatten ours.
    constexpr double kShownOfOthers = 0.3;
    residual.y = residual_compared.y =
        ResidualAxis("formula – simulation [–]",
                     std::max(largest, std::min(largest_compared, kShownOfOthers)));

    std::vector<std::string> formulas;
    for (const FormulaRecord* record : compared) formulas.push_back(record->name);
    const std::vector<std::string> over = ours.formula.model.inputs.V
                                              ? std::vector{over_V, over_alpha}
                                              : std::vector{over_alpha, over_V};
    return {.id = "totals",
            .title = "All bounces: E(ρ)",
            .plots = {{.selectors = {{"map", "Map", names},
                                     {"over", "Over", over},
                                     {"formula", "Compare with", formulas}},
                       .plots = {value, value_compared, residual, residual_compared}}}};
}

}  // namespace plumb::fit_sections
