// What a scene's surface is at a point of a triangle: its corners, its texture, its normal.
//
//       triangle 2f of face f = (a, b, c, d) is (a, b, d), triangle 2f + 1 is (c, d, b)
//       X(b_1, b_2) = (1 - b_1 - b_2) X_0 + b_1 X_1 + b_2 X_2        X: uv, shading normal
//
// Symbols  b_1, b_2 barycentric coordinates of the triangle's second and third corner.
// Beware   A shading normal is for shading only: it may point below the surface that rays meet.
#pragma once

#include <array>
#include <cstdint>

#include "core/scene.h"

namespace plumb {

/// Numbers of the vertices of a triangle.
std::array<std::uint32_t, 3> CornersOf(const Mesh& mesh, std::uint32_t triangle);

/// Texture coordinates; 0 if the mesh has none.
Vec2f UvAt(const Mesh& mesh, std::uint32_t triangle, double b_1, double b_2);

/// rho: the material's albedo times its texture's.
Rgb AlbedoAt(const Scene& scene, std::uint32_t triangle, double b_1, double b_2);

/// False where an alpha-tested material has no surface.
bool IsSolidAt(const Scene& scene, std::uint32_t triangle, double b_1, double b_2);

/// Whether any point of the face may be without surface.
bool IsAlphaTested(const Scene& scene, std::uint32_t face);

/// The unit normal to shade with, on the side of the unit normal `face_normal`: interpolated if
/// the mesh has normals (and they do not cancel), else `face_normal` itself.
Vec3 ShadingNormalAt(const Mesh& mesh, std::uint32_t triangle, double b_1, double b_2,
                     const Vec3& face_normal);

}  // namespace plumb
