// The inner loop of the sampling pass: many pixels at once, in float.
//
//       v = (z_i - z_C) S + z_i (a_x d_x, a_y d_y, 0),      S = (s_x, s_y, 1) = C / z_C
//
// with (d_x, d_y) the tap's offset in pixels: no difference of large numbers, so that a plane
// that faces the eye gives v.n = 0 exactly.
//
// Symbols  as in obscurance_pass.h; a_x, a_y what one pixel adds to s_x, s_y.
// Beware   No operation is fused: the bits do not depend on the machine's vectors.
#pragma once

#include <cstdint>
#include <vector>

#include "core/image.h"
#include "core/vec.h"
#include "screen_space/sao/obscurance_pass.h"

namespace plumb {

/// One tap of every pixel, before it is turned.
struct TapInTable {
    float alpha = 0;       ///< h_i / r'
    float cosine = 0;      ///< Of its angle ...
    float sine = 0;        ///< ...
    float spiral_rad = 0;  ///< ... which kFloat32 adds to phi.
};

/// What all pixels share.
struct ObscuranceTask {
    ObscuranceTask(const GBuffer& gbuffer, const ZPyramid& pyramid,
                   const ObscuranceOptions& options);

    const ZPyramid* pyramid = nullptr;
    const Image<Vec3f>* normals = nullptr;     ///< nullptr = from depth
    int width = 0, height = 0;                 ///< Drawn.
    float a_x = 0, b_x = 0, a_y = 0, b_y = 0;  ///< s = a (pixel + 1/2) + b
    float disc = 0;                            ///< r' = disc / -z
    float steepest_area = 0;                   ///< 0 = any
    ObscuranceOptions options;
    std::vector<TapInTable> taps;
    float bias = 0, bias_per_depth = 0, epsilon = 0;
    float per_r2 = 0;   ///< 1 / r^2
    float most_vv = 0;  ///< Beyond it a tap adds nothing.
    float per_tap = 0;  ///< The sum of what taps add times this is what A lacks of 1.
};

/// A of the pixels of `where`, written to `A`.
void ObscureTile(const ObscuranceTask& task, const PixelRect& where, Image<float>& A);

}  // namespace plumb
