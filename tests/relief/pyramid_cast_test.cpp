// Rays by the maximum mip-map, held against all triangles one by one (brute_force.h) and against
// the walk over facets, which knows no lanes.
#include "heightfield/relief/pyramid_cast.h"

#include <gtest/gtest.h>
#include <hwy/highway.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/conventions.h"
#include "heightfield/facet.h"
#include "tests/heightfield/brute_force.h"
#include "tests/relief/spiky_field.h"

namespace plumb {
namespace {

constexpr Boundary kBoundaries[] = {Boundary::kWrap, Boundary::kMirror, Boundary::kOpen};
constexpr Diagonal kDiagonals[] = {Diagonal::kRising, Diagonal::kFalling};

FieldRay OnFacet(const Ray& ray) {
    return {ray.facet, ray.origin_m, ray.direction};
}

template <class T>
FieldHit CastOne(const HeightPyramid<T>& field, const FieldRay& ray,
                 ReliefSurface surface = ReliefSurface::kTriangles) {
    FieldHit hit;
    CastRays(field, surface, std::span(&ray, 1), std::span(&hit, 1));
    return hit;
}

// Near edges: as in tests/heightfield/ray_cast_test.cpp, one ray in 10^7.
Tally AllTriangles(int rays_each) {
    const double width_m = 7 * 0.7;
    Tally all;
    for (const Boundary boundary : kBoundaries) {
        for (const Diagonal diagonal : kDiagonals) {
            for (const double widths : {0.1, 0.5, 2.0, 10.0}) {
                SCOPED_TRACE(Name(boundary, diagonal, widths));
                const HeightField field =
                    Rough(7, 5, widths * width_m, 0.7, 1.3, boundary, diagonal, 17);
                const HeightPyramid<double> pyramid(field);
                const Tally tally = CompareWith(field, rays_each, 61, [&](const Ray& ray) {
                    return CastOne(pyramid, OnFacet(ray)).facet;
                });
                all.same += tally.same, all.near_edge += tally.near_edge;
                all.out_of_reach += tally.out_of_reach, all.sky += tally.sky;
                all.below_horizon += tally.below_horizon;
                if (testing::Test::HasFailure()) return all;
            }
        }
    }
    return all;
}

TEST(PyramidCast, AgreesWithAllTriangles) {
    const Tally all = AllTriangles(2000);
    EXPECT_LE(all.near_edge, 2);
    EXPECT_LE(all.out_of_reach, 200);
    EXPECT_GE(all.sky, 7000);
    EXPECT_GE(all.same - all.sky, 7000);
    EXPECT_GE(all.below_horizon, 7000);
}

// By hand: a minute or two.
TEST(PyramidCast, DISABLED_AgreesWithAllTrianglesOnAMillionRays) {
    const Tally all = AllTriangles(42000);
    std::printf("%d rays the same, of them %d to the sky; %d near an edge, %d out of reach\n",
                all.same, all.sky, all.near_edge, all.out_of_reach);
    EXPECT_GE(all.same, 1000000);
}

// Squares of up to 64 cells are skipped, the last of a row partly outside. The walk is exact, so
// answers differ where rounding decides, at edges: no ray in a million is expected to.
TEST(PyramidCast, AgreesWithTheWalkWhereSquaresAreSkipped) {
    int met = 0;
    for (const Boundary boundary : kBoundaries) {
        for (const Diagonal diagonal : kDiagonals) {
            SCOPED_TRACE(Name(boundary, diagonal, 0));
            const HeightField field = SpikyField(97, 61, boundary, diagonal);
            const HeightPyramid<double> pyramid(field);
            const WalkGrid grid(field);
            const int rays = 40000;
            std::vector<FieldRay> asked(rays);
            std::vector<FieldHit> hits(rays);
            for (int k = 0; k < rays; ++k) asked[k] = OnFacet(RandomRay(field, 67, k));
            CastRays(pyramid, ReliefSurface::kTriangles, asked, hits);
            for (int k = 0; k < rays; ++k) {
                double height_m = 0;
                const std::int64_t facet =
                    CastFromFacet(grid, asked[k].facet, asked[k].origin_m, asked[k].direction,
                                  FarDistanceM(field), &height_m);
                ASSERT_EQ(hits[k].facet, facet) << "ray " << k;
                if (facet < 0) continue;
                ++met;
                // Both are some roundings of the distance off, times how steep the towers are,
                // over how flat they are met.
                const Vec3 end_m = asked[k].origin_m + hits[k].t * asked[k].direction;
                const double travelled_m = hits[k].t * asked[k].direction.norm();
                ASSERT_NEAR(end_m.z(), height_m, 1e-9 * (1 + travelled_m)) << "ray " << k;
            }
        }
    }
    EXPECT_GE(met, 60000);
}

// Expected: one ray in 10^4 passes an edge within what float knows of a place, 97 * 2^-24 cells
// times some roundings, at one of the some 10 edges that it crosses near the surface: 3e-4 of
// them at most.
TEST(PyramidCast, FloatDiffersWhereRoundingDecidesOnly) {
    const int rays = 50000;
    const HeightField field = SpikyField(97, 61, Boundary::kWrap, Diagonal::kRising);
    const HeightPyramid<double> pyramid(field);
    const HeightPyramid<float> coarse(field);
    std::vector<FieldRay> asked(rays);
    std::vector<FieldHit> exact(rays), found(rays);
    for (int k = 0; k < rays; ++k) asked[k] = OnFacet(RandomRay(field, 71, k));
    CastRays(pyramid, ReliefSurface::kTriangles, asked, exact);
    CastRays(coarse, ReliefSurface::kTriangles, asked, found);
    int differ = 0;
    for (int k = 0; k < rays; ++k) differ += (exact[k].facet < 0) != (found[k].facet < 0);
    EXPECT_LE(differ, rays * 3e-4);
}

// From points of the space about the field, tiles away and above: nothing is known of where such
// a ray enters.
TEST(PyramidCast, RaysThatStartAnywhereAgreeWithAllTriangles) {
    int met = 0, judged = 0;
    for (const Boundary boundary : kBoundaries) {
        for (const Diagonal diagonal : kDiagonals) {
            SCOPED_TRACE(Name(boundary, diagonal, 0));
            const HeightField field = Rough(7, 5, 2, 0.7, 1.3, boundary, diagonal, 19);
            const HeightPyramid<double> pyramid(field);
            const BruteForce brute(field);
            for (int k = 0; k < 3000; ++k) {
                const auto u = [&](int d) { return RandomUnit(73, k, d, 0); };
                Ray ray;
                ray.facet = FieldRay::kNoFacet;
                ray.origin_m = Vec3(14 * u(0) - 5, 18 * u(1) - 6, 2 + 3 * u(2));
                ray.direction = Vec3(2 * u(3) - 1, 2 * u(4) - 1, -u(5));
                if (k % 8 == 1) ray.direction.x() = 0;
                if (k % 8 == 2) ray.direction.y() = 0;
                const double level = std::hypot(ray.direction.x(), ray.direction.y()),
                             reach = 6 / std::max(1e-3, -ray.direction.z()) * level;
                if (reach > 100) continue;
                const auto expected = brute.Cast(ray, reach + 1e-6);
                // Solid ground under an open border is met through its side.
                if (expected.near_edge) continue;
                if (boundary == Boundary::kOpen &&
                    (expected.facet == kSky || !expected.from_above))
                    continue;
                const FieldHit hit =
                    CastOne(pyramid, {FieldRay::kNoFacet, ray.origin_m, ray.direction});
                if (boundary == Boundary::kOpen && hit.facet != expected.facet &&
                    hit.t < double(expected.distance) - 1e-9) {
                    continue;  // Through the side.
                }
                ++judged;
                ASSERT_EQ(hit.facet, expected.facet) << "ray " << k;
                if (hit.facet < 0) continue;
                ++met;
                ASSERT_NEAR(hit.t, double(expected.distance), 1e-9 * (1 + reach))
                    << "ray " << k;
            }
        }
    }
    EXPECT_GE(met, 8000);
    EXPECT_GE(judged, met);
}

TEST(PyramidCast, UprightLevelAndBuriedRays) {
    Image<double> heights(6, 4, 1.0);
    heights(2, 1) = 3;
    for (const Boundary boundary : kBoundaries) {
        const HeightField field(heights, 1, 1, boundary);
        const HeightPyramid<double> pyramid(field);
        const auto cast = [&](Vec3 from, Vec3 along) {
            return CastOne(pyramid, {FieldRay::kNoFacet, from, along});
        };
        // Down onto the tower's axis, and beside it.
        EXPECT_NEAR(cast({2, 1, 7}, {0, 0, -2}).t, 2, 1e-12);
        EXPECT_NEAR(cast({4.25, 2.5, 7}, {0, 0, -2}).t, 3, 1e-12);
        EXPECT_EQ(cast({4.25, 2.5, 7}, {0, 0, 1}).facet, kSky);
        EXPECT_EQ(cast({4.25, 2.5, 1.5}, {0, 0, 1}).facet, kSky);
        // Under the ground, on it, and above it heading for the tower.
        EXPECT_GE(cast({4.25, 2.5, 0.5}, {1, 2, 3}).facet, 0);
        EXPECT_EQ(cast({4.25, 2.5, 0.5}, {1, 2, 3}).t, 0);
        EXPECT_EQ(cast({4.25, 2.5, 1}, {1, 0, 0}).t, 0);
        EXPECT_NEAR(cast({4, 1, 2}, {-1, 0, 0}).t, 1.5, 1e-12);
        // Level and between heights that nothing ahead has: sky, or given up.
        EXPECT_EQ(cast({4, 2.5, 1.5}, {1, 0, 0}).facet,
                  boundary == Boundary::kOpen ? kSky : kLost);
        // Beside an open field, away from it; over it and away.
        if (boundary == Boundary::kOpen) {
            EXPECT_EQ(cast({-1, 1, 2}, {-1, 0, 0}).facet, kSky);
            EXPECT_EQ(cast({-1, 1, 5}, {0, 1, -9}).facet, kSky);
            EXPECT_EQ(cast({-1, 1, 5}, {1, 0, -9}).t, 1);  // Into its side, under the border.
            EXPECT_NEAR(cast({-1, 1, 2}, {1, 0, 0}).t, 2.5, 1e-12);
        }
    }
}

TEST(PyramidCast, ManyFromOnePointAreAsOneByOne) {
    for (const Boundary boundary : kBoundaries) {
        for (const Diagonal diagonal : kDiagonals) {
            const HeightField field = SpikyField(41, 29, boundary, diagonal);
            const HeightPyramid<float> pyramid(field);
            for (std::int64_t facet = 0; facet < field.Facets(); facet += 97) {
                const Facet f = FacetOf(field, facet);
                const FieldRay point{facet, PointOn(field, facet, 0.3, 0.3), f.normal};
                std::vector<Vec3f> directions;
                std::vector<FieldRay> rays;
                for (std::uint64_t k = 0; k < 700; ++k) {
                    Vec3 d = f.normal + 0.999 * Vec3(std::cos(double(k)), std::sin(double(k)),
                                                     RandomUnit(3, k, facet, 0))
                                                    .normalized();
                    if (k == 0) d = Vec3(0, 0, 1);
                    directions.push_back(d.cast<float>());
                    rays.push_back({facet, point.origin_m, directions.back().cast<double>()});
                }
                std::vector<std::uint64_t> met(11);
                std::vector<FieldHit> hits(rays.size());
                MeetFromPoint(pyramid, ReliefSurface::kTriangles, point, directions, met);
                CastRays(pyramid, ReliefSurface::kTriangles, rays, hits);
                for (std::size_t k = 0; k < rays.size(); ++k) {
                    ASSERT_EQ(met[k / 64] >> (k % 64) & 1, hits[k].facet != kSky)
                        << "direction " << k << " from facet " << facet;
                }
                ASSERT_EQ(met[10] >> 60, 0u);
            }
        }
    }
}

class PyramidCastMachines : public testing::Test {
  protected:
    ~PyramidCastMachines() override { Use(0); }
    static void Use(std::int64_t target) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
};

TEST_F(PyramidCastMachines, GiveTheSameBits) {
    const HeightField field = SpikyField(41, 29, Boundary::kMirror, Diagonal::kFalling);
    const HeightPyramid<float> coarse(field);
    const HeightPyramid<double> fine(field);
    std::vector<FieldRay> rays;
    for (int k = 0; k < 1500; ++k) rays.push_back(OnFacet(RandomRay(field, 79, k)));
    const auto all = [&] {
        std::vector<FieldHit> hits, some(rays.size());
        for (const auto surface : {ReliefSurface::kTriangles, ReliefSurface::kBilinear}) {
            CastRays(coarse, surface, rays, some);
            hits.insert(hits.end(), some.begin(), some.end());
            CastRays(fine, surface, rays, some);
            hits.insert(hits.end(), some.begin(), some.end());
        }
        return hits;
    };
    const std::vector<FieldHit> best = all();
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        Use(target);
        const std::vector<FieldHit> hits = all();
        for (std::size_t k = 0; k < hits.size(); ++k) {
            ASSERT_EQ(hits[k].facet, best[k].facet) << hwy::TargetName(target) << ' ' << k;
            ASSERT_EQ(hits[k].t, best[k].t) << hwy::TargetName(target) << ' ' << k;
        }
    }
}

}  // namespace
}  // namespace plumb
