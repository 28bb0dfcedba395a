// The inner loop of the bilateral blur: one row, many pixels at once, in float.
//
// Beware   No operation is fused: the bits do not depend on the machine's vectors.
#pragma once

#include "core/image.h"
#include "screen_space/sao/bilateral_blur.h"

namespace plumb {

/// A' of the pixels [x0, x1) of row y, as BlurredPixel has it, written to `to[x]`.
void BlurRow(BlurAxis axis, const Image<float>& A, const BlurGuide& guide,
             const BlurOptions& options, int y, int x0, int x1, float* to);

}  // namespace plumb
