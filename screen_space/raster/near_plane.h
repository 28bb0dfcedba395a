// A near plane that suits scenes of any scale.
//
//       n = min( 0.01 m,  D / 4096,  |target - position| / 256 )
//
// So a scene in other units is cut at the same place: at 1/1000 of its size, 0.01 m would cut off
// most of it. What lies before the plane is not drawn.
//
// Symbols  D diagonal of the box of the mesh's vertices (m).
#pragma once

#include "core/camera.h"
#include "core/mesh.h"
#include "core/scene.h"
#include "screen_space/raster/raster_options.h"

namespace plumb {

double NearPlaneM(const Mesh& mesh, const Camera& camera);

/// How jobs draw a scene: with this near plane and a border of `guard_px` on each side.
RasterOptions SuitedTo(const Scene& scene, const Camera& camera, int guard_px = 0);

}  // namespace plumb
