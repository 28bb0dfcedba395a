// A surface as faces with shared vertices: how truth/ sees everything, height fields too.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/vec.h"

namespace plumb {

/// Quads and triangles over one vertex list. A quad (a, b, c, d) is split along its diagonal
/// b-d into the triangles (a, b, d) and (c, d, b), as Embree splits it. A triangle has d == c.
struct Mesh {
    std::vector<Vec3f> vertices_m;
    std::vector<std::array<std::uint32_t, 4>> quads;

    // Of each vertex, for shading only; empty = the surface has none.
    std::vector<Vec3f> normals;  ///< Unit, or 0 = none. Without them faces are shaded flat.
    std::vector<Vec2f> uvs;      ///< Texture coordinates; (0, 0) is the lower left corner.
};

}  // namespace plumb
