#include "jobs/screen_space/score_technique.h"

#include <utility>

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
                       const std::string& region, const Mask& mask) {
    const ErrorOptions options{.truth_dof = kTruthNets - 1.0};
    ScoreAgainst score{
        .truth = name, .region = region, .error = {}, .ssim = {}, .recalibrated_rmse = {}};
    score.error = ScoreErrors(A, truth.value, truth.standard_error, mask, options);
    score.recalibrated_rmse =
        ScoreRecalibrated(A, truth.value, truth.standard_error, mask, options).held_out.rmse;
    return score;
}

std::vector<ScoreAgainst> ScoreAll(const Image<float>& A, const ViewTruth& truth,
                                   const Regions& regions, Falloff falloff) {
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
            scores.push_back(ScoreOver(A, *image, name, region, *mask));
            scores.back().ssim = ScoreSsim(ssim, *mask, {.truth_dof = kTruthNets - 1.0});
        }
    }
    return scores;
}

}  // namespace plumb
