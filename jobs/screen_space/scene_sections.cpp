#include "jobs/screen_space/scene_sections.h"

#include <algorithm>
#include <cmath>

#include "core/names.h"
#include "jobs/bench_facts.h"
#include "jobs/screen_space/score_columns.h"
#include "reports/text.h"

namespace plumb {
namespace {

double RmsError(const TruthImage& truth, const Mask& mask) {
    double squares = 0, n = 0;
    for (std::size_t p = 0; p < mask.Pixels().size(); ++p) {
        if (mask.Pixels()[p] == 0) continue;
        const double error = truth.standard_error.Pixels()[p];
        squares += error * error;
        ++n;
    }
    return n > 0 ? std::sqrt(squares / n) : 0;
}

double RmsErrorNear(const MeasuredView& view) {
    return RmsError(view.truth.near.at(Falloff::kHard), view.regions.seen);
}

// What an interval of this report says.
std::string WhatIntervalsAre(std::size_t views) {
    if (views == 1) {
        return "Intervals are of 95 %, from the scatter of the tiles of this one view: what "
               "another picture of the same surfaces would show. Other cameras of a scene "
               "often "
               "lie outside of them: give all its cameras to tell of the scene.";
    }
    return "All " + std::to_string(views) +
           " cameras count alike. Intervals are of 95 % between views (Student's t of " +
           std::to_string(views - 1) +
           " degrees of freedom, in the logarithm for RMSE), and a ± is the standard error "
           "between views: what another camera would show, if these were picked at random. The "
           "figures of one view have intervals from the scatter of its tiles, which are "
           "shorter: "
           "they tell of that view alone.";
}

const doc::Column kTechnique = doc::Name("technique", "Technique");

doc::Section ByCamera(const SceneScores& scores) {
    doc::Table table{.key = "rmse_by_camera",
                     .columns = {kTechnique, doc::Name("camera", "Camera"), RmseColumn()},
                     .judged = true,
                     .across = "camera"};
    for (const TechniqueScore& t : scores.techniques) {
        for (const ViewScores& view : t.views) {
            table.Add({t.name, view.camera, Against(view.scores, kTruthNear).error.rmse});
        }
    }
    return {.id = "by_camera",
            .title = "RMSE by camera",
            .sentences = {"Against V within r; 95 % intervals from the tiles of each view."},
            .tables = {std::move(table)}};
}

doc::Section ByTruth(const SceneScores& scores) {
    const struct {
        std::string title, truth, region;
    } kinds[] = {{"V", kTruthV, "whole"},
                 {"V within r", kTruthNear, "whole"},
                 {"… weighted by its falloff", kTruthWeighted, "whole"},
                 {"edges", kTruthNear, "edges"},
                 {"interiors", kTruthNear, "interiors"},
                 {"border", kTruthNear, "border"}};
    doc::Table table{.key = "rmse_by_truth",
                     .columns = {kTechnique, doc::Name("falloff", "Falloff"),
                                 doc::Name("against", "Against"), RmseColumn()},
                     .judged = true,
                     .across = "against"};
    for (const TechniqueScore& t : scores.techniques) {
        for (const auto& [title, truth, region] : kinds) {
            const ScoreAgainst* score = FindScore(t.scores, truth, region);
            if (score) table.Add({t.name, NameOf(t.falloff), title, score->error.rmse});
        }
    }
    return {.id = "by_truth",
            .title = "RMSE by truth and by region",
            .sentences = {"A technique counts distant things less: its own falloff. The truth "
                          "weighted by that same falloff is what it means to compute; the "
                          "regions are scored against V within r."},
            .tables = {std::move(table)}};
}

doc::Section Passes(const SceneScores& scores) {
    doc::Table table{.key = "passes",
                     .columns = {kTechnique, doc::Name("pass", "Pass"),
                                 TimeColumn("pass_ms", "Time of a pass", "ms")},
                     .across = "pass"};
    for (const TechniqueScore& t : scores.techniques) {
        for (const PassSeconds& pass : t.timed.passes) {
            table.Add({t.name, pass.name, 1e3 * pass.seconds});
        }
    }
    return {
        .id = "passes", .title = "Pass by pass", .folded = true, .tables = {std::move(table)}};
}

void AddTechniqueColumns(doc::Table& table) {
    table.columns.push_back({.key = "samples", .title = "Lookups or rays"});
    table.columns.push_back(TimeColumn("ms", "Time", "ms"));
    AddScoreColumns(table, {"bias", "mae", "rmse", "psnr_db", "ssim", "recalibrated_rmse"});
}

void AddRow(doc::Table& table, std::vector<doc::Cell> row, const TechniqueScore& technique,
            const ScoreAgainst& score) {
    row.insert(row.end(), {technique.samples, 1e3 * technique.timed.seconds});
    AddScore(score, row);
    table.Add(std::move(row));
}

doc::Table EveryScore(const SceneScores& scores) {
    doc::Table table{.key = "scores",
                     .columns = {kTechnique, doc::Name("view", "View"),
                                 doc::Name("truth", "Truth"), doc::Name("region", "Region")},
                     .data = true};
    AddTechniqueColumns(table);
    for (const TechniqueScore& t : scores.techniques) {
        std::vector<ViewScores> views = t.views;
        views.insert(views.begin(), {kAllViews, t.scores});
        for (const ViewScores& view : views) {
            for (const ScoreAgainst& s : view.scores) {
                AddRow(table, {t.name, view.camera, s.truth, s.region}, t, s);
            }
        }
    }
    return table;
}

}  // namespace

doc::Section FindingsSection(std::span<const MeasuredView> views, const SceneScores& scores,
                             const std::vector<std::string>& notes) {
    doc::Table table{.key = "closest",
                     .columns = {doc::Name("closest", "Closest to V within r"),
                                 {.key = "technique", .title = "Technique"},
                                 RmseColumn(),
                                 TimeColumn("ms", "Time", "ms"),
                                 {.key = "ties", .title = "Not told apart from it"}}};
    const auto add = [&](const std::string& how, const Closest& closest,
                         Measured ScoreAgainst::*recalibrated) {
        const TechniqueScore& best =
            *std::ranges::find(scores.techniques, closest.name, &TechniqueScore::name);
        const ScoreAgainst& score = Against(best.scores, kTruthNear);
        table.Add({how, best.name, recalibrated ? score.*recalibrated : score.error.rmse,
                   1e3 * best.timed.seconds,
                   closest.ties.empty() ? "none" : Listed(closest.ties)});
    };
    add("as it is", scores.closest, nullptr);
    add("after the best monotone change of contrast", scores.closest_recalibrated,
        &ScoreAgainst::recalibrated_rmse);
    const MeasuredView& first = views.front();
    std::vector<std::string> sentences{
        "The truth is known to " + Digits(RmsErrorNear(first), 2) +
        " a pixel (root mean square standard error of V within r, " +
        std::to_string(first.spp) + " rays); its noise is taken off every error below. " +
        std::to_string(first.truth.lost.All()) + " rays were lost."};
    for (const std::string& note : notes) sentences.push_back(doc::Verbatim(note));
    return {.id = "findings",
            .title = "What it finds",
            .listed = true,
            .sentences = std::move(sentences),
            .tables = {std::move(table)}};
}

doc::Section TruthSection(std::span<const MeasuredView> views, double radius_m) {
    doc::Table table{.key = "views",
                     .columns = {doc::Name("camera", "Camera"),
                                 {.key = "width_px", .title = "Width", .unit = "px"},
                                 {.key = "height_px", .title = "Height", .unit = "px"},
                                 {.key = "guard_px", .title = "Border", .unit = "px"},
                                 {.key = "pixels_seen", .title = "Pixels of a surface"},
                                 {.key = "spp", .title = "Rays a pixel"},
                                 {.key = "nets", .title = "Independent nets"},
                                 {.key = "rms_standard_error_v",
                                  .title = "Standard error of V",
                                  .meaning = "Root mean square over the pixels"},
                                 {.key = "rms_standard_error_near", .title = "… within r"},
                                 {.key = "lost_rays", .title = "Lost rays"},
                                 TimeColumn("truth_s", "Time", "s")}};
    for (const MeasuredView& view : views) {
        const Camera& c = view.camera;
        table.Add({c.name, c.width_px, c.height_px, view.guard_px, CountOf(view.regions.seen),
                   view.spp, kTruthNets, RmsError(view.truth.V, view.regions.seen),
                   RmsErrorNear(view), view.truth.lost.All(), view.truth_s});
    }
    return {
        .id = "truth",
        .title = "The truth",
        .sentences = {"Path-traced from the pixel's centre. V sees the whole scene; V within "
                      "r counts only what is nearer than " +
                      Digits(radius_m) +
                      " m, which is what a screen-space method is meant to find."},
        .tables = {std::move(table)}};
}

doc::Section ScoresSection(std::span<const MeasuredView> views, const SceneScores& scores,
                           int rounds) {
    doc::Table table{.key = "techniques", .columns = {kTechnique}, .judged = true};
    AddTechniqueColumns(table);
    for (const TechniqueScore& t : scores.techniques) {
        AddRow(table, {t.name}, t, Against(t.scores, kTruthNear));
    }
    doc::Section section{
        .id = "scores",
        .title = "Techniques against the truth",
        .sentences =
            {"Against V within r, over all pixels that show a surface. " +
             WhatIntervalsAre(views.size()) +
             " Techniques are compared with each other pixel by pixel, which tells more "
             "apart. *Recalibrated*: RMSE that is left after the best monotone change "
             "of contrast, fitted to other tiles than it is scored on: what no tone "
             "curve mends. Times are of camera " +
             doc::Verbatim(views.front().camera.name) + ", medians of " +
             std::to_string(rounds) + " rounds with the least and the greatest."},
        .tables = {std::move(table), EveryScore(scores)}};
    if (views.size() > 1) section.sections.push_back(ByCamera(scores));
    section.sections.push_back(ByTruth(scores));
    section.sections.push_back(Passes(scores));
    return section;
}

doc::Section PicturesSection(const MeasuredView& first, const SceneScores& scores) {
    doc::Section section{
        .id = "pictures",
        .title = "Where they err",
        .sentences = {
            "Left the technique's picture, right its error against V within r: blue is "
            "too dark by 0.25 or more, white is right, red is too bright by 0.25 or "
            "more, the sky is grey. The scale is the same in all pictures. Camera " +
            doc::Verbatim(first.camera.name) + "."}};
    for (const TechniqueScore& t : scores.techniques) {
        if (t.picture.empty()) continue;
        const Measured& rmse = Against(t.views.front().scores, kTruthNear).error.rmse;
        std::string id = "picture_" + t.name;
        std::ranges::replace(id, '-', '_');
        section.sections.push_back({.id = std::move(id),
                                    .title = t.name,
                                    .pictures = {{t.picture, t.name, "A"},
                                                 {t.signed_error, "error of " + t.name,
                                                  "error, RMSE " + Digits(rmse.value)}}});
    }
    return section;
}

std::string ViewsText(std::span<const MeasuredView> views) {
    std::vector<std::string> names;
    for (const MeasuredView& view : views) names.push_back(view.camera.name);
    return (views.size() == 1 ? "camera " : "cameras ") + Listed(names);
}

}  // namespace plumb
