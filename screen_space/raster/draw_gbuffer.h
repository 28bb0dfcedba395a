// A scene through a camera, drawn by the reference rasterizer.
//
// First depth and triangle number (screen_space/raster/rasterizer.h), then, from the triangle of each
// pixel, everything else at the pixel's centre, perspective-correct and in double.
#pragma once

#include "core/scene.h"
#include "screen_space/gbuffer.h"
#include "screen_space/raster/raster_options.h"
#include "screen_space/raster/rasterizer.h"

namespace plumb {

/// The holes of the scene's alpha-tested materials; the scene must outlive it.
AlphaTest AlphaTestOf(const Scene& scene);

/// Throws Error if the scene's mesh, the camera or the options are not valid; the rest of the
/// scene (materials, textures) must be as Validate(Scene) wants it.
GBuffer DrawGBuffer(const Scene& scene, const Camera& camera,
                    const RasterOptions& options = {});

/// The same over an earlier picture: memory is kept, every pixel is written.
void DrawGBuffer(Rasterizer& rasterizer, const Scene& scene, const Camera& camera,
                 const RasterOptions& options, GBuffer& out);

}  // namespace plumb
