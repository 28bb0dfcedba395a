// FLIP: how different two pictures look when one takes the other's place on a screen.
//
//       FLIP = E^(1 - f)                                                per pixel, in [0, 1]
//       E    colour difference of what an eye sees of both          score/flip_colour.h
//       f    = ( max(| |e_c| - |e_t| |, | |p_c| - |p_t| |) / sqrt 2 )^0.5
//
// where both pictures are filtered by the contrast sensitivity of the eye before E is taken,
// and e = (G'x Gy, Gx G'y), p = (G''x Gy, Gx G''y) are edges and points of the unfiltered luma
// (Y + 16) / 116 (score/flip_filters.h). Beyond the frame the picture's border goes on.
//
// The mean over pixels is the usual figure. Weighted quantiles count a pixel as often as it is
// wrong, so that a large part without error does not hide the rest: score/quantiles.h.
//
// Source   [Andersson20] P. Andersson, J. Nilsson, T. Akenine-Moller, M. Oskarsson, K. Astrom,
//          M. Fairchild, FLIP: A Difference Evaluator for Alternating Images, Proc. ACM on
//          Computer Graphics and Interactive Techniques 3(2), HPG 2020.
// Symbols  c candidate, t reference; ppd pixels a degree.
// Domain   Linear sRGB, finite; clamped to [0, 1]. Any size from one pixel on.
// Beware   A figure for data in [0, 1] that a screen shows: for high dynamic range see
//          score/flip_hdr.h. Noise in the reference is seen as error, and is not taken off.
// Cost     two passes of 7 filters of up to 21 taps, 12 cube roots, 2 powers a pixel; measured:
//          docs/score.md.
#pragma once

#include <numbers>

#include "core/image.h"
#include "score/errors.h"
#include "score/over_tiles.h"

namespace plumb {

/// Of a screen 0.7 m wide with 3840 pixels, seen from 0.7 m: 67.02.
inline constexpr double kFlipPixelsPerDegree = 0.7 * (3840 / 0.7) * std::numbers::pi / 180;

struct FlipOptions {
    double pixels_per_degree = kFlipPixelsPerDegree;  ///< ppd. [1, 1000]
};

/// FLIP at each pixel. Throws Error where sizes differ or a pixel is not finite.
Image<float> FlipMap(const Image<Rgb>& candidate, const Image<Rgb>& reference,
                     const FlipOptions& options = {});

/// Mean of a map over the pixels of `mask` (empty: all), with the interval of the tiles. Throws
/// Error where one that counts is not finite. Of the options, confidence and tiles are used.
Measured MeanOverTiles(const Image<float>& map, const Mask& mask = {},
                       const ErrorOptions& options = {});

}  // namespace plumb
