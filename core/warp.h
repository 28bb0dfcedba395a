// From a point u of the unit square to a point of a hemisphere, a disk or a triangle, with the
// density of the result and the way back.
//
//       Sample X (u), Pdf X (x), Invert X (x):     Invert(Sample(u)) = u,   Int Pdf = 1
//
// Source   hemisphere: z = 1 - u_0 is uniform in [0, 1] (Archimedes). Disk: [Shirley97]
//          P. Shirley, K. Chiu, A Low Distortion Map Between Disk and Square, 1997. Cosine
//          hemisphere: the disk lifted (N. Malley). Basis: [Duff17] T. Duff et al., Building an
//          Orthonormal Basis, Revisited, JCGT 6(1), 2017.
// Symbols  u in [0, 1)^2; w a unit direction in the frame with the normal along +z; p a point
//          of the unit disk; b barycentric coordinates (b_0, b_1) of a triangle,
//          b_2 = 1 - b_0 - b_1.
// Beware   Directions graze: w_z may be 0 (uniform: never, cosine: where u meets the border of
//          the square). Dropping such directions would bias a visibility upward.
#pragma once

#include "core/vec.h"

namespace plumb {

/// Uniform in solid angle over the upper hemisphere.
Vec3 SampleUniformHemisphere(const Vec2& u);
double PdfUniformHemisphere(const Vec3& w);  ///< Per steradian: 1 / (2 pi) above the plane.
Vec2 InvertUniformHemisphere(const Vec3& w);

/// In proportion to the cosine with the normal.
Vec3 SampleCosineHemisphere(const Vec2& u);
double PdfCosineHemisphere(const Vec3& w);  ///< Per steradian: w_z / pi above the plane.
Vec2 InvertCosineHemisphere(const Vec3& w);

/// Uniform in area over the unit disk, neighbours staying neighbours.
Vec2 SampleDisk(const Vec2& u);
double PdfDisk(const Vec2& p);  ///< Per unit area: 1 / pi inside.
Vec2 InvertDisk(const Vec2& p);

/// Uniform in area over any triangle, as the barycentric coordinates (b_0, b_1).
Vec2 SampleTriangle(const Vec2& u);
double PdfTriangle(const Vec2& b);  ///< Per unit of b_0 b_1: 2 inside. Over area: 1 / area.
Vec2 InvertTriangle(const Vec2& b);

/// Two unit vectors that with the unit vector `n` form a right-handed frame (s, t, n).
struct Basis {
    Vec3 s, t, n;
    explicit Basis(const Vec3& n);

    /// From the frame (n along +z) to where n lives, and back.
    Vec3 ToWorld(const Vec3& w) const { return w.x() * s + w.y() * t + w.z() * n; }
    Vec3 ToLocal(const Vec3& v) const { return {v.dot(s), v.dot(t), v.dot(n)}; }
};

}  // namespace plumb
