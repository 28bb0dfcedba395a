// The page of a scene's report.
#include <algorithm>

#include "reports/depth_html.h"
#include "reports/scene_report_page.h"

namespace plumb {
namespace {

using page::Interval95;
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

const TechniqueScore& Named(const SceneReport& r, const std::string& name) {
    return *std::ranges::find(r.techniques, name, &TechniqueScore::name);
}

std::string Ties(const Closest& closest) {
    return closest.ties.empty()
               ? ""
               : " Not told apart from it: " + Html(Listed(closest.ties)) + ".";
}

std::string Findings(const SceneReport& r) {
    const SceneTruth& truth = r.views.front().truth;
    const TechniqueScore& best = Named(r, r.closest.name);
    std::string html = "<ul>\n<li>Closest to V within r as it is: <b>" + Html(best.name) +
                       "</b>, RMSE " + WithInterval(best.Against(kNear).error.rmse) + " in " +
                       Digits(best.seconds.value * 1e3) + " ms." + Ties(r.closest) + "</li>\n";
    const TechniqueScore& shape = Named(r, r.closest_recalibrated.name);
    html += "<li>Closest in shape, after the best monotone change of contrast: <b>" +
            Html(shape.name) + "</b>, RMSE " +
            WithInterval(shape.Against(kNear).recalibrated_rmse) + "." +
            Ties(r.closest_recalibrated) + "</li>\n";
    if (!r.cheapest.name.empty()) {
        html += "<li>Fastest setting within " + Digits(100 * r.cheapest_within, 2) +
                " % of the least error of the sweep: <b>" + Html(r.cheapest.name) + "</b>." +
                Ties(r.cheapest) + "</li>\n";
    }
    html += "<li>The truth is known to " + Digits(truth.rms_error_near, 2) +
            " a pixel (root mean square standard error of V within r, " +
            std::to_string(truth.spp) + " rays); its noise is taken off every error below. " +
            std::to_string(truth.lost) + " rays were lost.</li>\n";
    for (const std::string& note : r.notes) html += "<li>" + Html(note) + "</li>\n";
    return html + "</ul>\n";
}

std::string TruthHtml(const SceneReport& r) {
    const SceneTruth& truth = r.views.front().truth;
    std::string others;
    if (r.views.size() > 1) {
        others = " The other cameras' truths have " + std::to_string(r.views[1].truth.spp) +
                 " rays a pixel.";
    }
    return "<p>Path-traced from the pixel's centre, " + std::to_string(truth.spp) +
           " rays a pixel in " + std::to_string(truth.nets) +
           " independent nets. V sees the whole scene; V within r counts only what is nearer "
           "than " +
           Digits(r.radius_m) + " m, which is what a screen-space method is meant to find." +
           others + "</p>" + "<div class=\"views\">" + Figcaption(truth.picture_V, "V", "V") +
           Figcaption(truth.picture_near, "V within r",
                      "V within r = " + Digits(r.radius_m) + " m") +
           "</div>";
}

// What an interval of this page says.
std::string WhatIntervalsAre(const SceneReport& r) {
    if (r.views.size() == 1) {
        return "Intervals are of 95 %, from the scatter of the tiles of this one view: what "
               "another picture of the same surfaces would show. Other cameras of a scene "
               "often "
               "lie outside of them: give all its cameras to tell of the scene.";
    }
    return "All " + std::to_string(r.views.size()) +
           " cameras count alike. Intervals are of 95 % between views (Student's t of " +
           std::to_string(r.views.size() - 1) +
           " degrees of freedom, in the logarithm for RMSE), and a ± is the standard error "
           "between views: what another camera would show, if these were picked at random. The "
           "figures of one view have intervals from the scatter of its tiles, which are "
           "shorter: they tell of that view alone.";
}

std::string ViewsHtml(const SceneReport& r) {
    if (r.views.size() == 1) return {};
    std::vector<Head> head{{"technique"}};
    for (const SceneView& view : r.views) head.push_back({view.camera});
    std::vector<std::vector<Cell>> rows;
    for (const TechniqueScore& t : r.techniques) {
        std::vector<Cell> row{Text(t.name)};
        for (const ViewScores& view : t.views) {
            row.push_back(Interval95(Against(view.scores, kNear, "whole").error.rmse));
        }
        rows.push_back(std::move(row));
    }
    return "<h3>RMSE by camera</h3><p>Against V within r; 95 % intervals from the tiles of "
           "each "
           "view.</p>" +
           Table(head, rows);
}

std::string ScoresHtml(const SceneReport& r) {
    double worst = 0;
    for (const TechniqueScore& t : r.techniques) {
        worst = std::max(worst, t.Against(kNear).error.rmse.value);
    }
    std::vector<std::vector<Cell>> rows;
    for (const TechniqueScore& t : r.techniques) {
        const ScoreAgainst& s = t.Against(kNear);
        Cell rmse = Interval95(s.error.rmse);
        rmse.background = HeatColor(worst > 0 ? s.error.rmse.value / worst : 0);
        rows.push_back({Text(t.name), Text(std::to_string(t.samples)), Ms(t.seconds),
                        WithErrorOf(s.error.bias), WithErrorOf(s.error.mae), rmse,
                        Interval95(s.error.psnr_db, 4), Interval95(s.ssim),
                        Interval95(s.recalibrated_rmse)});
    }
    std::string html =
        "<p>Against V within r, over all pixels that show a surface. " + WhatIntervalsAre(r) +
        " Techniques are compared with each other pixel by pixel, which tells more apart. "
        "<i>Recalibrated</i>: RMSE that is left after the best monotone change of contrast, "
        "fitted to other tiles than it is scored on: what no tone curve mends. Times are of "
        "camera " +
        Html(r.views.front().camera) + ", medians of " + std::to_string(r.rounds) +
        " rounds with the least and the greatest.</p>" +
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
            row.push_back(Interval95(t.Against(truth).error.rmse));
        }
        for (const std::string& region : regions) {
            const auto found = std::find_if(
                t.scores.begin(), t.scores.end(),
                [&](const ScoreAgainst& s) { return s.truth == kNear && s.region == region; });
            row.push_back(found == t.scores.end() ? Text("–") : Interval95(found->error.rmse));
        }
        rows.push_back(std::move(row));
    }
    html +=
        ViewsHtml(r) +
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
        "The scale is the same in all pictures. Camera " +
        Html(r.views.front().camera) + ".</p>\n";
    for (const TechniqueScore& t : r.techniques) {
        if (t.picture.empty()) continue;
        html +=
            "<div class=\"views\">" + Figcaption(t.picture, t.name, t.name) +
            Figcaption(
                t.signed_error, "error of " + t.name,
                "error, RMSE " +
                    Digits(Against(t.views.front().scores, kNear, "whole").error.rmse.value)) +
            "</div>\n";
    }
    return html;
}

std::string AgainHtml(const SceneReport& r) {
    std::string views;
    for (const SceneView& v : r.views) {
        views += "; camera " + Html(v.camera) + ", " + std::to_string(v.width_px) + " × " +
                 std::to_string(v.height_px) + " px with a border of " +
                 std::to_string(v.guard_px) + " px, " + Count(v.seen) +
                 " pixels show a surface";
    }
    return "<pre class=\"command\">" + Html(r.command) + "</pre>\n<p>plumb " +
           Html(r.tool_version) + "; scene " + Html(r.scene) + ", " + Count(r.triangles) +
           " triangles, sha256 <code>" + Html(r.scene_sha256) + "</code>" + views + "; seed " +
           std::to_string(r.seed) +
           ". The same command gives the same figures to the last digit, on any number of "
           "threads; only what is in seconds differs.</p>";
}

}  // namespace

std::string ToHtml(const SceneReport& r) {
    Page whole("Ambient obscurance of " + r.scene,
               ViewsText(r) + ", radius " + Digits(r.radius_m) + " m");
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
