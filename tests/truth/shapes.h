// Meshes that tests are made of.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh.h"

namespace plumb {

/// Adds one quad with corners of its own, counter-clockwise seen from its front.
inline void AddQuad(Mesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const std::uint32_t first = std::uint32_t(mesh.vertices_m.size());
    for (const Vec3& p : {a, b, c, d}) mesh.vertices_m.push_back(p.cast<float>());
    mesh.quads.push_back({first, first + 1, first + 2, first + 3});
}

inline void AddTriangle(Mesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c) {
    const std::uint32_t first = std::uint32_t(mesh.vertices_m.size());
    for (const Vec3& p : {a, b, c}) mesh.vertices_m.push_back(p.cast<float>());
    mesh.quads.push_back({first, first + 1, first + 2, first + 2});
}

}  // namespace plumb
