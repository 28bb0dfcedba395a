// Rays against a height field, held against an independent intersector (brute_force.h).
#include "heightfield/ray_cast.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/conventions.h"
#include "heightfield/facet.h"
#include "tests/closed_forms/analytic_fields.h"
#include "tests/heightfield/brute_force.h"

namespace plumb {
namespace {

// Near edges: a line at random lies within 1e-9 of one of the some 100 edges, of length near 1,
// with a chance near 1e-7 a ray: none in 72 000 rays, and one would not be surprising. Along a
// diagonal or a grid line the chance is the same, for the start is random.
TEST(CastFromFacet, AgreesWithBruteForceOnRoughFields) {
    const double width_m = 7 * 0.7;
    Tally all;
    for (const Boundary boundary : {Boundary::kWrap, Boundary::kMirror, Boundary::kOpen}) {
        for (const Diagonal diagonal : {Diagonal::kRising, Diagonal::kFalling}) {
            for (const double widths : {0.1, 0.5, 2.0, 10.0}) {
                SCOPED_TRACE(Name(boundary, diagonal, widths));
                const HeightField field =
                    Rough(7, 5, widths * width_m, 0.7, 1.3, boundary, diagonal, 17);
                const Tally tally = Compare(field, 3000, 23);
                all.same += tally.same, all.near_edge += tally.near_edge;
                all.out_of_reach += tally.out_of_reach, all.sky += tally.sky;
                all.below_horizon += tally.below_horizon;
                if (HasFailure()) return;
            }
        }
    }
    EXPECT_LE(all.near_edge, 2);
    // The test is about something: all kinds of rays were judged.
    EXPECT_LE(all.out_of_reach, 200);
    EXPECT_GE(all.sky, 10000);
    EXPECT_GE(all.same - all.sky, 10000);
    EXPECT_GE(all.below_horizon, 10000);
}

// 37 x 21 cells: blocks of 4 and 16 cells are crossed, the last of them partly outside, and a
// few high texels on a low floor make the walk skip most.
TEST(CastFromFacet, AgreesWithBruteForceWhereBlocksAreSkipped) {
    for (const Boundary boundary : {Boundary::kWrap, Boundary::kMirror, Boundary::kOpen}) {
        for (const Diagonal diagonal : {Diagonal::kRising, Diagonal::kFalling}) {
            SCOPED_TRACE(Name(boundary, diagonal, 0));
            Image<double> heights(37, 21);
            for (int j = 0; j < 21; ++j) {
                for (int i = 0; i < 37; ++i) {
                    const std::uint64_t texel = std::uint64_t(j * 37 + i);
                    heights(i, j) = 0.3 * RandomUnit(5, texel, 0, 0);
                    if (RandomUnit(5, texel, 1, 0) < 0.03) heights(i, j) += 6;
                }
            }
            const HeightField field(std::move(heights), 1, 1, boundary, diagonal);
            const Tally tally = Compare(field, 2500, 29);
            EXPECT_LE(tally.near_edge, 1);
            EXPECT_GE(tally.same, 2400);
            if (HasFailure()) return;
        }
    }
}

// Two cells across is the least a field can be.
TEST(CastFromFacet, AgreesWithBruteForceOnTheSmallestFields) {
    for (const Boundary boundary : {Boundary::kWrap, Boundary::kMirror, Boundary::kOpen}) {
        for (const auto& [width, height] :
             {std::pair(2, 2), std::pair(2, 3), std::pair(4, 2)}) {
            SCOPED_TRACE(Name(boundary, Diagonal::kRising, width));
            const HeightField field =
                Rough(width, height, 1.5, 1, 1, boundary, Diagonal::kRising, 31);
            Compare(field, 1000, 37);
            if (HasFailure()) return;
        }
    }
}

// A point of the axis of a one-texel spike lies inside it, so a ray towards it from the floor
// meets one of the six facets that share the spike's texel. Aimed at mid height, it passes the
// axis half a metre below the tip: no rounding can carry it past.
TEST(CastFromFacet, DoesNotStepThroughASpike) {
    for (const Diagonal diagonal : {Diagonal::kRising, Diagonal::kFalling}) {
        Image<double> heights(64, 48);
        heights(40, 30) = 1;
        const HeightField field(std::move(heights), 1, 1, Boundary::kWrap, diagonal);
        const WalkGrid grid(field);
        for (std::int64_t facet = 0; facet < field.Facets(); ++facet) {
            const Facet f = FacetOf(field, facet);
            if (f.normal.z() != 1) continue;
            const Vec3 from = PointOn(field, facet, 0.3, 0.45);
            for (const Vec3& tile : {Vec3(0, 0, 0), Vec3(-64, 48, 0), Vec3(64, 0, 0)}) {
                const Vec3 axis = Vec3(40, 30, 0.5) + tile;
                const std::int64_t met =
                    CastFromFacet(grid, facet, from, axis - from, FarDistanceM(field));
                ASSERT_GE(met, 0) << "from facet " << facet;
                const Facet hit = FacetOf(field, met);
                const bool of_the_spike = hit.corners_m[0].z() == 1 ||
                                          hit.corners_m[1].z() == 1 ||
                                          hit.corners_m[2].z() == 1;
                ASSERT_TRUE(of_the_spike) << "from facet " << facet << " to " << met;
            }
        }
    }
}

// Walls one texel wide: along x, along y and, with edges along it, along the diagonal. Whatever
// the azimuth, a line that reaches the crest line below the crest's height meets the wall.
TEST(CastFromFacet, DoesNotStepThroughAWall) {
    const int n = 40;
    for (const int kind : {0, 1, 2}) {
        Image<double> heights(n, n);
        for (int k = 0; k < n; ++k) {
            if (kind == 0) heights(k, 20) = 1;
            if (kind == 1) heights(20, k) = 1;
            if (kind == 2) heights(k, k) = 1;
        }
        const HeightField field(std::move(heights), 1, 1);
        const WalkGrid grid(field);
        const Vec3 across = kind == 0   ? Vec3(0, 1, 0)
                            : kind == 1 ? Vec3(1, 0, 0)
                                        : Vec3(1, -1, 0) / std::sqrt(2.0);
        for (std::uint64_t k = 0; k < 20000; ++k) {
            const std::int64_t facet =
                std::int64_t(RandomUnit(41, k, 0, 0) * double(field.Facets()));
            if (FacetOf(field, facet).normal.z() != 1) continue;
            const Vec3 from = PointOn(field, facet, 0.2, 0.5);
            const double phi = 2 * kPi * RandomUnit(41, k, 0, 1);
            // The greatest distance between two crests is n, so a ray that climbs less than
            // the height of a wall over it is caught.
            const double speed =
                std::abs(std::cos(phi) * across.x() + std::sin(phi) * across.y());
            const double slope = 0.999 * speed / n * RandomUnit(41, k, 0, 2);
            if (speed < 1e-3) continue;
            const Vec3 d(std::cos(phi), std::sin(phi), slope);
            ASSERT_GE(CastFromFacet(grid, facet, from, d, FarDistanceM(field)), 0)
                << "kind " << kind << " ray " << k;
        }
    }
}

// Expected: a ray that would pass the crest lower by one part in 1e12 meets the ramp in front
// of it, one that passes higher by as much sees the sky, for nothing is higher. Rounding moves
// the crossing by some 1e-15 of the distance: a thousand times less.
TEST(CastFromFacet, GrazesACrestToOnePartIn1e12) {
    Image<double> heights(48, 6);
    for (int j = 0; j < 6; ++j) heights(33, j) = 1;
    const HeightField field(std::move(heights), 0.7, 1.1);
    const WalkGrid grid(field);
    const double crest_m = 33 * 0.7;
    for (std::uint64_t k = 0; k < 2000; ++k) {
        const std::int64_t facet =
            std::int64_t(RandomUnit(43, k, 0, 0) * double(field.Facets()));
        if (FacetOf(field, facet).normal.z() != 1) continue;
        const Vec3 from = PointOn(field, facet, 0.25, 0.35);
        double ahead_m = crest_m - from.x();
        if (ahead_m < 0) ahead_m += field.WidthM();
        const Vec3 level(1, 2 * RandomUnit(43, k, 0, 1) - 1, 0);
        const auto cast = [&](double height) {
            return CastFromFacet(grid, facet, from, level + Vec3(0, 0, height / ahead_m),
                                 FarDistanceM(field));
        };
        EXPECT_EQ(cast(1 + 1e-12), kSky) << "ray " << k;
        const std::int64_t met = cast(1 - 1e-12);
        ASSERT_GE(met, 0) << "ray " << k;
        // The ramp that rises towards the crest: the cell left of texel 33.
        EXPECT_EQ(met / 2 % 48, 32) << "ray " << k;
    }
}

// Expected: moving the tile by whole texels moves starts and facets alike. With dyadic spacings
// and starts no coordinate is rounded, so the same crossings are compared.
TEST(CastFromFacet, DoesNotKnowWhereTheSeamIs) {
    for (const Diagonal diagonal : {Diagonal::kRising, Diagonal::kFalling}) {
        const int w = 13, h = 9, di = 5, dj = 7;
        const HeightField field = Rough(w, h, 4, 0.5, 1, Boundary::kWrap, diagonal, 47);
        const HeightField moved = Shifted(field, di, dj);
        const WalkGrid grid(field), moved_grid(moved);
        for (std::uint64_t k = 0; k < 20000; ++k) {
            Ray ray = RandomRay(field, 53, k);
            const Vec3 from = PointOn(field, ray.facet, 0.25, 0.25);
            const auto image = [&](std::int64_t facet) {
                const int i = int(facet / 2 % w), j = int(facet / 2 / w);
                return 2 * (std::int64_t((j + dj) % h) * w + (i + di) % w) + facet % 2;
            };
            const std::int64_t start = image(ray.facet);
            const std::int64_t met =
                CastFromFacet(grid, ray.facet, from, ray.direction, FarDistanceM(field));
            const std::int64_t met_moved =
                CastFromFacet(moved_grid, start, PointOn(moved, start, 0.25, 0.25),
                              ray.direction, FarDistanceM(moved));
            ASSERT_EQ(met_moved, met < 0 ? met : image(met)) << "ray " << k;
        }
    }
}

// A level ray never leaves an endless field through its top. It may go round for ever along a
// valley: that is kLost, never kSky.
TEST(CastFromFacet, ARayThatDoesNotRiseNeverSeesTheSky) {
    for (const Boundary boundary : {Boundary::kWrap, Boundary::kMirror}) {
        const HeightField field = Rough(9, 7, 3, 1, 1, boundary, Diagonal::kFalling, 59);
        const WalkGrid grid(field);
        int lost = 0, cast = 0;
        for (std::uint64_t k = 0; k < 20000; ++k) {
            Ray ray = RandomRay(field, 61, k);
            if (ray.direction.z() > 0) {
                const Vec3 n = FacetOf(field, ray.facet).normal;
                ray.direction.z() = 0;
                if (n.dot(ray.direction) <= 0) continue;
            }
            ++cast;
            const std::int64_t met = CastFromFacet(grid, ray.facet, ray.origin_m, ray.direction,
                                                   FarDistanceM(field));
            ASSERT_NE(met, kSky) << "ray " << k;
            lost += met == kLost;
            if (met == kLost) {
                ASSERT_EQ(ray.direction.z(), 0) << "ray " << k;
            }
        }
        EXPECT_GE(cast, 9000);
        // Only along grid lines and diagonals can a valley be endless here.
        EXPECT_LE(lost, cast / 4);
    }
}

TEST(CastFromFacet, FlatGroundSeesOnlySky) {
    for (const Boundary boundary : {Boundary::kWrap, Boundary::kMirror, Boundary::kOpen}) {
        const HeightField flat = MakeFlat(
            {.width_texels = 6, .height_texels = 5, .height_m = 0.1, .boundary = boundary});
        const WalkGrid grid(flat);
        for (std::uint64_t k = 0; k < 1000; ++k) {
            const Ray ray = RandomRay(flat, 67, k);
            EXPECT_EQ(
                CastFromFacet(grid, ray.facet, ray.origin_m, ray.direction, FarDistanceM(flat)),
                kSky);
        }
    }
}

// An inclined plane lies under every ray that leaves it, downhill and past the border too.
TEST(CastFromFacet, AnInclinedPlaneSeesOnlySky) {
    const HeightField plane =
        MakeTilted({.width_texels = 9, .height_texels = 8, .slope_x = 1.7, .slope_y = -0.4});
    const WalkGrid grid(plane);
    for (std::uint64_t k = 0; k < 5000; ++k) {
        const Ray ray = RandomRay(plane, 71, k);
        EXPECT_EQ(
            CastFromFacet(grid, ray.facet, ray.origin_m, ray.direction, FarDistanceM(plane)),
            kSky);
    }
}

TEST(CastFromFacet, UprightRaysSeeTheSky) {
    const HeightField field = Rough(6, 5, 50, 1, 1, Boundary::kWrap, Diagonal::kRising, 73);
    const WalkGrid grid(field);
    for (std::int64_t facet = 0; facet < field.Facets(); ++facet) {
        const Vec3 from = PointOn(field, facet, 0.3, 0.3);
        for (const double lean : {0.0, 1e-300, -1e-150, 1e-20, -1e-9}) {
            EXPECT_EQ(CastFromFacet(grid, facet, from, Vec3(lean, 0.5 * lean, 1),
                                    FarDistanceM(field)),
                      kSky);
        }
    }
}

// A groove of depth 1 along y, its bottom level: a ray along it at a slope of -1e-3 from half a
// metre up meets the floor 500 m away (the start lies on a face of the groove). kLost may be
// said only of a ray whose first facet lies beyond the distance given.
TEST(CastFromFacet, IsLostOnlyBeyondTheDistanceGiven) {
    Image<double> heights(8, 4, 1.0);
    for (int j = 0; j < 4; ++j) heights(3, j) = heights(4, j) = 0;
    const HeightField field(std::move(heights), 1, 1);
    const WalkGrid grid(field);
    // The lower facet of the cell from texel 2 (height 1) to texel 3 (height 0).
    const std::int64_t facet = 2 * 2;
    const Vec3 from(2.5, 0.25, 0.5);
    // Ahead by 1, across by 1e-3, down by 1e-3: over the floor all the time after the first
    // 500 m, the ramp below it before.
    const Vec3 d(2e-3, 1, -1e-3);
    const std::int64_t met = CastFromFacet(grid, facet, from, d, FarDistanceM(field));
    ASSERT_GE(met, 0);
    EXPECT_EQ(CastFromFacet(grid, facet, from, d, 600), met);
    EXPECT_EQ(CastFromFacet(grid, facet, from, d, 400), kLost);
    // A level ray along the floor's axis never meets anything.
    EXPECT_EQ(CastFromFacet(grid, facet, from, Vec3(1e-9, 1, 0), 1e5), kLost);
}

}  // namespace
}  // namespace plumb
