// A near plane that suits scenes of any scale.
//
//       n = min( 0.01 m,  D / 4096,  |target - position| / 256 )
//
// So a scene in other units is cut at the same place: at 1/1000 of its size, 0.01 m would cut off
// most of it. What lies before the plane is not drawn. DrawGBuffer takes this one where its
// options leave the range of depths as it is by default.
//
// Symbols  D diagonal of the box of the mesh's vertices (m).
#pragma once

#include "core/camera.h"
#include "core/mesh.h"

namespace plumb {

double NearPlaneM(const Mesh& mesh, const Camera& camera);

}  // namespace plumb
