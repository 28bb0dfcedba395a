// The tile of a picture that is most wrong, and how wrong it is at least.
//
//       MSE_b      = mean over tile b of (d^2 - s^2)
//       worst      = the b of the greatest MSE_b
//       at least   = max_b ( MSE_b - z se_b ),     z of the level  1 - (1 - 0.05)^(1/B)
//
// A fault of one part of a picture drowns in the mean of all of it. But of B tiles one is always
// the worst, and with a noisy truth it looks bad by chance: z is shared among all B by Sidak's
// rule, so that some tile is as wrong as `at least` says with 95 % confidence.
//
// Source   ours; se_b: `noise_error` of score/errors.h.
// Symbols  d = c - t; s the truth's standard error; B tiles with a pixel that counts.
// Beware   A tile is normal enough for z from some 30 pixels on; a mask may leave fewer.
#pragma once

#include "score/errors.h"

namespace plumb {

struct WorstTile {
    int column_px = 0, row_px = 0;  ///< Its upper left pixel.
    int width_px = 0, height_px = 0;
    int tiles = 0;  ///< B. 0: no pixel counts, all else is nothing.
    double mse = 0, mse_at_least = 0;
    double noise_error = 0;  ///< se of its MSE.
};

inline constexpr int kWorstTile_px = 32;

/// Of the options tile_px is not used.
WorstTile FindWorstTile(ChannelSpan candidate, ChannelSpan truth,
                        ChannelSpan standard_error = {}, const Mask& mask = {},
                        const ErrorOptions& options = {}, int tile_px = kWorstTile_px);

}  // namespace plumb
