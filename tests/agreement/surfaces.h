// The surfaces on which the judged meets the judge.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/mesh.h"
#include "core/random.h"
#include "heightfield/facet.h"
#include "heightfield/height_field.h"
#include "heightfield/procedural/catalogue.h"
#include "truth/receiver.h"

namespace plumb {

/// The heights within a rim as high as the highest: no line of sight leaves sideways, so that
/// "open" means the same to both.
inline HeightField Rimmed(Image<double> heights_m, double spacing_m) {
    const double top = *std::ranges::max_element(heights_m.Pixels());
    const int w = heights_m.Width(), h = heights_m.Height();
    for (int i = 0; i < w; ++i) heights_m(i, 0) = heights_m(i, h - 1) = top;
    for (int j = 0; j < h; ++j) heights_m(0, j) = heights_m(w - 1, j) = top;
    return HeightField(std::move(heights_m), spacing_m, spacing_m, Boundary::kOpen);
}

/// Independent heights: the roughest there is. Slopes up to 2.4.
inline HeightField NoiseField(int n) {
    Image<double> heights_m(n, n);
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) heights_m(i, j) = 0.15 * RandomUnit(7, i, j, 0);
    }
    return Rimmed(std::move(heights_m), 1.0 / n);
}

/// A procedural wall of stones, its advised relief three times over.
inline HeightField StoneField(int n) {
    const ProceduralKind& kind = ProceduralKindNamed("stone_wall");
    const HeightField wall = kind.make(3, AdvisedTile(kind, n, n));
    Image<double> heights_m = wall.HeightsM();
    for (double& z : heights_m.Pixels()) z *= 3;
    return Rimmed(std::move(heights_m), wall.SpacingXM());
}

/// The very same surface on a grid m times as fine: m^2 facets for each facet.
inline HeightField Refined(const HeightField& field, int m) {
    const int w = field.CellsX() * m + 1, h = field.CellsY() * m + 1;
    Image<double> heights_m(w, h);
    for (int j = 0; j < h; ++j) {
        for (int i = 0; i < w; ++i) {
            const int a = std::min(i / m, field.CellsX() - 1);
            const int b = std::min(j / m, field.CellsY() - 1);
            const double u = i / double(m) - a, v = j / double(m) - b;
            const double z00 = field.At(a, b), z11 = field.At(a + 1, b + 1);
            const double z10 = field.At(a + 1, b), z01 = field.At(a, b + 1);
            // The rising diagonal: lower half u >= v.
            heights_m(i, j) = u >= v ? z00 + u * (z10 - z00) + v * (z11 - z10)
                                     : z00 + v * (z01 - z00) + u * (z11 - z01);
        }
    }
    return HeightField(std::move(heights_m), field.SpacingXM() / m, field.SpacingYM() / m,
                       Boundary::kOpen);
}

/// The facet of the coarse field that each facet of its refinement lies in.
inline std::vector<std::int64_t> CoarseFacets(const HeightField& coarse,
                                              const HeightField& fine, int m) {
    std::vector<std::int64_t> out(std::size_t(fine.Facets()));
    for (std::int64_t f = 0; f < fine.Facets(); ++f) {
        const Vec3 c = FacetOf(fine, f).CentroidM();
        const double x = c.x() / coarse.SpacingXM() - 0.5 / m;
        const double y = c.y() / coarse.SpacingYM() - 0.5 / m;
        const double u = x - std::floor(x), v = y - std::floor(y);
        out[std::size_t(f)] =
            2 * (std::int64_t(y) * coarse.CellsX() + std::int64_t(x)) + (u >= v ? 0 : 1);
    }
    return out;
}

/// The triangles of ToMesh(field, tiles) that are the field's facets, found by where they are.
inline std::vector<Receiver> FacetReceivers(const HeightField& field, const Mesh& mesh,
                                            int tiles) {
    const std::int64_t row = std::int64_t(field.CellsX()) * (2 * tiles + 1);
    std::vector<Receiver> receivers;
    for (std::int64_t f = 0; f < field.Facets(); ++f) {
        const std::int64_t cell = f / 2;
        const std::int64_t quad =
            (cell / field.CellsX() + std::int64_t(tiles) * field.CellsY()) * row +
            cell % field.CellsX() + std::int64_t(tiles) * field.CellsX();
        const Vec3 centroid_m = FacetOf(field, f).CentroidM();
        const auto distance = [&](std::uint32_t triangle) {
            return (TriangleOf(mesh, triangle).PointM(1.0 / 3, 1.0 / 3) - centroid_m).norm();
        };
        const std::uint32_t first = std::uint32_t(2 * quad);
        receivers.push_back(
            {.triangle = distance(first) < distance(first + 1) ? first : first + 1});
    }
    return receivers;
}

}  // namespace plumb
