// How the reference rasterizer draws.
//
// It does what a GPU is specified to do: 8 sub-pixel bits, the top-left rule, clipping at the
// near plane, perspective-correct interpolation, a depth buffer of a real format. Both sides
// of every face are drawn.
#pragma once

#include "core/camera.h"
#include "screen_space/raster/depth_format.h"
#include "screen_space/view.h"

namespace plumb {

/// In what precision vertices are carried from the scene to the picture.
enum class VertexPath {
    kDouble,  ///< Everything in double.
    kFloat,   ///< As a vertex shader does it: one float matrix, made in double on the host.
};

/// Where GBuffer::z_m comes from.
enum class ZSource {
    kSurface,  ///< The surface at the pixel's centre, in double: exact but for the vertex path.
    kStored,   ///< The depth buffer, through [McGuire12 eq. 2] in float, as a shader reads it.
};

struct RasterOptions {
    DepthFormat depth = DepthFormat::kD32FReversed;
    DepthRange range = {};
    VertexPath vertices = VertexPath::kDouble;
    ZSource z = ZSource::kSurface;
    int guard_px = 0;                  ///< Border drawn on each side. [0, 16384]
    bool albedo = true;                ///< Whether GBuffer::albedo is wanted.
    bool texture_coordinates = false;  ///< Whether GBuffer::uv and its derivatives are wanted.

    friend bool operator==(const RasterOptions&, const RasterOptions&) = default;
};

/// Throws Error, naming field, value and rule.
void Validate(const RasterOptions& options);

/// What the camera's picture and its border look like. Throws Error if the drawn picture is
/// larger than 16384 pixels in a direction.
View ViewOf(const Camera& camera, int guard_px);

}  // namespace plumb
