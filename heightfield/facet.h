// One facet of a height field: its three corners and what follows from them exactly.
//
//       n = (-dz/dx, -dz/dy, 1) / |...|        A = (s_x s_y / 2) / n_z
//
// so that A n_z, the projected area, is the same for every facet.
//
// Symbols  n unit normal (upward, n_z > 0), A true area (m2), s_x, s_y spacing (m).
// Domain   0 <= facet < HeightField::Facets(), numbered as in heightfield/height_field.h.
#pragma once

#include <array>
#include <cstdint>

#include "core/mesh.h"
#include "core/vec.h"
#include "heightfield/height_field.h"

namespace plumb {

/// A facet in metres. x and y of its corners may lie up to one cell beyond the tile's last
/// texel where the field wraps: the corners are never folded back, the triangle stays whole.
struct Facet {
    std::array<Vec3, 3> corners_m;  ///< Counter-clockwise seen from above.
    Vec3 normal;
    double area_m2 = 0;

    Vec3 CentroidM() const { return (corners_m[0] + corners_m[1] + corners_m[2]) / 3; }
};

Facet FacetOf(const HeightField& field, std::int64_t facet);

/// Column and row of a texel.
struct TexelIndex {
    int i, j;
    friend bool operator==(const TexelIndex&, const TexelIndex&) = default;
};

/// The texels that a facet's corners stand on, in the order of Facet::corners_m, folded into
/// the tile.
std::array<TexelIndex, 3> FacetTexels(const HeightField& field, std::int64_t facet);

/// The same surface as a mesh of quads that Embree's diagonal cuts into the same facets: quad c
/// holds facets 2c and 2c + 1, unless `tiles` > 0. A wrapped or mirrored field has no border;
/// the mesh repeats it `tiles` times to each side of the middle tile, which stays where it is.
Mesh ToMesh(const HeightField& field, int tiles = 0);

}  // namespace plumb
