// How wrong a formula is on samples: weighted root mean square, worst case, and broken values.
//
//       rms = sqrt( Sum w (f - y)^2 / Sum w )        max = max |f - y|
//
// over the samples of weight > 0 at which f is finite; where it is not, that is a pole and is
// counted. A score over several maps gives every map the same say: rms^2 is the mean of theirs.
//
// Symbols  f predicted, y measured, w weight of a sample.
// Beware   On a histogram, w = n_bin / n_map and every albedo counts the same. The score is of
//          bin means: what scatters within a bin (the floor of any such formula) is not in it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/bounce_histogram.h"
#include "fit/model.h"
#include "fit/samples.h"

namespace plumb {

struct Score {
    double rms = 0;
    double max_abs = 0;
    int samples = 0;       ///< Of weight > 0.
    int poles = 0;         ///< Predictions that are not finite.
    int out_of_range = 0;  ///< Finite predictions outside [0, 1]: light lost or made.
};

/// A formula's record over several maps.
struct ScoreRow {
    std::string formula;
    std::vector<Score> maps;  ///< In the order of the histograms given.
    Score pooled;
};

Score ScoreOf(const Formula& formula, std::span<const Sample> samples);

/// E(rho) of the formula on one map.
Score ScoreOf(const Formula& formula, const BounceHistogram& map);

ScoreRow ScoreOver(const Formula& formula, std::span<const BounceHistogram> maps);

/// Every map the same say; max, samples and counts are gathered.
Score Pooled(std::span<const Score> scores);

}  // namespace plumb
