// What the rasterizer knows of the centre of each pixel; all that a screen-space method sees.
//
// Images are of the drawn size: View::DrawnWidth() x View::DrawnHeight().
#pragma once

#include <cstdint>
#include <limits>

#include "core/image.h"
#include "core/vec.h"
#include "screen_space/raster/depth_format.h"
#include "screen_space/view.h"

namespace plumb {

struct GBuffer {
    static constexpr std::uint32_t kSky = ~std::uint32_t{0};
    static constexpr float kSkyZ = -std::numeric_limits<float>::infinity();

    View view;
    Image<float> z_m;  ///< Of the camera's frame, < 0; kSkyZ where the sky is seen.
    Image<std::uint32_t>
        triangle;                 ///< 2 face + half, as truth/ numbers them; kSky for the sky.
    Image<Vec3f> face_normal;     ///< Unit, camera's frame, towards the viewer; 0 for the sky.
    Image<Vec3f> shading_normal;  ///< Interpolated; the face's where the mesh has none.
    Image<Rgb> albedo;            ///< 0 for the sky. Empty without RasterOptions::albedo.

    // Empty unless RasterOptions::texture_coordinates.
    Image<Vec2f> uv;           ///< 0 for the sky, and where the mesh has none.
    Image<Vec2f> uv_per_x_px;  ///< du/dx, dv/dx by one pixel to the right.
    Image<Vec2f> uv_per_y_px;  ///< du/dy, dv/dy by one pixel downwards.

    // The depth buffer that the picture was drawn with.
    DepthFormat format = DepthFormat::kD32FReversed;
    DepthRange range;
    Image<std::uint32_t> depth;  ///< As stored: see DecodeDepth.
};

}  // namespace plumb
