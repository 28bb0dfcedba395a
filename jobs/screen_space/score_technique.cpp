#include "jobs/screen_space/score_technique.h"

#include <algorithm>
#include <utility>

#include "score/over_views.h"
#include "score/recalibration.h"
#include "score/ssim.h"

namespace plumb {

std::string NameOf(Falloff falloff) {
    switch (falloff) {
        case Falloff::kHard:
            return "hard";
        case Falloff::kLinear:
            return "linear";
        case Falloff::kSao:
            return "sao";
        case Falloff::kQuadratic:
            return "quadratic";
        case Falloff::kFarEnd:
            return "far end";
    }
    return "";
}

Regions RegionsOf(const ViewTruth& truth) {
    return FindRegions(truth.pixels.depth_m, truth.pixels.normal);
}

ScoreAgainst ScoreOver(const Image<float>& A, const TruthImage& truth, const std::string& name,
                       const std::string& region, const Mask& mask,
                       Image<float>* recalibrated) {
    const ErrorOptions options{.truth_dof = kTruthNets - 1.0};
    ScoreAgainst score{
        .truth = name, .region = region, .error = {}, .ssim = {}, .recalibrated_rmse = {}};
    score.error = ScoreErrors(A, truth.value, truth.standard_error, mask, options);
    RecalibrationScore after =
        ScoreRecalibrated(A, truth.value, truth.standard_error, mask, options);
    score.recalibrated_rmse = after.held_out.rmse;
    if (recalibrated) *recalibrated = std::move(after.picture);
    return score;
}

std::vector<ScoreAgainst> ScoreAll(const Image<float>& A, const ViewTruth& truth,
                                   const Regions& regions, Falloff falloff,
                                   Image<float>* recalibrated) {
    std::vector<std::pair<std::string, const TruthImage*>> truths{
        {kTruthNear, &truth.near.at(Falloff::kHard)}};
    if (!truth.V.value.Empty()) truths.insert(truths.begin(), {kTruthV, &truth.V});
    truths.push_back({kTruthWeighted, &truth.near.at(falloff)});
    const std::pair<std::string, const Mask*> masks[] = {{"whole", &regions.seen},
                                                         {"edges", &regions.edges},
                                                         {"interiors", &regions.interiors},
                                                         {"border", &regions.border}};
    std::vector<ScoreAgainst> scores;
    for (const auto& [name, image] : truths) {
        const Image<float> ssim = SsimMap(A, image->value, image->standard_error, regions.seen);
        for (const auto& [region, mask] : masks) {
            if (CountOf(*mask) == 0) continue;
            const bool is_plain = name == kTruthNear && mask == &regions.seen;
            scores.push_back(
                ScoreOver(A, *image, name, region, *mask, is_plain ? recalibrated : nullptr));
            scores.back().ssim = ScoreSsim(ssim, *mask, {.truth_dof = kTruthNets - 1.0});
        }
    }
    return scores;
}

std::vector<ScoreAgainst> OverViews(std::span<const ViewScores> views) {
    std::vector<ScoreAgainst> all;
    const auto is_of = [](const ScoreAgainst& a) {
        return
            [&a](const ScoreAgainst& b) { return a.truth == b.truth && a.region == b.region; };
    };
    for (const ViewScores& view : views) {
        for (const ScoreAgainst& score : view.scores) {
            if (std::ranges::any_of(all, is_of(score))) continue;
            std::vector<ErrorScore> errors;
            std::vector<Measured> ssims, recalibrated;
            for (const ViewScores& other : views) {
                const auto found = std::ranges::find_if(other.scores, is_of(score));
                if (found == other.scores.end()) continue;
                errors.push_back(found->error);
                ssims.push_back(found->ssim);
                recalibrated.push_back(found->recalibrated_rmse);
            }
            all.push_back({score.truth, score.region, ScoreOverViews(errors),
                           MeanOverViews(ssims), RootMeanSquareOverViews(recalibrated)});
        }
    }
    return all;
}

}  // namespace plumb
