// What must not change when the surface is scaled, moved, turned or mirrored.
//
// Slices with rotate = false stand at azimuths 2 pi (k + 1/2) / N, a set that a mirror in x or
// y maps onto itself and, for N divisible by 4, a quarter turn too; from centroids, facets and
// azimuths then map onto each other and the answers differ by rounding alone.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "formfactor/bounces.h"
#include "formfactor/slice_links.h"
#include "tests/formfactor/fields.h"

namespace plumb {
namespace {

Links SymmetricLinks(const HeightField& field) {
    return LinksBySlices(field, {.slices = 24,
                                 .origins = Origins::kCentroid,
                                 .rotate = false,
                                 .links_per_slice = 1 << 20});
}

std::vector<HeightField> Fields() {
    std::vector<HeightField> fields;
    for (const Boundary boundary : {Boundary::kWrap, Boundary::kMirror, Boundary::kOpen}) {
        for (const Diagonal diagonal : {Diagonal::kRising, Diagonal::kFalling}) {
            fields.push_back(RoughField(9, 7, 4, boundary, diagonal));
        }
    }
    return fields;
}

// alpha is a ratio of sums of 24 terms of about 1, each good to some 1e-14 (a slope of 1e2
// rounded); V, besides, is what weights rounded to float leave; E_k passes through them again.
void ExpectSame(const Links& a, const Links& b,
                const std::function<std::int64_t(std::int64_t)>& image) {
    ASSERT_EQ(a.Facets(), b.Facets());
    std::vector<bool> met(a.V.size());
    std::vector<std::vector<double>> E_a, E_b;
    const auto keep = [](auto& E) {
        return
            [&E](int, std::span<const double> E_k) { E.emplace_back(E_k.begin(), E_k.end()); };
    };
    ForEachBounce(a, 3, keep(E_a));
    ForEachBounce(b, 3, keep(E_b));
    for (std::int64_t i = 0; i < a.Facets(); ++i) {
        const std::int64_t j = image(i);
        ASSERT_FALSE(met[std::size_t(j)]) << "two facets map to " << j;
        met[std::size_t(j)] = true;
        ASSERT_NEAR(a.alpha[i], b.alpha[j], 1e-12) << "facet " << i;
        ASSERT_NEAR(a.V[i], b.V[j], 2 * kFloatRow) << "facet " << i;
        for (std::size_t k = 1; k < E_a.size(); ++k) {
            ASSERT_NEAR(E_a[k][i], E_b[k][j], 2 * kFloatRow * double(k + 1)) << "facet " << i;
        }
    }
}

TEST(Invariance, ScaleByAPowerOfTwoChangesNoBit) {
    for (const HeightField& field : Fields()) {
        for (const double scale : {0.25, 1024.0}) {
            Image<double> heights = field.HeightsM();
            for (double& z : heights.Pixels()) z *= scale;
            const HeightField scaled(std::move(heights), scale * field.SpacingXM(),
                                     scale * field.SpacingYM(), field.GetBoundary(),
                                     field.GetDiagonal());
            // With every default: origins spread, azimuths turned at random.
            const Links a = LinksBySlices(field), b = LinksBySlices(scaled);
            EXPECT_EQ(a.alpha, b.alpha);
            EXPECT_EQ(a.V, b.V);
        }
    }
}

TEST(Invariance, ScaleOfAllLengths) {
    for (const HeightField& field : Fields()) {
        Image<double> heights = field.HeightsM();
        for (double& z : heights.Pixels()) z *= 0.037;
        const HeightField scaled(std::move(heights), 0.037 * field.SpacingXM(),
                                 0.037 * field.SpacingYM(), field.GetBoundary(),
                                 field.GetDiagonal());
        ExpectSame(SymmetricLinks(field), SymmetricLinks(scaled),
                   [](std::int64_t i) { return i; });
    }
}

// A field lifted by 64 m loses 6 bits of its heights: 1e-14 becomes 1e-13.
TEST(Invariance, HeightAboveTheSea) {
    for (const HeightField& field : Fields()) {
        Image<double> heights = field.HeightsM();
        for (double& z : heights.Pixels()) z += 64;
        const HeightField lifted(std::move(heights), field.SpacingXM(), field.SpacingYM(),
                                 field.GetBoundary(), field.GetDiagonal());
        ExpectSame(SymmetricLinks(field), SymmetricLinks(lifted),
                   [](std::int64_t i) { return i; });
    }
}

TEST(Invariance, WhereTheTileBegins) {
    for (const HeightField& field : Fields()) {
        if (field.GetBoundary() != Boundary::kWrap) continue;
        const int w = field.CellsX(), h = field.CellsY();
        for (const auto& [di, dj] : {std::pair(1, 0), std::pair(4, 5), std::pair(-3, 2)}) {
            ExpectSame(SymmetricLinks(field), SymmetricLinks(Shifted(field, di, dj)),
                       [&, di = di, dj = dj](std::int64_t f) {
                           const int i = int(f / 2 % w), j = int(f / 2 / w);
                           return 2 * (std::int64_t((j + dj + h) % h) * w + (i + di + w) % w) +
                                  f % 2;
                       });
        }
    }
}

// Cell (i, j), between texels i and i + 1, goes to the one between texels W-2-i and W-1-i; of
// its two halves the lower touches the bottom edge, before and after.
TEST(Invariance, MirrorInX) {
    for (const HeightField& field : Fields()) {
        const int w = field.Width(), cells = field.CellsX();
        ExpectSame(SymmetricLinks(field), SymmetricLinks(MirroredX(field)),
                   [&](std::int64_t f) {
                       const int i = int(f / 2 % cells), j = int(f / 2 / cells);
                       const int image = (w - 2 - i + cells) % cells;
                       return 2 * (std::int64_t(j) * cells + image) + f % 2;
                   });
    }
}

// Cell (i, j) goes to column H-2-j and row i, its bottom edge to the right edge. The half at
// the bottom, of a rising field also at the right, is then at the right, of the now falling
// field also at the top: the upper one. Of a falling field the half at the bottom is at the
// left too; it comes to the right and the bottom of a rising field: the lower one.
TEST(Invariance, QuarterTurn) {
    for (const HeightField& field : Fields()) {
        const int h = field.Height(), cells_x = field.CellsX(), cells_y = field.CellsY();
        const bool rising = field.GetDiagonal() == Diagonal::kRising;
        ExpectSame(
            SymmetricLinks(field), SymmetricLinks(QuarterTurned(field)), [&](std::int64_t f) {
                const int i = int(f / 2 % cells_x), j = int(f / 2 / cells_x);
                const int column = (h - 2 - j + cells_y) % cells_y;
                return 2 * (std::int64_t(i) * cells_y + column) + (rising ? 1 - f % 2 : f % 2);
            });
    }
}

// A mirrored field is what a wrapped one shows that holds it and its mirror images: 2 (n - 1)
// texels along each side, the diagonals of the images mirrored. One diagonal rule holds for a
// whole wrapped field, so this is compared where the diagonal does not matter: on a field that
// is endless along y, whose cells are plane.
TEST(Invariance, AMirrorIsTwoTilesOfAWrap) {
    const int w = 8, h = 4;
    Image<double> half(w, h), whole(2 * (w - 1), h);
    for (int j = 0; j < h; ++j) {
        for (int i = 0; i < w; ++i) half(i, j) = 3 * RandomUnit(9, std::uint64_t(i), 0, 0);
        for (int i = 0; i < 2 * (w - 1); ++i) {
            whole(i, j) = half(i < w ? i : 2 * (w - 1) - i, j);
        }
    }
    const Links mirrored = SymmetricLinks(HeightField(half, 1, 1, Boundary::kMirror));
    const Links wrapped = SymmetricLinks(HeightField(whole, 1, 1));
    for (int j = 0; j < h - 1; ++j) {
        for (int i = 0; i < w - 1; ++i) {
            for (int upper = 0; upper < 2; ++upper) {
                const std::size_t a = std::size_t(2 * (j * (w - 1) + i) + upper);
                const std::size_t b = std::size_t(2 * (j * 2 * (w - 1) + i) + upper);
                EXPECT_NEAR(mirrored.alpha[a], wrapped.alpha[b], 1e-12);
                EXPECT_NEAR(mirrored.V[a], wrapped.V[b], 2 * kFloatRow);
            }
        }
    }
}

}  // namespace
}  // namespace plumb
