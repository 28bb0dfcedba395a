// How a ray starts on a triangle without meeting that triangle again, nor getting behind its
// neighbour.
//
//       b'      = m + (1 - m_0 - m_1 - m_2) b           m_k = margin h / altitude_k
//       origin  = float( P(b') + h n ),   near = 0,     h = 2^-23 (2 |P| + 3 max_k |p_k - P|)
//
// with |.| the largest of the three coordinates. Rounding the origin to float moves it by at
// most 2^-24 |P| along each axis. A robust ray-triangle test takes the corners relative to the
// origin, so the height of the origin over the plane comes out wrong by a few 2^-24 of the
// distance of the corners; as long as h is more than both, the plane lies behind the ray
// however flat it leaves. Measured over tilted planes of scale 1e-3 to 1e6, 0 to 1000 times
// that from the origin of the coordinates: 1/2 and 1 in place of 2 and 3 let none of 1.4e6 rays
// meet the plane, 1/2 and 1/2 let 908, and 2 and 0, near or not, 17 000.
//
// Where two triangles meet in a valley, h along one normal may reach behind the other: points
// keep off the edges by `margin` times h, the triangle is shrunk onto its inner part.
//
// Source   ours. The usual offset, 32 epsilon of |P| (Embree's path tracing tutorial), is 16
//          times as much and not enough for large triangles about the origin: what leaks into
//          valleys of a noisy field grows with h.
// Symbols  P the point (m), p_k corners, b barycentric coordinates, n the unit normal on the
//          side to leave; margin counts in h.
// Beware   What is nearer than h to the surface is not seen: 2.4e-7 of the distance from the
//          origin of the coordinates and 3.6e-7 of the extent of the triangle.
#pragma once

#include "rays/ray_caster.h"
#include "rays/triangle.h"

namespace plumb {

/// Enough where triangles meet at 60 degrees or more: 2 h sin 60 > h (1 + rounding / h).
inline constexpr double kMargin = 2;

/// A ray that leaves `triangle` at (b_1, b_2) on the side of the unit normal `n`. Its direction
/// is left for the caller. A margin too large for the triangle gives the centre of its
/// inscribed circle.
Ray LeaveSurface(const Triangle& triangle, double b_1, double b_2, const Vec3& n,
                 double margin = kMargin);

}  // namespace plumb
