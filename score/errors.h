// How far a picture is from the truth, the truth's own noise taken out.
//
//       d = c - t,   t = T + noise,   E[noise] = 0,   E[noise^2] = s^2
//
//       bias       mean d
//       MAE        mean |d|
//       MSE        mean (d^2 - s^2)           E[d^2] = (c - T)^2 + s^2: that of the truth
//       RMSE       sqrt MSE                   0 where noise made the MSE negative
//       PSNR       10 log10(1 / MSE)          infinite where it is not positive
//       psnr_paper 10 log10(255^2 / MSE)      48.13 dB more: what [Hollander13] prints
//
// over the pixels of a mask. Intervals: score/over_tiles.h; those of RMSE and PSNR are the
// interval of the MSE, carried over. What the noise of the truth alone does to the bias and
// the MSE of this picture, the pixels' noises being independent and nearly normal:
//
//       Var bias = Sum s^2 / N^2,    Var MSE = Sum v / N^2
//       v = 4 d^2 s^2 - 4 s^4 + (2 + 10/nu) s^4 nu / (nu + 2)
//
// where nu is the degrees of freedom of each s. (Var(d^2 - s^2) = 4 e^2 sigma^2 + 2 sigma^4 +
// 2 sigma^4 / nu with e = c - T; d^2 s^2 - s^4 has the mean e^2 sigma^2 - 2 sigma^4 / nu, and
// s^4 the mean sigma^4 (nu + 2) / nu. v is unbiased; for an s known exactly it is 4 d^2 s^2 -
// 2 s^4.)
//
// The MAE cannot be freed of noise without bias: |e| has a kink. Normal noise only raises it,
//
//       0 <= E|d| - |e| <= sqrt(2/pi) sigma exp(-e^2 / (2 sigma^2))
//                       <= sqrt(2/pi) sigma exp(-e^2 / (4 sigma^2))
//                        = E[ 2/sqrt(pi) sigma exp(-d^2 / (2 sigma^2)) ]
//
// so the mean of 2/sqrt(pi) s exp(-d^2 / 2 s^2) bounds what noise added: `mae_noise_bias`.
// `mae` is mean |d| as it is; the lower end of its interval lies lower by that bound.
//
// Of a colour the means run over its channels too. The channels of a pixel come from the same
// paths, so their noises are alike by an unknown share: Var bias and Var MSE are then taken as
// large as they can be, C times the above for C channels.
//
// Source   ours, but for the definitions; psnr_paper as shared by the paper's tables 1 to 3.
// Symbols  c candidate, t measured truth, s its standard error, T truth.
// Domain   Images of one size, finite where the mask counts. No standard errors: s = 0.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/image.h"
#include "score/over_tiles.h"

namespace plumb {

/// A picture by its channels, all of one size: one of a scalar, three of a colour.
using Channels = std::vector<Image<float>>;
using ChannelSpan = std::span<const Image<float>>;

struct ErrorOptions {
    double confidence = 0.95;  ///< Of every interval. (0, 1)
    int tile_px = 0;           ///< Edge of a tile; 0: about 256 tiles. [0, 65536]
    /// nu: the truth's standard error has this many degrees of freedom: replicates - 1.
    double truth_dof = 7;  ///< (0, infinity]
};

/// Throws Error, naming field, value and rule.
void Validate(const ErrorOptions& options);

struct ErrorScore {
    std::int64_t pixels = 0;  ///< Counted. 0: every figure is NaN.
    int tiles = 0;            ///< With at least one of them.

    Measured bias, mae, mse, rmse, psnr_db, psnr_paper_db;
    double mae_noise_bias = 0;  ///< Noise raised `mae` by this at most.
    double truth_variance = 0;  ///< mean s^2: what was taken off the mean of d^2.

    double max = 0;  ///< Greatest |d|, its noise included.
    int max_column = 0, max_row = 0, max_channel = 0;
    /// Some pixel is off by this at least, with the confidence of the options: the greatest
    /// |d| - z s, z shared among all pixels by Sidak's rule. 0 where that is negative.
    double max_at_least = 0;
};

/// `standard_error` and `mask` may be empty. Throws Error where sizes differ or where a pixel
/// that counts is not finite. Cost: one pass.
ErrorScore ScoreErrors(const Image<float>& candidate, const Image<float>& truth,
                       const Image<float>& standard_error = {}, const Mask& mask = {},
                       const ErrorOptions& options = {});

/// The same of all channels together: as many of each, `standard_error` none or as many.
ErrorScore ScoreChannels(ChannelSpan candidate, ChannelSpan truth,
                         ChannelSpan standard_error = {}, const Mask& mask = {},
                         const ErrorOptions& options = {});

/// MSE of one tile, with the standard error that the truth's noise gives it.
struct TileError {
    std::int64_t numbers = 0;  ///< Counted: pixels times channels. 0: the rest is 0.
    double mse = 0, noise_error = 0;
};

/// Of every tile, in the order of Tiling::TileOf.
std::vector<TileError> ScoreTiles(ChannelSpan candidate, ChannelSpan truth,
                                  ChannelSpan standard_error = {}, const Mask& mask = {},
                                  const ErrorOptions& options = {});

/// MSE of a less MSE of b, from (a - b)(a + b - 2 t): linear in t, so that the noise of a
/// shared truth cancels but for noise_error. Its interval tells whether one technique beats
/// another.
Measured CompareMse(const Image<float>& a, const Image<float>& b, const Image<float>& truth,
                    const Image<float>& standard_error = {}, const Mask& mask = {},
                    const ErrorOptions& options = {});

Measured CompareChannels(ChannelSpan a, ChannelSpan b, ChannelSpan truth,
                         ChannelSpan standard_error = {}, const Mask& mask = {},
                         const ErrorOptions& options = {});

/// RMSE and PSNR of an MSE. Both are monotone in it: its interval carries over end by end.
Measured RmseOf(const Measured& mse);
Measured PsnrOf(const Measured& mse, double peak);

/// 10 log10(peak^2 / mse); infinite for mse <= 0.
double PsnrDb(double mse, double peak = 1);

inline constexpr double kPaperPeak = 255;  ///< Of [Hollander13], whose data are in [0, 1].

}  // namespace plumb
