// A picture wrapped around a surface.
//
//       albedo(u, v) = bilinear in the four texels whose centres surround (u W, (1 - v) H)
//
// repeated in both directions. Row 0 is the top of the picture, v = 1. Opacity is sampled alike;
// an alpha-tested surface is solid where it is at least 1/2.
//
// Domain   u, v finite; beyond 2^20 float coordinates name hardly a texel.
// Beware   No filter but the bilinear one: far away a texture aliases as the ideal point sample
//          does. What filters is the mean over many samples of a pixel.
#pragma once

#include <string>

#include "core/image.h"
#include "core/vec.h"

namespace plumb {

struct Texture {
    std::string name;
    Image<Rgb> albedo;     ///< Linear. [0, 1]. At least 1 x 1.
    Image<float> opacity;  ///< [0, 1], of the same size; empty = opaque everywhere.
};

Rgb SampleAlbedo(const Texture& texture, const Vec2f& uv);

/// 1 everywhere if the texture has no opacity.
float SampleOpacity(const Texture& texture, const Vec2f& uv);

/// Opacity from which on an alpha-tested surface is there.
inline constexpr float kSolidOpacity = 0.5f;

}  // namespace plumb
