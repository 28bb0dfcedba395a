// The page of a scene's report.
#include <algorithm>
#include <cmath>
#include <map>

#include "reports/depth_html.h"
#include "reports/page.h"
#include "reports/scene_report.h"
#include "reports/text.h"
#include "reports/waterfall.h"

namespace plumb {
namespace {

constexpr const char* kNear = "V within r";

Cell Text(std::string text) {
    return {Html(text), "", ""};
}

Cell Number(double value, int significant = 3) {
    return {Digits(value, significant), "", ""};
}

Cell Ms(double seconds) {
    return Number(seconds * 1e3);
}

PlotSeries Dots(std::string label, int i, Column x, Column y, bool joined) {
    return {.label = std::move(label),
            .mark = Mark::kDots,
            .color = CategoryColor(i),
            .x = x,
            .y = y,
            .minus = {},
            .high = {},
            .joined = joined,
            .shape = i % 5};
}

PlotSeries Curve(std::string label, std::string color, Column x, Column y,
                 Mark mark = Mark::kLine) {
    return {.label = std::move(label),
            .mark = mark,
            .color = std::move(color),
            .x = x,
            .y = y,
            .minus = {},
            .high = {},
            .joined = false,
            .shape = 0};
}

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

std::string PyramidsHtml(const SceneReport& r) {
    if (r.pyramids.empty()) return {};
    std::vector<std::vector<Cell>> rows;
    for (const PyramidRow& row : r.pyramids) {
        const auto figure = [](const Figure& f) {
            return Cell{WithError(f.value, f.standard_error), "", ""};
        };
        rows.push_back({Text(row.filter), figure(row.bias_to_none), figure(row.rms_to_none),
                        figure(row.against_truth.error.bias),
                        figure(row.against_truth.error.rmse),
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
           PyramidsHtml(r);
}

std::string SweepHtml(const SceneReport& r, PlotSheet& sheet) {
    std::map<std::string, std::vector<const SweepPoint*>> by_technique;
    std::vector<std::string> order;
    for (const SweepPoint& p : r.sweep) {
        if (by_technique[p.technique].empty()) order.push_back(p.technique);
        by_technique[p.technique].push_back(&p);
    }
    const auto view = [&](const std::string& key, double SweepPoint::*error) {
        PlotView drawn{.keys = {{"error", key}}, .series = {}, .x = {}, .y = {}};
        for (std::size_t t = 0; t < order.size(); ++t) {
            std::vector<double> x, y;
            for (const SweepPoint* p : by_technique[order[t]]) {
                x.push_back(p->seconds * 1e3);
                y.push_back(p->*error);
            }
            drawn.series.push_back(Dots(order[t], int(t), sheet.Add(x), sheet.Add(y), false));
        }
        return drawn;
    };
    PlotView plain = view("as it is", &SweepPoint::rmse);
    double least = 1, most = 0;
    for (const SweepPoint& p : r.sweep) {
        least = std::min({least, p.rmse, p.recalibrated_rmse});
        most = std::max({most, p.rmse, p.recalibrated_rmse});
    }
    std::vector<std::pair<double, double>> front;
    for (const SweepPoint& p : r.sweep) {
        if (p.on_front) front.push_back({p.seconds * 1e3, p.rmse});
    }
    std::sort(front.begin(), front.end());
    std::vector<double> x, y;
    for (const auto& [ms, rmse] : front) {
        x.push_back(ms);
        y.push_back(rmse);
    }
    plain.series.push_back(
        Curve("Pareto front", kDataColor, sheet.Add(x), sheet.Add(y), Mark::kDashed));
    PlotView recalibrated = view("recalibrated", &SweepPoint::recalibrated_rmse);
    Plot plot{
        .id = "error-time",
        .title = "Error against run time",
        .caption =
            "Each dot is one setting of one technique: lookups or rays a pixel, "
            "pyramid, packing and filters on and off. Down and to the left is "
            "better; nothing lies below the front.",
        .x = {.label = "time of one picture [ms]", .low = {}, .high = {}, .logarithmic = true},
        .y = {.label = "RMSE against V within r",
              .low = 0.8 * least,
              .high = 1.2 * most,
              .logarithmic = true},
        .views = {std::move(plain), std::move(recalibrated)},
        .wide = true};
    std::string html = sheet.Group({{"error", "error", {"as it is", "recalibrated"}}}, {plot});
    std::vector<const SweepPoint*> sorted;
    for (const SweepPoint& p : r.sweep) {
        if (p.on_front) sorted.push_back(&p);
    }
    std::sort(sorted.begin(), sorted.end(),
              [](const SweepPoint* a, const SweepPoint* b) { return a->seconds < b->seconds; });
    std::vector<std::vector<Cell>> rows;
    for (const SweepPoint* p : sorted) {
        rows.push_back({Text(p->technique), Text(p->setting), Ms(p->seconds), Number(p->rmse),
                        Number(p->recalibrated_rmse)});
    }
    return html + "<h3>The Pareto front</h3>" +
           Table({{"technique"},
                  {"setting", true},
                  {"time [ms]"},
                  {"RMSE"},
                  {"recalibrated RMSE"}},
                 rows);
}

std::string TimesHtml(const SceneReport& r, PlotSheet& sheet) {
    std::vector<std::vector<Cell>> rows;
    for (const PassTimes& t : r.times) {
        std::string passes;
        for (const PassSeconds& pass : t.passes) {
            passes +=
                (passes.empty() ? "" : " · ") + pass.name + " " + Digits(pass.seconds * 1e3, 3);
        }
        rows.push_back({Text(t.technique),
                        Text(std::to_string(t.width_px) + " × " + std::to_string(t.height_px) +
                             " + " + std::to_string(t.guard_px)),
                        Ms(t.seconds),
                        {Html(passes), "wrap", ""},
                        Number(t.bytes_per_pixel),
                        Number(t.ns_per_visible),
                        Number(t.copies)});
    }
    std::string html =
        "<p>On " + std::to_string(r.threads) +
        " threads; medians. Sizes are those of the paper's table 2 with their guard bands. "
        "<i>Bytes</i>: what the passes read and write at least, every picture once. "
        "<i>Copies</i>: the time over that of copying as many bytes in the same run; this "
        "machine copies " +
        Digits(r.copy_bytes_per_second / 1e9) + " GB/s (read and written) and casts " +
        Digits(r.embree_rays_per_second / 1e6) +
        " million bare occlusion rays a second in this scene. One G-buffer takes " +
        Digits(r.raster_s * 1e3) + " ms.</p>" +
        Table({{"technique"},
               {"size + border [px]", true},
               {"time [ms]"},
               {"passes [ms]", true},
               {"bytes a pixel"},
               {"ns a visible pixel"},
               {"copies"}},
              rows);
    if (r.radii.empty()) return html;
    std::vector<double> radius, with, without, alchemy;
    for (const RadiusTime& t : r.radii) {
        radius.push_back(t.radius_m);
        with.push_back(t.with_pyramid_s * 1e3);
        without.push_back(t.without_pyramid_s * 1e3);
        alchemy.push_back(t.alchemy_s * 1e3);
    }
    const Column x = sheet.Add(radius);
    Plot plot{.id = "radius",
              .title = "Sampling time against radius",
              .caption =
                  "1920 × 1080, 9 taps (AlchemyAO: 12). The paper's figure 5: without a "
                  "pyramid taps of a wide disc miss the cache.",
              .x = {.label = "radius [m]", .low = 0, .high = {}},
              .y = {.label = "time [ms]", .low = 0, .high = {}},
              .views = {{.keys = {},
                         .series = {Curve("with pyramid", kOursColor, x, sheet.Add(with)),
                                    Curve("without", kPublishedColor, x, sheet.Add(without)),
                                    Curve("AlchemyAO", kDataColor, x, sheet.Add(alchemy),
                                          Mark::kDashed)},
                         .x = {},
                         .y = {}}}};
    return html + sheet.Group({}, {plot});
}

std::string FlickerHtml(const SceneReport& r) {
    std::vector<std::vector<Cell>> rows;
    for (const TemporalRow& t : r.temporal) {
        const auto figure = [](const Figure& f) {
            return Cell{WithError(f.value * 1e6, f.standard_error * 1e6), "", ""};
        };
        rows.push_back({Text(t.technique), figure(t.score.candidate), figure(t.score.truth),
                        figure(t.score.flicker)});
    }
    return "<p>The camera turns by parts of a pixel, " + std::to_string(r.temporal_frames) +
           " frames. Variance of a pixel over the frames, times 10⁶, averaged over the "
           "picture: of the technique, of the truth (which changes at edges), and of the "
           "error alone: what the eye sees as flicker.</p>" +
           Table({{"technique"}, {"technique [10⁻⁶]"}, {"truth [10⁻⁶]"}, {"flicker [10⁻⁶]"}},
                 rows);
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
    Page page("Ambient obscurance of " + r.scene,
              "camera " + r.camera + ", radius " + Digits(r.radius_m) + " m");
    PlotSheet& sheet = page.Plots();
    page.AddSection("findings", "What it finds", Findings(r));
    page.AddSection("truth", "The truth", TruthHtml(r));
    page.AddSection("scores", "Techniques against the truth", ScoresHtml(r));
    page.AddSection("pictures", "Where they err", PicturesHtml(r));
    if (!r.budget.empty()) page.AddSection("budget", "Error budget", BudgetHtml(r));
    if (!r.sweep.empty())
        page.AddSection("sweep", "Error against run time", SweepHtml(r, sheet));
    if (!r.times.empty()) page.AddSection("times", "Time", TimesHtml(r, sheet));
    if (r.precision) {
        page.AddSection("depth", "What the depth buffer keeps", DepthHtml(*r.precision, sheet));
    }
    if (!r.temporal.empty()) page.AddSection("flicker", "Flicker", FlickerHtml(r));
    page.AddSection("again", "How to make this again", AgainHtml(r));
    return page.Text();
}

}  // namespace plumb
