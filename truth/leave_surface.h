// How a ray starts on a triangle without meeting that triangle again.
//
//       origin  = float( P + h n ),   near = h,     h = 2^-23 (32 |P| + 4 max_k |p_k - P|)
//
// with |.| the largest of the three coordinates. Rounding the origin to float moves it by at
// most 2^-24 |P| along each axis. A robust ray-triangle test takes the corners relative to the
// origin, so the height of the origin over the plane comes out wrong by a few 2^-24 of the
// distance of the corners; as long as h is more than both, the plane lies behind the ray
// however flat it leaves.
//
// Source   the first term: Embree's path tracing tutorial (32 epsilon of the coordinates, for
//          offset and near). The second is ours: at the middle of a large triangle about the
//          origin of the coordinates the first vanishes and the error does not.
// Symbols  P the point (m), p_k the triangle's corners, n the unit normal on the side to leave.
// Beware   What is nearer than h to the surface is not seen: 4e-6 of the distance from the origin
//          of the coordinates and 5e-7 of the extent of the triangle.
#pragma once

#include "truth/ray_caster.h"
#include "truth/triangle.h"

namespace plumb {

/// A ray that leaves `triangle` at `point_m`, a point of it, on the side of the unit normal
/// `n`. Its direction is left for the caller.
Ray LeaveSurface(const Triangle& triangle, const Vec3& point_m, const Vec3& n);

}  // namespace plumb
