// Rays against bilinear patches, held against every patch one by one in long double.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "heightfield/relief/pyramid_cast.h"
#include "tests/heightfield/brute_force.h"

namespace plumb {
namespace {

// First t in [t_0, t_1] at which a parabola through its values at t_0, the middle and t_1 is <= 0.
std::optional<Real> FirstBelow(Real t_0, Real t_1, Real g_0, Real g_m, Real g_1) {
    if (g_0 <= 0) return t_0;
    // g = g_0 + b x + a x^2, x from 0 to 1.
    const Real a = 2 * (g_0 + g_1 - 2 * g_m), b = g_1 - g_0 - a;
    const Real discriminant = b * b - 4 * a * g_0;
    if (discriminant < 0) return std::nullopt;
    const Real root = std::sqrt(discriminant);
    std::optional<Real> first;
    for (const Real q : {-(b + root), -(b - root)}) {
        // x = q / (2 a) = 2 g_0 / q', q' the other root's q.
        const Real other = -2 * b - q;
        const Real x = std::abs(q) > std::abs(other) ? q / (2 * a) : 2 * g_0 / other;
        if (x >= 0 && x <= 1 && (!first || x < *first)) first = x;
    }
    if (!first) return std::nullopt;
    return t_0 + *first * (t_1 - t_0);
}

// All patches of an open field.
std::optional<Real> FirstOfAllPatches(const HeightField& f, const FieldRay& ray) {
    std::optional<Real> nearest;
    const Vec3 o = ray.origin_m, d = ray.direction;
    for (int j = 0; j < f.CellsY(); ++j) {
        for (int i = 0; i < f.CellsX(); ++i) {
            Real t_0 = 0, t_1 = 1e9;
            const auto clip = [&](Real from, Real along, Real low, Real high) {
                if (along == 0) {
                    if (from < low || from > high) t_1 = -1;
                    return;
                }
                const Real a = (low - from) / along, b = (high - from) / along;
                t_0 = std::max(t_0, std::min(a, b)), t_1 = std::min(t_1, std::max(a, b));
            };
            clip(o.x(), d.x(), i * f.SpacingXM(), (i + 1) * f.SpacingXM());
            clip(o.y(), d.y(), j * f.SpacingYM(), (j + 1) * f.SpacingYM());
            if (!(t_0 <= t_1)) continue;
            const auto gap = [&](Real t) {
                const Real u = (o.x() + t * d.x()) / f.SpacingXM() - i;
                const Real v = (o.y() + t * d.y()) / f.SpacingYM() - j;
                const Real low = (1 - u) * f.At(i, j) + u * f.At(i + 1, j);
                const Real high = (1 - u) * f.At(i, j + 1) + u * f.At(i + 1, j + 1);
                return o.z() + t * d.z() - ((1 - v) * low + v * high);
            };
            const auto first = FirstBelow(t_0, t_1, gap(t_0), gap((t_0 + t_1) / 2), gap(t_1));
            if (first && (!nearest || *first < *nearest)) nearest = first;
        }
    }
    return nearest;
}

// From above an open field into its footprint's top; answers that a rounding decides (a patch
// barely touched) show as one met, one not, and are counted: one in 10^7 or fewer.
TEST(BilinearCast, AgreesWithEveryPatch) {
    int met = 0;
    for (const double amplitude_m : {0.5, 2.0, 20.0}) {
        for (const Diagonal diagonal : {Diagonal::kRising, Diagonal::kFalling}) {
            const HeightField field =
                Rough(9, 7, amplitude_m, 0.7, 1.3, Boundary::kOpen, diagonal, 23);
            const HeightPyramid<double> pyramid(field);
            for (int k = 0; k < 5000; ++k) {
                const auto u = [&](int dimension) { return RandomUnit(83, k, dimension, 0); };
                FieldRay ray;
                ray.origin_m = Vec3(u(0) * field.WidthM(), u(1) * field.HeightM(), amplitude_m);
                ray.direction = Vec3(2 * u(2) - 1, 2 * u(3) - 1, -u(4) * amplitude_m);
                if (k % 8 == 1) ray.direction.x() = 0;
                if (k % 8 == 2) ray.direction.y() = 0;
                if (k % 8 == 3) ray.direction = Vec3(0, 0, -1);
                const auto expected = FirstOfAllPatches(field, ray);
                FieldHit hit;
                CastRays(pyramid, ReliefSurface::kBilinear, std::span(&ray, 1),
                         std::span(&hit, 1));
                ASSERT_EQ(hit.facet >= 0, expected.has_value()) << "ray " << k;
                if (!expected) continue;
                ++met;
                // At a glancing root t is known to the square root of a rounding.
                ASSERT_NEAR(hit.t, double(*expected), 1e-7) << "ray " << k;
                const Vec3 end_m = ray.origin_m + hit.t * ray.direction;
                EXPECT_EQ(hit.facet / 2,
                          std::min(int(end_m.y() / field.SpacingYM()), field.CellsY() - 1) *
                                  field.CellsX() +
                              std::min(int(end_m.x() / field.SpacingXM()), field.CellsX() - 1))
                    << "ray " << k;
            }
        }
    }
    EXPECT_GE(met, 10000);
}

// A saddle z = x y over one cell of 1 m, seen along its rising diagonal: the ray from (0, 0) is
// z = m t, the patch z = t^2. From the corner itself it comes back into the patch at t = m.
TEST(BilinearCast, ARayMayMeetThePatchThatItStartsOn) {
    Image<double> heights(2, 2, 0.0);
    heights(1, 1) = 1;
    const HeightField field(heights, 1, 1, Boundary::kOpen);
    const HeightPyramid<double> pyramid(field);
    for (const double m : {0.1, 0.5, 0.9, 1.1}) {
        const FieldRay ray{0, Vec3::Zero(), Vec3(1, 1, m)};
        FieldHit hit;
        CastRays(pyramid, ReliefSurface::kBilinear, std::span(&ray, 1), std::span(&hit, 1));
        if (m > 1) {
            EXPECT_EQ(hit.facet, kSky);
        } else {
            EXPECT_EQ(hit.facet, 0);
            EXPECT_NEAR(hit.t, m, 1e-15);
        }
    }
}

// The same four corners 0, 0, 0, 1: over the cell's middle the triangles stand at 1/2 on the
// rising diagonal and 0 on the falling one, the patch at 1/4.
TEST(BilinearCast, DiffersFromTrianglesByTheTwist) {
    Image<double> heights(2, 2, 0.0);
    heights(1, 1) = 1;
    const FieldRay down{FieldRay::kNoFacet, Vec3(0.5, 0.5, 1), Vec3(0, 0, -1)};
    const auto fall = [&](Diagonal diagonal, ReliefSurface surface) {
        const HeightPyramid<float> pyramid(
            HeightField(heights, 1, 1, Boundary::kOpen, diagonal));
        FieldHit hit;
        CastRays(pyramid, surface, std::span(&down, 1), std::span(&hit, 1));
        return hit.t;
    };
    EXPECT_EQ(fall(Diagonal::kRising, ReliefSurface::kTriangles), 0.5);
    EXPECT_EQ(fall(Diagonal::kFalling, ReliefSurface::kTriangles), 1);
    EXPECT_EQ(fall(Diagonal::kRising, ReliefSurface::kBilinear), 0.75);
    EXPECT_EQ(fall(Diagonal::kFalling, ReliefSurface::kBilinear), 0.75);
}

}  // namespace
}  // namespace plumb
