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
                        Interval95(row.rms_to_none), WithErrorOf(row.against_truth.error.bias),
                        Interval95(row.against_truth.error.rmse),
                        Interval95(row.against_truth.recalibrated_rmse)});
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
                        Text(std::to_string(row.guard_px)), Interval95(row.rms_to_widest),
                        WithErrorOf(row.border.error.bias), Interval95(row.border.error.rmse),
                        Ms(row.draw_s), Ms(row.sao_s)});
    }
    return "<h3>The guard band</h3><p>Border drawn but not shown, as a share of the height, in "
           "whole texels of the pyramid, the pattern of taps held to the frame; "
           "figures of the pixels within 32 px of the frame, as shipped. What is left of the "
           "RMS "
           "is what lies beyond the frame.</p>" +
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
                        WithErrorOf(e.bias),
                        Interval95(e.rmse),
                        Number(e.psnr_db.value, 4),
                        Interval95(row.score.recalibrated_rmse),
                        Interval95(row.weighted.error.rmse),
                        Number(row.rms_change),
                        row.seconds ? Ms(*row.seconds) : Text("–")});
        steps.push_back({row.step, e.rmse.value, row.score.recalibrated_rmse.value});
    }
    std::string aside;
    if (r.no_border) {
        aside = "<p>Without a guard band, all else as shipped: RMSE " +
                WithInterval(r.no_border->score.error.rmse) + "; it moves the picture by " +
                Digits(r.no_border->rms_change) + ".</p>";
    }
    return "<p>" + Html(r.budget_technique) +
           ", one approximation switched on after the other, on " + Count(r.budget_pixels) +
           " pixels of camera " + Html(r.views.front().camera) + ", " + Count(r.budget_taps) +
           " taps in place of an integral. All rows are scored against V within r: the first "
           "is "
           "what the technique's falloff costs, the last the technique as shipped. "
           "<i>To its own</i>: RMSE against V within r weighted by that falloff. "
           "<i>Moves</i>: root mean square change of the picture by the step alone.</p>" +
           WaterfallSvg(steps) +
           Table({{"step"},
                  {"what is switched on", true},
                  {"bias"},
                  {"RMSE"},
                  {"PSNR [dB]"},
                  {"recalibrated RMSE"},
                  {"to its own"},
                  {"moves"},
                  {"time [ms]"}},
                 rows) +
           aside + PyramidsHtml(r) + GuardsHtml(r);
}

}  // namespace plumb::page
