// An enlarged G-buffer: m x m samples for each pixel, with what a late texture lookup needs.
//
//       samples of (m w) x (m h):  z, normal, material, texture coordinates and their derivatives
//
// In place of albedo there are the number of the material (with it the layer of the texture) and
// texture coordinates, so that textures are read when a sample is shaded, filtered as wide as the
// pixel's number of samples asks for.
//
// Source   [Hollander13] section 3 (size), section 4 and figure 4 (what it holds).
// Symbols  m edge of a window, w x h size of the picture shown.
// Beware   Derivatives are those of the surface, per pixel of the *enlarged* picture; a shader would
//          take differences of neighbouring samples. Which channels hold what in figure 4 is not
//          said in words: the layout of k8Bit is ours.
#pragma once

#include <cstdint>

#include "core/image.h"
#include "core/scene.h"
#include "screen_space/gbuffer.h"
#include "screen_space/raster/raster_options.h"

namespace plumb {

enum class GBufferFormat {
    kFloat,
    /// Channels of 8 bits: normals 3, material 1, texture coordinates 2 x 2, repeated at 1. Depth
    /// has bits of its own: DepthMetric::bits.
    k8Bit,
};

struct WideGBuffer {
    static constexpr std::uint16_t kNoMaterial = 0xffff;

    int m = 1;
    GBuffer samples;                ///< Without albedo.
    Image<std::uint16_t> material;  ///< Of the scene; kNoMaterial for the sky.

    int WidthPx() const { return samples.view.width_px / m; }  ///< w
    int HeightPx() const { return samples.view.height_px / m; }
};

struct WideOptions {
    int m = 4;  ///< [1, 8]; m w and m h at most 16384.
    GBufferFormat format = GBufferFormat::kFloat;
    DepthFormat depth = DepthFormat::kD32FReversed;
    DepthRange range = {};
};

/// Draws the scene as `camera` sees it, w x h being its size. Throws Error if the options, camera or
/// mesh are not valid, or k8Bit is asked for and there are more than 255 materials.
WideGBuffer DrawWideGBuffer(const Scene& scene, const Camera& camera,
                            const WideOptions& options);

/// The normal as three bytes hold it: round(255 (n + 1) / 2), not made a unit vector again. 0 stays.
Vec3f ByteNormal(const Vec3f& n);

}  // namespace plumb
