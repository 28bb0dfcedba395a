// Structural similarity of a picture to the truth, the truth's own noise taken out.
//
//                (2 mu_c mu_t + C1) (2 sigma_ct + C2)
//       SSIM = -----------------------------------------------,   C1 = (K1 L)^2, C2 = (K2 L)^2
//              (mu_c^2 + mu_t^2 + C1) (sigma_c^2 + sigma_t^2 + C2)
//
// with means, variances and the covariance of a window of 11 x 11 pixels about each pixel,
// weighted by a Gaussian of 1.5 pixels; K1 = 0.01, K2 = 0.03, L = 1 for data in [0, 1]. The
// score is the mean over the windows that lie in the picture whole.
//
// Independent noise of standard error s leaves mu_t and sigma_ct where they are on average,
// and
//
//       E[mu_t^2]    = mu_T^2    + q              p = Sum w s^2
//       E[sigma_t^2] = sigma_T^2 + p - q          q = Sum w^2 s^2
//
// p and q are subtracted, and what then falls below 0 is set to 0. What is left of the noise
// is of second order: a ratio of noisy numbers is not unbiased.
//
// Source   [Wang04] Z. Wang, A. Bovik, H. Sheikh, E. Simoncelli, Image Quality Assessment:
//          From Error Visibility to Structural Similarity, IEEE Trans. Image Processing 13(4),
//          2004. The correction: ours.
// Symbols  c candidate, t measured truth, T truth, w weights of the window (their sum is 1).
// Domain   Images of one size, finite where the mask `seen` counts.
// Beware   Pixels that are not `seen` weigh nothing in any window, else the sky, the same in
//          every picture, would be praised. [Nilsson20] shows what else SSIM is blind to: read
//          it beside the RMSE, never alone. Measured::noise_error is not known for it.
#pragma once

#include <cstdint>

#include "core/image.h"
#include "score/errors.h"
#include "score/over_tiles.h"

namespace plumb {

inline constexpr int kSsimReach = 5;  ///< Pixels from the middle of the window to its edge.
inline constexpr double kSsimSigma_px = 1.5, kSsimK1 = 0.01, kSsimK2 = 0.03;

/// SSIM at each pixel; NaN where the window is cut by the frame or its middle is not seen.
/// Cost: about 200 multiplications a pixel.
Image<float> SsimMap(const Image<float>& candidate, const Image<float>& truth,
                     const Image<float>& standard_error = {}, const Mask& seen = {});

/// Mean of the map over the pixels of `mask` (empty: all) where it is not NaN. Of the options,
/// the confidence and the tiles are used.
Measured ScoreSsim(const Image<float>& map, const Mask& mask = {},
                   const ErrorOptions& options = {});

}  // namespace plumb
