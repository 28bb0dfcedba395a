// Where SAO's error comes from: the budget and the pyramid.
#include "reports/scene_report_page.h"
#include "reports/waterfall.h"

namespace plumb::page {
namespace {

std::string PyramidsHtml(const SceneReport& r) {
    if (r.pyramids.empty()) return {};
    std::vector<std::vector<Cell>> rows;
    for (const PyramidRow& row : r.pyramids) {
        rows.push_back({Text(row.filter), WithErrorOf(row.bias_to_none),
                        WithErrorOf(row.rms_to_none), WithErrorOf(row.against_truth.error.bias),
                        WithErrorOf(row.against_truth.error.rmse),
                        Number(row.against_truth.recalibrated_rmse.value)});
    }
    return "<h3>How the z pyramid is made</h3><p>The paper's table 1 with numbers: " +
           Html(r.budget_technique) +
           " before any filter, against itself without a pyramid, and against V within r "
           "weighted by its falloff.</p>" +
           Table({{"filter"},
                  {"bias to none"},
                  {"RMS to none"},
                  {"bias"},
                  {"RMSE"},
                  {"recalibrated RMSE"}},
                 rows);
}

std::string GuardsHtml(const SceneReport& r) {
    if (r.guards.empty()) return {};
    std::vector<std::vector<Cell>> rows;
    for (const GuardRow& row : r.guards) {
        rows.push_back({Text(Digits(100 * row.share, 2) + " %"),
                        Text(std::to_string(row.guard_px)), WithErrorOf(row.rms_to_widest),
                        WithErrorOf(row.border.error.bias), WithErrorOf(row.border.error.rmse),
                        Ms(row.draw_s), Ms(row.sao_s)});
    }
    return "<h3>The guard band</h3><p>Border drawn but not shown, as a share of the height, in "
           "whole texels of the pyramid, the pattern of taps held to the frame; "
           "figures of the pixels within 32 px of the frame, as shipped. Times of a single "
           "run.</p>" +
           Table({{"border"},
                  {"[px]"},
                  {"RMS to the widest"},
                  {"bias"},
                  {"RMSE"},
                  {"G-buffer [ms]"},
                  {"SAO [ms]"}},
                 rows);
}

}  // namespace

std::string BudgetHtml(const SceneReport& r) {
    std::vector<std::vector<Cell>> rows;
    std::vector<WaterfallStep> steps;
    for (const BudgetRow& row : r.budget) {
        const ErrorScore& e = row.score.error;
        rows.push_back({Text(row.step),
                        {Html(row.what), "wrap", ""},
                        {WithError(e.bias.value, e.bias.standard_error), "", ""},
                        {WithError(e.rmse.value, e.rmse.standard_error), "", ""},
                        Number(e.psnr_db.value, 4),
                        Number(row.score.recalibrated_rmse.value),
                        Number(row.rms_change),
                        Ms(row.seconds)});
        steps.push_back({row.step, e.rmse.value, row.score.recalibrated_rmse.value});
    }
    return "<p>" + Html(r.budget_technique) +
           ", one approximation switched on after the other, on " +
           Count(r.budget.empty() ? 0 : r.budget.front().pixels) +
           " pixels. All rows but the first are scored against V within r weighted by the "
           "technique's own falloff; the first says how far that is from V within r. "
           "<i>Moves</i>: root mean square change of the picture by the step alone.</p>" +
           WaterfallSvg(steps) +
           Table({{"step"},
                  {"what is switched on", true},
                  {"bias"},
                  {"RMSE"},
                  {"PSNR [dB]"},
                  {"recalibrated RMSE"},
                  {"moves"},
                  {"time [ms]"}},
                 rows) +
           PyramidsHtml(r) + GuardsHtml(r);
}

}  // namespace plumb::page
