#include "heightfield/facet.h"

#include <cassert>

namespace plumb {
namespace {

// Texel that stands at index i of the endless continuation of n texels.
int Folded(int i, int n, Boundary boundary) {
    if (0 <= i && i < n) return i;
    if (boundary == Boundary::kWrap) return ((i % n) + n) % n;
    const int period = 2 * (n - 1);
    const int k = ((i % period) + period) % period;
    return k < n ? k : period - k;
}

Vec3 TexelM(const HeightField& field, int i, int j) {
    const double z = field.At(Folded(i, field.Width(), field.GetBoundary()),
                              Folded(j, field.Height(), field.GetBoundary()));
    return {(i + 0.5) * field.SpacingXM(), (j + 0.5) * field.SpacingYM(), z};
}

// Offsets from a facet's cell to its corners, counter-clockwise from above.
std::array<TexelIndex, 3> CornerOffsets(Diagonal diagonal, bool upper) {
    if (diagonal == Diagonal::kRising) {
        return upper ? std::array<TexelIndex, 3>{{{0, 0}, {1, 1}, {0, 1}}}
                     : std::array<TexelIndex, 3>{{{0, 0}, {1, 0}, {1, 1}}};
    }
    return upper ? std::array<TexelIndex, 3>{{{1, 0}, {1, 1}, {0, 1}}}
                 : std::array<TexelIndex, 3>{{{0, 0}, {1, 0}, {0, 1}}};
}

// The corners of a facet, not folded.
std::array<TexelIndex, 3> Corners(const HeightField& field, std::int64_t facet) {
    assert(0 <= facet && facet < field.Facets());
    const std::int64_t cell = facet / 2;
    std::array<TexelIndex, 3> corners = CornerOffsets(field.GetDiagonal(), facet % 2 == 1);
    for (TexelIndex& corner : corners) {
        corner.i += int(cell % field.CellsX());
        corner.j += int(cell / field.CellsX());
    }
    return corners;
}

}  // namespace

Facet FacetOf(const HeightField& field, std::int64_t facet) {
    const std::array<TexelIndex, 3> corners = Corners(field, facet);
    Facet out;
    for (std::size_t k = 0; k < 3; ++k) {
        out.corners_m[k] = TexelM(field, corners[k].i, corners[k].j);
    }
    const Vec3 cross =
        (out.corners_m[1] - out.corners_m[0]).cross(out.corners_m[2] - out.corners_m[0]);
    out.area_m2 = cross.norm() / 2;
    out.normal = cross / cross.norm();
    return out;
}

std::array<TexelIndex, 3> FacetTexels(const HeightField& field, std::int64_t facet) {
    std::array<TexelIndex, 3> corners = Corners(field, facet);
    for (TexelIndex& corner : corners) {
        corner.i = Folded(corner.i, field.Width(), field.GetBoundary());
        corner.j = Folded(corner.j, field.Height(), field.GetBoundary());
    }
    return corners;
}

Mesh ToMesh(const HeightField& field, int tiles) {
    if (field.GetBoundary() == Boundary::kOpen) tiles = 0;  // Nothing lies beyond its border.
    const int cells_x = field.CellsX(), cells_y = field.CellsY();
    const int i0 = -tiles * cells_x, i1 = (tiles + 1) * cells_x;
    const int j0 = -tiles * cells_y, j1 = (tiles + 1) * cells_y;
    const std::uint32_t columns = std::uint32_t(i1 - i0 + 1);
    Mesh mesh;
    mesh.vertices_m.reserve(std::size_t(columns) * (j1 - j0 + 1));
    for (int j = j0; j <= j1; ++j) {
        for (int i = i0; i <= i1; ++i) {
            mesh.vertices_m.push_back(TexelM(field, i, j).cast<float>());
        }
    }
    mesh.quads.reserve(std::size_t(i1 - i0) * (j1 - j0));
    for (int j = j0; j < j1; ++j) {
        for (int i = i0; i < i1; ++i) {
            const std::uint32_t a = std::uint32_t(j - j0) * columns + std::uint32_t(i - i0);
            const std::uint32_t b = a + 1, c = a + columns + 1, d = a + columns;
            // A mirrored tile carries the mirrored diagonal.
            const bool mirrored_x = field.GetBoundary() == Boundary::kMirror &&
                                    ((i - i0) / cells_x + tiles) % 2 != 0;
            const bool mirrored_y = field.GetBoundary() == Boundary::kMirror &&
                                    ((j - j0) / cells_y + tiles) % 2 != 0;
            const bool rising =
                (field.GetDiagonal() == Diagonal::kRising) != (mirrored_x != mirrored_y);
            // The quad (p, q, r, s) is cut along q-s: start where that is our diagonal.
            if (rising) {
                mesh.quads.push_back({b, c, d, a});
            } else {
                mesh.quads.push_back({a, b, c, d});
            }
        }
    }
    return mesh;
}

}  // namespace plumb
