// The trench: its floor exactly, with the ramps that are its walls on the grid, and the light
// between floor and walls as the ramps grow steep.
#include "tests/closed_forms/trench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/conventions.h"
#include "formfactor/bounces.h"
#include "formfactor/slice_links.h"
#include "tests/closed_forms/analytic_fields.h"
#include "tests/formfactor/fields.h"

namespace plumb {
namespace {

// Facets of level floor see the sky between two rims w + s apart. Quadrature, as for the
// groove: along the trench the horizon on either side stands m |x| above the level, m = d /
// distance of the rim; solid angle has the kink m_1 + m_2, the cosine, sin^2 th / 2, the jump
// m_1^2 - m_2^2 in its second derivative.
TEST(TrenchLight, FloorHasItsClosedForm) {
    for (const double depth_m : {0.3, 1.0, 3.0}) {
        const Trench trench{
            .width_m = 1, .depth_m = depth_m, .width_texels = 9, .land_texels = 3, .rows = 2};
        const HeightField field = MakeTrench(trench);
        const double s = trench.SpacingM(), rims_m = 1 + s;
        for (const int slices : {64, 512}) {
            const double h = 2 * kPi / slices;
            const Links links = LinksBySlices(field, {.slices = slices,
                                                      .origins = Origins::kCentroid,
                                                      .horizon_tolerance_rad = 1e-8});
            int floor = 0, land = 0;
            for (std::int64_t i = 0; i < field.Facets(); ++i) {
                const Facet f = FacetOf(field, i);
                if (f.normal.z() < 0.999999) continue;
                if (f.corners_m[0].z() == 0) {
                    ++land;
                    EXPECT_EQ(links.V[i], 1);
                    EXPECT_EQ(links.alpha[i], 1);
                    continue;
                }
                ++floor;
                // The rim on the left stands one texel before texel 0, which is at s/2.
                const double t = f.CentroidM().x() + s / 2;
                const double m_1 = depth_m / t, m_2 = depth_m / (rims_m - t);
                const double alpha_bound = 1.5 * 2 * (m_1 + m_2) * h * h / 12 / (2 * kPi);
                const double V_bound = 1.5 * 2 * std::abs(m_1 * m_1 - m_2 * m_2) * h * h * h *
                                       std::sqrt(3) / 216 / kPi;
                EXPECT_NEAR(links.alpha[i],
                            TrenchFloorUniformVisibility(rims_m, depth_m, t).value,
                            alpha_bound + 1e-7);
                EXPECT_NEAR(links.V[i], TrenchFloorVisibility(rims_m, depth_m, t).value,
                            V_bound + 1e-6);
            }
            EXPECT_EQ(floor, 8 * 2 * 2);
            EXPECT_EQ(land, 2 * 2 * 2);
        }
    }
}

// A trench 1 x 1 whose walls are ramps of m texels, n texels wide at half height.
HeightField RampTrench(int n, int m) {
    const int land = 2;
    Image<double> heights(n + m + land, 2);
    for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < n + m + land; ++i) {
            const double down = i <= m       ? double(i) / m
                                : i <= n     ? 1
                                : i <= n + m ? double(n + m - i) / m
                                             : 0;
            heights(i, j) = -down;
        }
    }
    return HeightField(std::move(heights), 1.0 / n, 1.0 / n);
}

struct InTrench {
    double floor, wall, effective;  // E in the middle of floor and wall; effective albedo.
};

// For each albedo.
std::vector<InTrench> Simulate(int n, int m, const std::vector<double>& rho) {
    std::vector<InTrench> out;
    const HeightField field = RampTrench(n, m);
    const Links links = LinksBySlices(field, {.slices = 128});
    const Series series =
        RunSeries(links, {.bounces = 0, .albedos = rho}, [](int, std::span<const double>) {});
    const double middle_m = ((n + m) / 2 + 0.5) / n;
    for (std::size_t r = 0; r < rho.size(); ++r) {
        double floor = 0, wall = 0, area = 0, aperture = 0;
        int floors = 0, walls = 0;
        for (std::int64_t i = 0; i < field.Facets(); ++i) {
            const Facet f = FacetOf(field, i);
            const Vec3 c = f.CentroidM();
            const double E = series.total[r][i];
            if (std::abs(c.x() - middle_m) < 1.0 / n) floor += E, ++floors;
            if (f.normal.z() < 0.9 && std::abs(c.z() + 0.5) < 1.0 / m) wall += E, ++walls;
            if (c.z() == 0) continue;  // Land.
            area += f.area_m2 * E, aperture += f.area_m2 * f.normal.z();
        }
        out.push_back({floor / floors, wall / walls, 1 - (1 - rho[r]) * area / aperture});
    }
    return out;
}

// Expected: the facts table (Nystroem's method), in the limit of upright walls. A ramp as wide
// as r moves the rims apart by r, and the walls' normals up by as much: V in the middle of the
// floor, w / sqrt(w^2 + 4 d^2), grows by 4 d^2 / (w^2 + 4 d^2)^(3/2) r = 0.36 r, that of the
// wall by some 0.6 r (0.28 r from the width, cos(45 degrees) / 2 = 0.35 r from the tilt), and
// bounces shift it by a tenth: so 0 <= error <= 0.45 r and 0.75 r; of the effective albedo, for
// a trench with less wall beneath its aperture, up to 0.35 r. Of second order in r, found by
// extrapolation, 0.2 r^2 is left on floor and wall, 0.7 r^2 of the albedo; asked for: r^2,
// which is 0.004 at r = 1/16, with what chance leaves.
TEST(TrenchLight, BouncesTendToTheReferencesAsWallsGrowSteep) {
    const std::vector<double> rho = {0.2, 0.5, 0.8, 0.9};
    const InTrench references[] = {{.485169, .332808, .082308},
                                   {.575978, .457402, .258760},
                                   {.753361, .687578, .576019},
                                   {.854868, .816687, .751769}};
    const std::vector<InTrench> wide = Simulate(64, 8, rho), narrow = Simulate(128, 8, rho);
    const auto expect = [](double at_2r, double at_r, double reference, double slope) {
        const double r = 1.0 / 16;
        EXPECT_GT(at_r, reference);
        EXPECT_LT(at_r, reference + slope * r);
        EXPECT_GT(at_2r, reference);
        EXPECT_LT(at_2r, reference + slope * 2 * r);
        EXPECT_NEAR(2 * at_r - at_2r, reference, r * r);
    };
    for (std::size_t k = 0; k < rho.size(); ++k) {
        SCOPED_TRACE(rho[k]);
        expect(wide[k].floor, narrow[k].floor, references[k].floor, 0.45);
        expect(wide[k].wall, narrow[k].wall, references[k].wall, 0.75);
        expect(wide[k].effective, narrow[k].effective, references[k].effective, 0.35);
    }
}

}  // namespace
}  // namespace plumb
