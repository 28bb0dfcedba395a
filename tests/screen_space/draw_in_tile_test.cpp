// The vector loop against the definition, written out pixel by pixel.
#include "screen_space/raster/draw_in_tile.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>

#include "core/random.h"

namespace plumb {
namespace {

void DrawPlainly(const TileTriangle& t, DepthFormat format, Tile& tile) {
    for (int j = t.j_0; j <= t.j_1; ++j) {
        for (int i = t.i_0; i <= t.i_1; ++i) {
            bool covered = true;
            for (std::size_t k = 0; k < 3; ++k) {
                covered &= std::int64_t{t.F[k]} + std::int64_t{t.dx[k]} * j -
                               std::int64_t{t.dy[k]} * i >=
                           0;
            }
            const float e = (t.e + t.e_y * float(j)) + t.e_x * float(i);
            const float key = KeyOf(format, std::min(std::max(e, t.e_min), t.e_max));
            const std::size_t at = std::size_t(j * kTileStride + i);
            if (!covered || !(key > tile.key[at])) continue;
            tile.key[at] = key;
            tile.triangle[at] = t.triangle;
        }
    }
}

// Triangles about a tile of all sizes, from slivers and specks to the largest that fixed point
// reaches; corners on pixel centres and grid lines among them.
ScreenTriangle RandomTriangle(std::uint64_t number) {
    const auto random = [&](std::uint64_t k) { return RandomUnit(5, number, 0, k); };
    const double reach_px = std::exp2(-1 + 14 * random(0));
    const double grid = random(1) < 0.3 ? 128 : 1;
    ScreenTriangle t;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto place = [&](std::uint64_t axis) {
            const double px = 96 + 40 * (random(2 + axis) - 0.5) +
                              reach_px * (2 * random(10 + 2 * k + axis) - 1);
            return std::int32_t(std::clamp(std::round(px * 256 / grid) * grid, -2e6, 6e6));
        };
        t.corners[k] = {place(0), place(1)};
    }
    if (TwiceArea(t.corners[0], t.corners[1], t.corners[2]) == 0) t.corners[2].x += 300;
    if (TwiceArea(t.corners[0], t.corners[1], t.corners[2]) < 0) {
        std::swap(t.corners[1], t.corners[2]);
    }
    t.triangle = std::uint32_t(number);
    t.e_0 = random(40);
    t.e_x = 0.01 * (random(41) - 0.5);
    t.e_y = 0.01 * (random(42) - 0.5);
    t.e_min = float(0.2 * random(43));
    t.e_max = float(0.5 + 0.5 * random(44));
    return t;
}

// Expected: the same bits, over the tile without its padding.
void ExpectDefinition() {
    for (const DepthFormat format : {DepthFormat::kD16, DepthFormat::kD24, DepthFormat::kD32F,
                                     DepthFormat::kD32FReversed}) {
        Tile fast, plain;
        fast.key.fill(KeyOf(format, 0));
        fast.triangle.fill(~std::uint32_t{0});
        plain = fast;
        int drawn = 0;
        for (std::uint64_t number = 0; number < 3000; ++number) {
            const ScreenTriangle triangle = RandomTriangle(number);
            const TileTriangle here = InTile(triangle, 1, 1);
            if (here.i_0 > here.i_1 || here.j_0 > here.j_1) continue;
            DrawInTile(std::span(&here, 1), format, true, fast);
            DrawPlainly(here, format, plain);
            ++drawn;
            if (number % 200 != 0) continue;
            // Begin again, or the nearest triangles soon hide all others.
            for (int j = 0; j < kTilePx; ++j) {
                for (int i = 0; i < kTilePx; ++i) {
                    const std::size_t at = std::size_t(j * kTileStride + i);
                    ASSERT_EQ(fast.key[at], plain.key[at]) << number << " " << i << " " << j;
                    ASSERT_EQ(fast.triangle[at], plain.triangle[at]) << number;
                }
            }
            fast.key.fill(KeyOf(format, 0));
            fast.triangle.fill(~std::uint32_t{0});
            plain = fast;
        }
        EXPECT_GT(drawn, 1000);
    }
}

TEST(DrawInTile, IsItsDefinitionWithEveryInstructionSet) {
    int tried = 0;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        SCOPED_TRACE(hwy::TargetName(target));
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(target);
        ExpectDefinition();
        ++tried;
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    EXPECT_GE(tried, 1);
}

TEST(DrawInTile, LeastKeyIsTheLeast) {
    Tile tile;
    tile.key.fill(-1);  // The padding, which does not count.
    for (int j = 0; j < kTilePx; ++j) {
        for (int i = 0; i < kTilePx; ++i) tile.key[std::size_t(j * kTileStride + i)] = 0.75f;
    }
    EXPECT_EQ(LeastKey(tile), 0.75f);
    for (const auto& [i, j] : {std::pair{0, 0}, {63, 0}, {63, 63}, {17, 41}, {0, 63}}) {
        Tile other = tile;
        other.key[std::size_t(j * kTileStride + i)] = 0.25f;
        EXPECT_EQ(LeastKey(other), 0.25f) << i << " " << j;
    }
}

// Expected: what the tile sees of an edge is the edge: 64-bit F of every pixel has the sign that
// the tile's 32 bits say.
TEST(DrawInTile, ThirtyTwoBitsAreEnough) {
    int inside = 0, outside = 0;
    for (std::uint64_t number = 0; number < 3000; ++number) {
        const ScreenTriangle triangle = RandomTriangle(number);
        const TriangleEdges edges = EdgesOf(triangle.corners);
        const TileTriangle here = InTile(triangle, 1, 1);
        for (int j = 0; j < kTilePx; j += 3) {
            for (int i = 0; i < kTilePx; i += 3) {
                bool covered = true,
                     says = here.i_0 <= i && i <= here.i_1 && here.j_0 <= j && j <= here.j_1;
                for (std::size_t k = 0; k < 3; ++k) {
                    covered &= edges[k].At(kTilePx + i, kTilePx + j) >= 0;
                    says &= std::int64_t{here.F[k]} + std::int64_t{here.dx[k]} * j -
                                std::int64_t{here.dy[k]} * i >=
                            0;
                }
                ASSERT_EQ(covered, says) << number << " " << i << " " << j;
                ++(covered ? inside : outside);
            }
        }
    }
    EXPECT_GT(inside, 10000);
    EXPECT_GT(outside, 10000);
}

}  // namespace
}  // namespace plumb
