#include "score/temporal.h"

#include <vector>

#include "core/error.h"
#include "core/statistics.h"
#include "score/pixels.h"

namespace plumb {
namespace {

void CheckFrames(std::span<const Image<float>> frames) {
    if (frames.size() < 2) throw Error(MustBe("frames", double(frames.size()), ">= 2"));
    for (const Image<float>& frame : frames) CheckSizes(frame, frames[0], {}, {});
}

}  // namespace

MeanAndVariance OverFrames(std::span<const Image<float>> frames) {
    CheckFrames(frames);
    const int width = frames[0].Width(), height = frames[0].Height();
    MeanAndVariance result{Image<float>(width, height), Image<float>(width, height)};
    for (std::size_t k = 0; k < frames[0].Pixels().size(); ++k) {
        Moments moments;
        for (const Image<float>& frame : frames) moments.Add(frame.Pixels()[k]);
        result.mean.Pixels()[k] = float(moments.Mean());
        result.variance.Pixels()[k] = float(moments.Variance());
    }
    return result;
}

TemporalScore ScoreTemporal(std::span<const Image<float>> candidates,
                            std::span<const Image<float>> truths,
                            std::span<const Image<float>> standard_errors, const Mask& mask,
                            const ErrorOptions& options) {
    Validate(options);
    CheckFrames(candidates);
    const std::size_t F = candidates.size();
    if (truths.size() != F)
        throw Error(MustBe("frames of the truth", double(truths.size()),
                           "as many as of the candidate"));
    if (!standard_errors.empty() && standard_errors.size() != F)
        throw Error(MustBe("frames of standard errors", double(standard_errors.size()),
                           "as many as of the candidate"));
    const Image<float> none;
    for (std::size_t f = 0; f < F; ++f) {
        CheckSizes(candidates[0], truths[f],
                   standard_errors.empty() ? none : standard_errors[f], mask);
    }
    const Tiling tiling(candidates[0].Width(), candidates[0].Height(), options.tile_px);
    std::vector<double> of_c(tiling.Count(), 0), of_t = of_c, of_d = of_c;
    std::vector<std::int64_t> n(tiling.Count(), 0);
    ForEachCounted(tiling, {}, mask, [&](int tile, int i, int j, double) {
        Moments c, t, d, s2;
        for (std::size_t f = 0; f < F; ++f) {
            const double candidate = FinitePixel(candidates[f], i, j, "candidate");
            const double truth = FinitePixel(truths[f], i, j, "truth");
            c.Add(candidate);
            t.Add(truth);
            d.Add(candidate - truth);
            const double s = standard_errors.empty()
                                 ? 0
                                 : FinitePixel(standard_errors[f], i, j, "standard error");
            s2.Add(s * s);
        }
        ++n[tile];
        of_c[tile] += c.Variance();
        of_t[tile] += t.Variance() - s2.Mean();
        of_d[tile] += d.Variance() - s2.Mean();
    });
    return {RatioOverTiles(tiling, of_c, n, options.confidence),
            RatioOverTiles(tiling, of_t, n, options.confidence),
            RatioOverTiles(tiling, of_d, n, options.confidence)};
}

}  // namespace plumb
