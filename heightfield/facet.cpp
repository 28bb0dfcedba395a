#include "heightfield/facet.h"

#include <cassert>

namespace plumb {
namespace {

// Texel that stands at index i of the endless continuation of n texels.
int Folded(int i, int n, Boundary boundary) {
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

}  // namespace

Facet FacetOf(const HeightField& field, std::int64_t facet) {
    assert(0 <= facet && facet < field.Facets());
    const std::int64_t cell = facet / 2;
    const int i = int(cell % field.CellsX()), j = int(cell / field.CellsX());
    const bool upper = facet % 2 == 1;
    const Vec3 z00 = TexelM(field, i, j), z10 = TexelM(field, i + 1, j);
    const Vec3 z01 = TexelM(field, i, j + 1), z11 = TexelM(field, i + 1, j + 1);
    Facet out;
    if (field.GetDiagonal() == Diagonal::kRising) {
        out.corners_m = upper ? std::array{z00, z11, z01} : std::array{z00, z10, z11};
    } else {
        out.corners_m = upper ? std::array{z10, z11, z01} : std::array{z00, z10, z01};
    }
    const Vec3 cross =
        (out.corners_m[1] - out.corners_m[0]).cross(out.corners_m[2] - out.corners_m[0]);
    out.area_m2 = cross.norm() / 2;
    out.normal = cross / cross.norm();
    return out;
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
