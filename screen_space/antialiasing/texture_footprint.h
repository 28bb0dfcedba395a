// What of a texture a sample stands for, and the mean over it: anisotropic filtering.
//
//       P_x = |d(u W, v H)/dx|,  P_y likewise,  P_max, P_min the larger and the smaller
//       N = min( ceil(P_max / P_min), most taps ),   level = log2(P_max / N)
//       rho = 1/N Sum_{i=1}^N  Trilinear( uv + (i / (N + 1) - 1/2) d(uv), level )
//
// d(uv) along the longer axis. A sample of a pixel shaded k times stands for 1/k of the pixel: m /
// sqrt(k) samples of the enlarged picture along each edge, so derivatives are scaled by that.
//
// Source   [Hollander13] section 4.1: "computing the derivatives of the texture coordinates in the
//          G-buffer and taking into account the number of used samples"; taps and level: OpenGL's
//          extension EXT_texture_filter_anisotropic.
// Symbols  W, H size of the texture; x, y samples of the enlarged picture.
// Beware   Differences of neighbouring samples, as a shader takes them, are nonsense where the
//          neighbour shows another material or another part of the texture. The paper detects "a
//          high-order derivative in the texture layer/coordinates" and does not say what then; with
//          the border test here the neighbour on the other side is taken where it is of the same
//          material and nearer in texture, and no filter where there is none.
#pragma once

#include "core/vec.h"
#include "screen_space/antialiasing/mip_chain.h"
#include "screen_space/antialiasing/wide_gbuffer.h"

namespace plumb {

/// Derivatives of texture coordinates by one pixel along x and y.
struct Footprint {
    Vec2 per_x{0, 0}, per_y{0, 0};

    Footprint Scaled(double by) const { return {per_x * by, per_y * by}; }
};

/// Where derivatives come from.
enum class FootprintSource {
    kSurface,            ///< The surface itself: exact.
    kDifferences,        ///< Of the pair of samples 2i, 2i + 1, as GPUs have them.
    kDifferencesTested,  ///< With the border test.
};

/// Of sample (X, Y), by one sample of the enlarged picture. 0 for the sky.
Footprint FootprintOf(const WideGBuffer& g, int X, int Y, FootprintSource source);

/// m / sqrt(k): samples of the enlarged picture that one of k stands for, along an edge.
double SampleSpacing(int m, int k);

/// rho. A footprint of at most a texel: bilinear. `most_taps` = 1: isotropic. >= 1
Rgb SampleFootprint(const MipChain& texture, const Vec2f& uv, const Footprint& footprint,
                    int most_taps);

}  // namespace plumb
