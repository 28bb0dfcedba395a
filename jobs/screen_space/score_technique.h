// One picture against every truth of its view, over every region.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/image.h"
#include "jobs/truth/view_truth.h"
#include "score/errors.h"
#include "score/regions.h"

namespace plumb {

/// The truths' names in a report.
inline const std::string kTruthV = "V", kTruthNear = "V within r",
                         kTruthWeighted = "V within r, weighted";

std::string NameOf(Falloff falloff);

/// One picture against one truth.
struct ScoreAgainst {
    std::string truth;   ///< One of the names above.
    std::string region;  ///< "whole", "edges", "interiors", "border"
    ErrorScore error;
    Measured ssim;
    Measured recalibrated_rmse;  ///< Held out: after the best monotone change of contrast.
};

/// The score against that truth over that region; nullptr if there is none.
const ScoreAgainst* FindScore(const std::vector<ScoreAgainst>& scores, const std::string& truth,
                              const std::string& region);

/// The same; throws Error if there is none.
const ScoreAgainst& Against(const std::vector<ScoreAgainst>& scores, const std::string& truth,
                            const std::string& region = "whole");

/// What one camera says.
struct ViewScores {
    std::string camera;
    std::vector<ScoreAgainst> scores;
};

/// Regions of the shown picture, from the truth's own depths and normals.
Regions RegionsOf(const ViewTruth& truth);

/// One truth, one region, all figures but SSIM. `recalibrated`, if it is given, becomes A as its
/// best monotone change of contrast leaves it (score/recalibration.h).
ScoreAgainst ScoreOver(const Image<float>& A, const TruthImage& truth, const std::string& name,
                       const std::string& region, const Mask& mask,
                       Image<float>* recalibrated = nullptr);

/// V, V within r, and V within r weighted by `falloff`, each over whole, edges, interiors and
/// border. Regions without a pixel are left out. `recalibrated` to V within r over the whole.
std::vector<ScoreAgainst> ScoreAll(const Image<float>& A, const ViewTruth& truth,
                                   const Regions& regions, Falloff falloff,
                                   Image<float>* recalibrated = nullptr);

/// The same of several views as one: every truth and region that some view has, each over the views
/// that have it (score/over_views.h).
std::vector<ScoreAgainst> OverViews(std::span<const ViewScores> views);

}  // namespace plumb
