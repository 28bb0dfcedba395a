#include "jobs/screen_space/score_technique.h"

#include <algorithm>
#include <utility>

#include "core/error.h"
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

const ScoreAgainst* FindScore(const std::vector<ScoreAgainst>& scores, const std::string& truth,
                              const std::string& region) {
    const auto found = std::ranges::find_if(scores, [&](const ScoreAgainst& score) {
        return score.truth == truth && score.region == region;
    });
    return found == scores.end() ? nullptr : &*found;
}

const ScoreAgainst& Against(const std::vector<ScoreAgainst>& scores, const std::string& truth,
                            const std::string& region) {
    if (const ScoreAgainst* score = FindScore(scores, truth, region)) return *score;
    throw Error("no score against \"" + truth + "\", region \"" + region + "\"");
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
    for (const ViewScores& view : views) {
        for (const ScoreAgainst& score : view.scores) {
            if (FindScore(all, score.truth, score.region)) continue;
            std::vector<ErrorScore> errors;
            std::vector<Measured> ssims, recalibrated;
            for (const ViewScores& other : views) {
                const ScoreAgainst* same = FindScore(other.scores, score.truth, score.region);
                if (same == nullptr) continue;
                errors.push_back(same->error);
                ssims.push_back(same->ssim);
                recalibrated.push_back(same->recalibrated_rmse);
            }
            all.push_back({score.truth, score.region, ScoreOverViews(errors),
                           MeanOverViews(ssims), RootMeanSquareOverViews(recalibrated)});
        }
    }
    return all;
}

}  // namespace plumb
