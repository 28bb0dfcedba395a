#include "score/recalibration.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/parallel.h"
#include "score/pixels.h"

namespace plumb {
namespace {

constexpr int kFolds = 5;

/// Folds stand a knight's move apart, so that each is spread evenly over rows and columns.
int FoldOf(const Tiling& tiling, int i, int j) {
    return (i / tiling.tile_px + 2 * (j / tiling.tile_px)) % kFolds;
}

bool Counts(const Mask& mask, int i, int j) {
    return mask.Empty() || mask(i, j) != 0;
}

}  // namespace

RecalibrationScore ScoreRecalibrated(const Image<float>& candidate, const Image<float>& truth,
                                     const Image<float>& standard_error, const Mask& mask,
                                     const ErrorOptions& options) {
    Validate(options);
    CheckSizes(candidate, truth, standard_error, mask);
    const Tiling tiling(truth.Width(), truth.Height(), options.tile_px);

    // Number kFolds is the fit to all.
    std::array<std::vector<MonotoneSample>, kFolds + 1> samples;
    for (int j = 0; j < truth.Height(); ++j) {
        for (int i = 0; i < truth.Width(); ++i) {
            if (!Counts(mask, i, j)) continue;
            const MonotoneSample sample{FinitePixel(candidate, i, j, "candidate"),
                                        FinitePixel(truth, i, j, "truth")};
            for (int fold = 0; fold <= kFolds; ++fold) {
                if (fold != FoldOf(tiling, i, j)) samples[fold].push_back(sample);
            }
        }
    }
    RecalibrationScore score;
    if (samples[kFolds].empty()) return score;
    const std::size_t all = samples[kFolds].size();
    const bool every_fold_counts =
        std::all_of(samples.begin(), samples.end() - 1,
                    [&](const auto& others) { return !others.empty() && others.size() < all; });

    std::array<MonotoneMap, kFolds + 1> maps;
    ParallelFor(kFolds + 1, 1, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t fold = begin; fold < end; ++fold)
            maps[fold] = FitMonotone(std::move(samples[fold]));
    });
    Image<float> fitted = truth, held_out = truth;
    for (int j = 0; j < truth.Height(); ++j) {
        for (int i = 0; i < truth.Width(); ++i) {
            if (!Counts(mask, i, j)) continue;
            fitted(i, j) = float(maps[kFolds](candidate(i, j)));
            if (every_fold_counts)
                held_out(i, j) = float(maps[FoldOf(tiling, i, j)](candidate(i, j)));
        }
    }
    score.fitted = ScoreErrors(fitted, truth, standard_error, mask, options);
    if (every_fold_counts)
        score.held_out = ScoreErrors(held_out, truth, standard_error, mask, options);
    score.map = std::move(maps[kFolds]);
    return score;
}

}  // namespace plumb
