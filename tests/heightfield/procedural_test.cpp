#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "heightfield/procedural/bricks.h"
#include "heightfield/procedural/catalogue.h"
#include "heightfield/procedural/cobbles.h"
#include "heightfield/procedural/gravel.h"
#include "heightfield/procedural/hex_tiles.h"
#include "heightfield/procedural/noise.h"
#include "heightfield/procedural/shapes.h"
#include "heightfield/procedural/stone_wall.h"
#include "heightfield/procedural/terrain.h"

namespace plumb {
namespace {

using namespace procedural;

// The continuous function behind each kind of the catalogue, in its order.
struct Surface {
    std::string name;
    std::function<double(double, double)> z;
};

std::vector<Surface> Surfaces(std::uint64_t seed) {
    return {
        {"stone_wall", [=](double u, double v) { return StoneWallHeight({seed}, u, v); }},
        {"bricks", [=](double u, double v) { return BricksHeight({seed}, u, v); }},
        {"cobbles", [=](double u, double v) { return CobblesHeight({seed}, u, v); }},
        {"gravel", [=](double u, double v) { return GravelHeight({seed}, u, v); }},
        {"hex_tiles", [=](double u, double v) { return HexTilesHeight({seed}, u, v); }},
        {"terrain", [=](double u, double v) { return TerrainHeight({seed}, u, v); }},
        {"ridges",
         [=](double u, double v) { return TerrainHeight({.seed = seed, .ridges = 1}, u, v); }},
        {"shapes", [=](double u, double v) { return ShapesHeight({seed}, u, v); }},
    };
}

template <class Params>
std::string MessageOf(const Params& p) {
    try {
        Validate(p);
    } catch (const Error& e) {
        return e.what();
    }
    return "no error";
}

// Expected: f(u + m, v + n) = f(u, v) for whole m, n. Positions are dyadic, so that u + m is
// exact and the heights must agree bit for bit.
TEST(Procedural, HasPeriodOneExactly) {
    for (const Surface& s : Surfaces(11)) {
        for (int k = 0; k < 200; ++k) {
            const double u = std::floor(4096 * Uniform(1, 1, k, 0)) / 4096;
            const double v = std::floor(4096 * Uniform(1, 1, k, 1)) / 4096;
            EXPECT_EQ(s.z(u, v), s.z(u + 1, v)) << s.name << " at " << u << ", " << v;
            EXPECT_EQ(s.z(u, v), s.z(u - 3, v + 2)) << s.name << " at " << u << ", " << v;
        }
    }
}

// Each of the two halves of a difference holds at least half of it, so halving 34 times comes
// down on a jump if there is one, wherever it hides, and on a slope times 2^-34 / n if not.
double LargestJump(const Surface& s, bool along_u, int lines, int n) {
    double largest = 0;
    for (int line = 0; line < lines; ++line) {
        const double across = (line + 0.37) / lines;
        auto z = [&](double along) {
            return along_u ? s.z(along, across) : s.z(across, along);
        };
        // From inside the tile, over the seam at 1, to inside its copy.
        for (int k = 0; k < n; ++k) {
            double a = 0.5 + double(k) / n, b = 0.5 + double(k + 1) / n;
            double z_a = z(a), z_b = z(b);
            for (int halving = 0; halving < 34; ++halving) {
                const double m = (a + b) / 2, z_m = z(m);
                if (std::abs(z_m - z_a) > std::abs(z_b - z_m)) {
                    b = m, z_b = z_m;
                } else {
                    a = m, z_a = z_m;
                }
            }
            largest = std::max(largest, std::abs(z_b - z_a));
        }
    }
    return largest;
}

// Expected: 0, as every surface is continuous, seam included. Tolerance: steepest is the rim of
// a dome of radius 0.06 and height 1 in `shapes`, where d = 2^-34 / 128 from the rim the height
// is sqrt(2 d / 0.06) = 4e-6; elsewhere slopes are below 1e3, which makes 5e-10. A joint or
// stone cut off would show as some hundredths.
TEST(Procedural, IsContinuousAcrossSeamsAndBorders) {
    for (const std::uint64_t seed : {1, 2}) {
        for (const Surface& s : Surfaces(seed)) {
            EXPECT_LT(LargestJump(s, true, 8, 128), 1e-5) << s.name << " along u";
            EXPECT_LT(LargestJump(s, false, 8, 128), 1e-5) << s.name << " along v";
        }
    }
}

// The same for parameters at the ends of their ranges, where a lookup could reach too short.
TEST(Procedural, IsContinuousAtTheEndsOfItsParameters) {
    const std::vector<Surface> extremes{
        {"wide mortar, thin stones",
         [](double u, double v) {
             return StoneWallHeight({.courses = 2,
                                     .stones_per_course = 12,
                                     .irregularity = 1,
                                     .mortar = 0.4,
                                     .edge = 0.3,
                                     .unevenness = 1,
                                     .relief = 1},
                                    u, v);
         }},
        {"one brick a course",
         [](double u, double v) {
             return BricksHeight({.courses = 2,
                                  .bricks_per_course = 1,
                                  .mortar = 0.02,
                                  .edge = 0.3,
                                  .chips = 1,
                                  .unevenness = 1,
                                  .relief = 1},
                                 u, v);
         }},
        {"cobbles anywhere",
         [](double u, double v) {
             return CobblesHeight({.stones = 2, .jitter = 1, .unevenness = 1, .relief = 1}, u,
                                  v);
         }},
        {"high gravel",
         [](double u, double v) {
             return GravelHeight({.stones = 2, .scales = 3, .flatness = 0}, u, v);
         }},
        {"flat gravel",
         [](double u, double v) {
             return GravelHeight({.stones = 2, .scales = 5, .flatness = 0.9}, u, v);
         }},
        {"hexagons without joints",
         [](double u, double v) {
             return HexTilesHeight(
                 {.columns = 1, .rows = 2, .joint = 0, .bevel = 0.4, .unevenness = 1}, u, v);
         }},
    };
    for (const Surface& s : extremes) {
        EXPECT_LT(LargestJump(s, true, 8, 96), 1e-5) << s.name << " along u";
        EXPECT_LT(LargestJump(s, false, 8, 96), 1e-5) << s.name << " along v";
    }
}

TEST(Procedural, IsAFunctionOfItsSeedOnAnyNumberOfThreads) {
    for (const ProceduralKind& kind : ProceduralKinds()) {
        const Tile tile = AdvisedTile(kind, 48, 40);
        SetThreadCount(1);
        const HeightField one = kind.make(7, tile);
        SetThreadCount(3);
        const HeightField three = kind.make(7, tile);
        SetThreadCount(0);
        EXPECT_EQ(one.HeightsM(), three.HeightsM()) << kind.name;

        const HeightField other = kind.make(8, tile);
        int same = 0;
        for (int j = 0; j < 40; ++j)
            for (int i = 0; i < 48; ++i) same += one.At(i, j) == other.At(i, j);
        // Level ground between solids is the same whatever the seed; all else has noise.
        EXPECT_LT(same, kind.name == "shapes" ? 48 * 40 / 2 : 48 * 40 / 100) << kind.name;
    }
}

TEST(Procedural, HasTheSizeAndAmplitudeOfItsTile) {
    for (const ProceduralKind& kind : ProceduralKinds()) {
        const HeightField field = kind.make(1, {.width_texels = 33,
                                                .height_texels = 20,
                                                .width_m = 3.3,
                                                .height_m = 4,
                                                .amplitude_m = 0.7});
        EXPECT_EQ(field.Width(), 33) << kind.name;
        EXPECT_EQ(field.Height(), 20) << kind.name;
        EXPECT_DOUBLE_EQ(field.SpacingXM(), 0.1) << kind.name;
        EXPECT_DOUBLE_EQ(field.SpacingYM(), 0.2) << kind.name;
        EXPECT_EQ(field.GetBoundary(), Boundary::kWrap) << kind.name;
        // A few roundings of heights below 2.
        EXPECT_NEAR(field.HighestM() - field.LowestM(), 0.7, 1e-15) << kind.name;
    }
}

// Expected: centre i of n texels is centre 3 i + 1 of 3 n, so both sample the same points; the
// two fields differ by the affine map that gives each its amplitude, found from two texels.
// Tolerance: positions differ by a rounding, which the rim of a dome turns into
// sqrt(2^-53 / 0.06) = 4e-8 of its height.
TEST(Procedural, ShowsTheSameSurfaceAtAnyResolution) {
    for (const ProceduralKind& kind : ProceduralKinds()) {
        const HeightField coarse = kind.make(4, AdvisedTile(kind, 32, 24));
        const HeightField fine = kind.make(4, AdvisedTile(kind, 96, 72));
        double z[2] = {0, 0}, Z[2] = {0, 0};
        for (int j = 0; j < 24; ++j) {
            for (int i = 0; i < 32; ++i) {
                if (coarse.At(i, j) == coarse.LowestM())
                    z[0] = coarse.At(i, j), Z[0] = fine.At(3 * i + 1, 3 * j + 1);
                if (coarse.At(i, j) == coarse.HighestM())
                    z[1] = coarse.At(i, j), Z[1] = fine.At(3 * i + 1, 3 * j + 1);
            }
        }
        const double scale = (Z[1] - Z[0]) / (z[1] - z[0]);
        EXPECT_GT(scale, 0.4) << kind.name;  // The finer grid finds higher tops, not twice so.
        EXPECT_LE(scale, 1 + 1e-12) << kind.name;
        for (int j = 0; j < 24; ++j)
            for (int i = 0; i < 32; ++i)
                ASSERT_NEAR(Z[0] + scale * (coarse.At(i, j) - z[0]),
                            fine.At(3 * i + 1, 3 * j + 1), 1e-7 * kind.amplitude_per_width)
                    << kind.name << " at " << i << ", " << j;
    }
}

// Expected: without irregularity, chips and relief a wall is known by hand: courses k / n,
// stones one above the other shifted by half; faces above 0.6, mortar within 0.12 +- 0.2.
TEST(StoneWall, WithoutIrregularityIsAGridOfBoxes) {
    const StoneWall wall{.irregularity = 0, .unevenness = 0, .relief = 0};
    for (int k = 0; k < wall.courses; ++k) {
        for (int i = 0; i < wall.stones_per_course; ++i) {
            const double shift = 0.5 * (k % 2);
            const double left = (i - shift) / wall.stones_per_course;
            const double middle = (i + 0.5 - shift) / wall.stones_per_course;
            EXPECT_DOUBLE_EQ(StoneWallHeight(wall, middle, (k + 0.5) / wall.courses), 0.82);
            EXPECT_LE(StoneWallHeight(wall, left, (k + 0.5) / wall.courses), 0.32);
            EXPECT_LE(StoneWallHeight(wall, middle, double(k) / wall.courses), 0.32);
        }
    }
}

TEST(Bricks, LieInRunningBond) {
    const Bricks bricks{.chips = 0, .unevenness = 0, .relief = 0};
    for (int k = 0; k < bricks.courses; ++k) {
        for (int i = 0; i < bricks.bricks_per_course; ++i) {
            const double shift = 0.5 * (k % 2);
            const double joint = (i - shift) / bricks.bricks_per_course;
            const double middle = (i + 0.5 - shift) / bricks.bricks_per_course;
            const double v = (k + 0.5) / bricks.courses;
            EXPECT_GE(BricksHeight(bricks, middle, v), 0.8);
            EXPECT_LE(BricksHeight(bricks, joint, v), 0.3);
            EXPECT_LE(BricksHeight(bricks, middle, double(k) / bricks.courses), 0.3);
        }
    }
}

// Expected: without jitter the stones of the lattice stand in the middle of square cells; the
// border noise bends by at most 0.12 of a cell.
TEST(Cobbles, StonesRiseFromTheSand) {
    const Cobbles cobbles{.jitter = 0, .unevenness = 0, .relief = 0};
    for (int j = 0; j < cobbles.stones; ++j) {
        for (int i = 0; i < cobbles.stones; ++i) {
            const double n = cobbles.stones;
            EXPECT_GE(CobblesHeight(cobbles, (i + 0.5) / n, (j + 0.5) / n), 0.6);
            EXPECT_LE(CobblesHeight(cobbles, i / n, j / n), 0.3);
        }
    }
}

TEST(Gravel, MoreStonesNeverLowerIt) {
    double raised = 0;
    for (int k = 0; k < 2000; ++k) {
        const double u = Uniform(6, 0, k, 0), v = Uniform(6, 0, k, 1);
        for (int scales = 1; scales < 5; ++scales) {
            const double fewer = GravelHeight({.scales = scales, .relief = 0}, u, v);
            const double more = GravelHeight({.scales = scales + 1, .relief = 0}, u, v);
            EXPECT_GE(more, fewer);
            raised += more > fewer;
        }
    }
    EXPECT_GT(raised, 1000);
}

// Expected: from the lattice. Hexagon (i, j) has its middle at (i + 1/2 + (j mod 2) / 2, j +
// 1/2) in columns and rows; half-way to a neighbour lies the joint.
TEST(HexTiles, StandOnAHexagonalLattice) {
    const HexTiles tiles{.unevenness = 0, .relief = 0};
    for (int j = 0; j < tiles.rows; ++j) {
        for (int i = 0; i < tiles.columns; ++i) {
            const double x = i + 0.5 + 0.5 * (j % 2), y = j + 0.5;
            auto z = [&](double dx, double dy) {
                return HexTilesHeight(tiles, (x + dx) / tiles.columns, (y + dy) / tiles.rows);
            };
            EXPECT_DOUBLE_EQ(z(0, 0), 0.85);
            EXPECT_DOUBLE_EQ(z(0.2, 0.2), 0.85);
            for (const auto& [dx, dy] :
                 {std::pair{0.5, 0.0}, std::pair{-0.5, 0.0}, std::pair{0.25, 0.5},
                  std::pair{-0.25, 0.5}, std::pair{0.25, -0.5}, std::pair{-0.25, -0.5}})
                EXPECT_LE(z(dx, dy), 0.4);
        }
    }
}

// Expected: roughness g is the height of each octave over the one before, so the steps between
// neighbouring samples, made by the last octaves, grow with it.
TEST(Terrain, RoughnessRaisesTheFineDetail) {
    auto mean_step = [](double roughness) {
        const HeightField field = MakeTerrain({.seed = 3, .roughness = roughness},
                                              {.width_texels = 128, .height_texels = 128});
        double sum = 0;
        for (int j = 0; j < 128; ++j)
            for (int i = 0; i < 128; ++i)
                sum += std::abs(field.At((i + 1) % 128, j) - field.At(i, j));
        return sum / (128 * 128);
    };
    EXPECT_LT(2 * mean_step(0.35), mean_step(0.7));
}

TEST(Shapes, StayBetweenTheGroundAndOne) {
    double lowest = 1, highest = 0, ground = 0;
    for (int k = 0; k < 20000; ++k) {
        const double z = ShapesHeight({}, Uniform(8, 0, k, 0), Uniform(8, 0, k, 1));
        lowest = std::min(lowest, z);
        highest = std::max(highest, z);
        ground += z == 0;
    }
    EXPECT_EQ(lowest, 0);
    EXPECT_GT(highest, 0.8);
    EXPECT_LE(highest, 1);
    // Solids of half axes 0.32 to 0.52 cover 0.28 to 0.85 of their cells, overlaps apart.
    EXPECT_GT(ground / 20000, 0.15);
    EXPECT_LT(ground / 20000, 0.72);
}

TEST(Procedural, RefusesBadParametersWordForWord) {
    EXPECT_EQ(MessageOf(StoneWall{.courses = 1}), "StoneWall::courses = 1, must be in [2, 64]");
    EXPECT_EQ(MessageOf(StoneWall{.irregularity = NAN}),
              "StoneWall::irregularity = nan, must be in [0, 1]");
    EXPECT_EQ(MessageOf(Bricks{.courses = 7}),
              "Bricks::courses = 7, must be even and in [2, 64]");
    EXPECT_EQ(MessageOf(Bricks{.mortar = 0.5}), "Bricks::mortar = 0.5, must be in [0.02, 0.4]");
    EXPECT_EQ(MessageOf(Cobbles{.gap = -0.1}), "Cobbles::gap = -0.1, must be in [0, 0.2]");
    EXPECT_EQ(MessageOf(Gravel{.scales = 6}), "Gravel::scales = 6, must be in [1, 5]");
    EXPECT_EQ(MessageOf(HexTiles{.rows = 9}),
              "HexTiles::rows = 9, must be even and in [2, 128]");
    EXPECT_EQ(MessageOf(Terrain{.roughness = 0}),
              "Terrain::roughness = 0, must be in [0.1, 1]");
    EXPECT_EQ(MessageOf(Shapes{.edge = 1}), "Shapes::edge = 1, must be in [0.005, 0.2]");
    EXPECT_EQ(MessageOf(Tile{.width_texels = 1}),
              "Tile::width_texels = 1, must be in [2, 16384]");
    EXPECT_EQ(MessageOf(Tile{.amplitude_m = 0}),
              "Tile::amplitude_m = 0, must be finite and > 0");
    EXPECT_THROW(MakeBricks({.relief = 2}), Error);
    EXPECT_THROW(MakeGravel({}, {.height_m = INFINITY}), Error);
}

TEST(Catalogue, NamesAreUniqueAndFound) {
    std::set<std::string_view> names;
    for (const ProceduralKind& kind : ProceduralKinds()) {
        EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
        EXPECT_FALSE(kind.description.empty()) << kind.name;
        EXPECT_EQ(ProceduralKindNamed(kind.name).make, kind.make);
    }
    EXPECT_EQ(names.size(), Surfaces(1).size());
    EXPECT_DOUBLE_EQ(AdvisedTile(ProceduralKindNamed("shapes"), 8, 8).amplitude_m, 0.45);
}

TEST(Catalogue, RefusesAnUnknownNameWithTheListOfAll) {
    try {
        ProceduralKindNamed("brick");
        FAIL() << "no error";
    } catch (const Error& e) {
        EXPECT_STREQ(
            e.what(),
            "procedural surface \"brick\", must be one of stone_wall, bricks, cobbles, "
            "gravel, hex_tiles, terrain, ridges, shapes; did you mean bricks?");
    }
}

}  // namespace
}  // namespace plumb
