// How much a technique flickers while the camera moves a little.
//
//       candidate   mean over pixels of Var_t c              Var over the F frames, F - 1
//       truth       mean over pixels of ( Var_t t - mean_t s^2 )
//       flicker     mean over pixels of ( Var_t (c - t) - mean_t s^2 )
//
// A picture must change when the camera moves: that is no fault. The flicker is the variance
// of the error alone: 0 for a technique that is wrong in the same way in every frame.
//
// Source   ours; intervals over tiles: score/over_tiles.h.
// Symbols  c candidate, t measured truth, s its standard error.
// Beware   The noise of the truth must be independent from frame to frame: give every frame a
//          seed of its own, else too much is subtracted. noise_error is not known here.
#pragma once

#include <span>

#include "core/image.h"
#include "score/errors.h"
#include "score/over_tiles.h"

namespace plumb {

struct MeanAndVariance {
    Image<float> mean, variance;  ///< Of a pixel over the frames; with F - 1.
};

/// Of at least two frames of one size. Throws Error otherwise.
MeanAndVariance OverFrames(std::span<const Image<float>> frames);

struct TemporalScore {
    Measured candidate, truth, flicker;
};

/// As many frames of each; `standard_errors` may be empty. The mask holds for every frame.
TemporalScore ScoreTemporal(std::span<const Image<float>> candidates,
                            std::span<const Image<float>> truths,
                            std::span<const Image<float>> standard_errors = {},
                            const Mask& mask = {}, const ErrorOptions& options = {});

}  // namespace plumb
