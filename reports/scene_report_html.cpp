// The page of a scene's report.
#include <algorithm>

#include "reports/depth_html.h"
#include "reports/scene_report_page.h"

namespace plumb {
namespace {

using page::Ms;
using page::Number;
using page::Text;
using page::WithErrorOf;

constexpr const char* kNear = "V within r";

std::string Figcaption(const std::string& picture, const std::string& alternative,
                       const std::string& caption) {
    if (picture.empty()) return {};
    return "<figure>" + Picture(picture, alternative, alternative) + "<figcaption>" +
           Html(caption) + "</figcaption></figure>\n";
}

const TechniqueScore* Best(const SceneReport& r, bool recalibrated) {
    const TechniqueScore* best = nullptr;
    const auto error = [&](const TechniqueScore& t) {
        const ScoreAgainst& s = t.Against(kNear);
        return recalibrated ? s.recalibrated_rmse.value : s.error.rmse.value;
    };
    for (const TechniqueScore& t : r.techniques) {
        if (!best || error(t) < error(*best)) best = &t;
    }
    return best;
}

std::string Findings(const SceneReport& r) {
    std::string html = "<ul>\n";
    if (const TechniqueScore* best = Best(r, false)) {
        html += "<li>Closest to V within r as it is: <b>" + Html(best->name) + "</b>, RMSE " +
                WithError(best->Against(kNear).error.rmse.value,
                          best->Against(kNear).error.rmse.standard_error) +
                " in " + Digits(best->seconds * 1e3) + " ms.</li>\n";
    }
    if (const TechniqueScore* best = Best(r, true)) {
        html += "<li>Closest in shape, after the best monotone change of contrast: <b>" +
                Html(best->name) + "</b>, RMSE " +
                Digits(best->Against(kNear).recalibrated_rmse.value) + ".</li>\n";
    }
    if (!r.cheapest.empty()) {
        html += "<li>Fastest setting within " + Digits(100 * r.cheapest_within, 2) +
                " % of the least error of the sweep: <b>" + Html(r.cheapest) + "</b>.</li>\n";
    }
    html += "<li>The truth is known to " + Digits(r.truth.rms_error_near, 2) +
            " a pixel (root mean square standard error of V within r, " +
            std::to_string(r.truth.spp) + " rays); its noise is taken off every error below. " +
            std::to_string(r.truth.lost) + " rays were lost.</li>\n";
    for (const std::string& note : r.notes) html += "<li>" + Html(note) + "</li>\n";
    return html + "</ul>\n";
}

std::string TruthHtml(const SceneReport& r) {
    return "<p>Path-traced from the pixel's centre, " + std::to_string(r.truth.spp) +
           " rays a pixel in " + std::to_string(r.truth.nets) +
           " independent nets. V sees the whole scene; V within r counts only what is nearer "
           "than " +
           Digits(r.radius_m) +
           " m, which is what a screen-space method is meant to find.</p>" +
           "<div class=\"views\">" + Figcaption(r.truth.picture_V, "V", "V") +
           Figcaption(r.truth.picture_near, "V within r",
                      "V within r = " + Digits(r.radius_m) + " m") +
           "</div>";
}

std::string ScoresHtml(const SceneReport& r) {
    double worst = 0;
    for (const TechniqueScore& t : r.techniques) {
        worst = std::max(worst, t.Against(kNear).error.rmse.value);
    }
    std::vector<std::vector<Cell>> rows;
    for (const TechniqueScore& t : r.techniques) {
        const ScoreAgainst& s = t.Against(kNear);
        rows.push_back({Text(t.name),
                        Text(std::to_string(t.samples)),
                        Ms(t.seconds),
                        {WithError(s.error.bias.value, s.error.bias.standard_error), "", ""},
                        {WithError(s.error.mae.value, s.error.mae.standard_error), "", ""},
                        {WithError(s.error.rmse.value, s.error.rmse.standard_error), "",
                         HeatColor(worst > 0 ? s.error.rmse.value / worst : 0)},
                        Number(s.error.psnr_db.value, 4),
                        Number(s.ssim.value),
                        Number(s.recalibrated_rmse.value)});
    }
    std::string html =
        "<p>Against V within r, over all pixels that show a surface. A ± is a standard error "
        "over tiles of the picture: how much another view of the scene would move the figure. "
        "<i>Recalibrated</i>: RMSE that is left after the best monotone change of contrast, "
        "fitted to other tiles than it is scored on: what no tone curve mends.</p>" +
        Table({{"technique"},
               {"lookups or rays"},
               {"time [ms]"},
               {"bias"},
               {"MAE"},
               {"RMSE"},
               {"PSNR [dB]"},
               {"SSIM"},
               {"recalibrated RMSE"}},
              rows);
    rows.clear();
    const std::vector<std::string> truths{"V", kNear, "V within r, weighted"};
    const std::vector<std::string> regions{"edges", "interiors", "border"};
    for (const TechniqueScore& t : r.techniques) {
        std::vector<Cell> row{Text(t.name), Text(t.falloff)};
        for (const std::string& truth : truths) {
            row.push_back(Number(t.Against(truth).error.rmse.value));
        }
        for (const std::string& region : regions) {
            const auto found = std::find_if(
                t.scores.begin(), t.scores.end(),
                [&](const ScoreAgainst& s) { return s.truth == kNear && s.region == region; });
            row.push_back(found == t.scores.end() ? Text("–")
                                                  : Number(found->error.rmse.value));
        }
        rows.push_back(std::move(row));
    }
    html +=
        "<h3>RMSE by truth and by region</h3><p>A technique counts distant things less: its "
        "own falloff. The truth weighted by that same falloff is what it means to compute; "
        "the regions are scored against V within r.</p>" +
        Table({{"technique"},
               {"falloff", true},
               {"V"},
               {"V within r"},
               {"… weighted by its falloff"},
               {"edges"},
               {"interiors"},
               {"border"}},
              rows);
    return html;
}

std::string PicturesHtml(const SceneReport& r) {
    std::string html =
        "<p>Left the technique's picture, right its error against V within r: blue is too dark "
        "by 0.25 or more, white is right, red is too bright by 0.25 or more, the sky is grey. "
        "The scale is the same in all pictures.</p>\n";
    for (const TechniqueScore& t : r.techniques) {
        if (t.picture.empty()) continue;
        html += "<div class=\"views\">" + Figcaption(t.picture, t.name, t.name) +
                Figcaption(t.signed_error, "error of " + t.name,
                           "error, RMSE " + Digits(t.Against(kNear).error.rmse.value)) +
                "</div>\n";
    }
    return html;
}

std::string AgainHtml(const SceneReport& r) {
    return "<pre class=\"command\">" + Html(r.command) + "</pre>\n<p>plumb " +
           Html(r.tool_version) + "; scene " + Html(r.scene) + ", " + Count(r.triangles) +
           " triangles, sha256 <code>" + Html(r.scene_sha256) + "</code>; camera " +
           Html(r.camera) + ", " + std::to_string(r.width_px) + " × " +
           std::to_string(r.height_px) + " px with a border of " + std::to_string(r.guard_px) +
           " px, " + Count(r.seen) + " pixels show a surface; seed " + std::to_string(r.seed) +
           ". The same command gives the same figures to the last digit, on any number of "
           "threads; only what is in seconds differs.</p>";
}

}  // namespace

std::string ToHtml(const SceneReport& r) {
    Page whole("Ambient obscurance of " + r.scene,
               "camera " + r.camera + ", radius " + Digits(r.radius_m) + " m");
    PlotSheet& sheet = whole.Plots();
    whole.AddSection("findings", "What it finds", Findings(r));
    whole.AddSection("truth", "The truth", TruthHtml(r));
    whole.AddSection("scores", "Techniques against the truth", ScoresHtml(r));
    whole.AddSection("pictures", "Where they err", PicturesHtml(r));
    if (!r.budget.empty()) whole.AddSection("budget", "Error budget", page::BudgetHtml(r));
    if (!r.sweep.empty())
        whole.AddSection("sweep", "Error against run time", page::SweepHtml(r, sheet));
    if (!r.times.empty()) whole.AddSection("times", "Time", page::TimesHtml(r, sheet));
    if (r.precision) {
        whole.AddSection("depth", "What the depth buffer keeps",
                         DepthHtml(*r.precision, sheet));
    }
    if (!r.temporal.empty()) whole.AddSection("flicker", "Flicker", page::FlickerHtml(r));
    whole.AddSection("again", "How to make this again", AgainHtml(r));
    return whole.Text();
}

}  // namespace plumb
