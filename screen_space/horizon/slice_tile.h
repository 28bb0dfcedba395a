// HBAO, GTAO and the visibility bitmask on many pixels at once, in float.
//
//       v = (z - z_C) S + z (a_x d_x, a_y d_y, 0),      S = C / z_C,      V = S / |S|
//       acos x = sqrt(1 - x) (a_0 + a_1 x + ... + a_7 x^7),  0 <= x <= 1
//
// with (d_x, d_y) the sample's offset in whole pixels: no difference of large numbers. Angles
// are only taken where the integral asks for them; all else is done with cosines and sines.
//
// Source   acos: [Abramowitz64] 4.4.46, off by at most 2e-8. Others: hbao.h, gtao.h,
//          visibility_bitmask.h, which the functions here are tested against pixel by pixel.
// Symbols  as in slice_march.h; a_x, a_y what one pixel adds to S.
// Beware   No operation is fused: the bits do not depend on the machine's vectors. Where a
//          sample's place comes within its float's rounding of a pixel's edge, the reference
//          and this may read neighbouring pixels.
#pragma once

#include <vector>

#include "core/image.h"
#include "screen_space/horizon/gtao.h"
#include "screen_space/horizon/hbao.h"
#include "screen_space/horizon/visibility_bitmask.h"
#include "screen_space/pixel_rect.h"

namespace plumb {

/// What all pixels share.
struct SliceTask {
    SliceTask(const GBuffer& gbuffer, const SliceSampling& sampling);

    const GBuffer* gbuffer = nullptr;
    SliceSampling sampling;
    int width = 0, height = 0;                 ///< Drawn.
    float a_x = 0, b_x = 0, a_y = 0, b_y = 0;  ///< S = (a (pixel + 1/2) + b, 1)
    float px_x = 0, px_y = 0;                  ///< Pixels a metre at z = -1; y downwards.
    std::vector<float> cosine, sine;           ///< Of pi k / slices.
};

/// A of the pixels of `where`, written to `A`.
void HbaoTile(const SliceTask& task, const HbaoOptions& options, const PixelRect& where,
              Image<float>& A);
void GtaoTile(const SliceTask& task, const GtaoOptions& options, const PixelRect& where,
              Image<float>& A);
/// For at most so many sectors.
inline constexpr int kSectorsOfTile = 32;
void BitmaskTile(const SliceTask& task, const BitmaskOptions& options, const PixelRect& where,
                 Image<float>& A);

}  // namespace plumb
