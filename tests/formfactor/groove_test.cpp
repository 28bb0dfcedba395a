// The V-groove, exact on the grid: every facet against its closed form, and light between the
// faces against references found by another method.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/conventions.h"
#include "formfactor/bounces.h"
#include "formfactor/slice_links.h"
#include "formfactor/total.h"
#include "tests/closed_forms/analytic_fields.h"
#include "tests/closed_forms/equal_sky.h"
#include "tests/closed_forms/trench.h"
#include "tests/formfactor/fields.h"

namespace plumb {
namespace {

constexpr double kDegree = kPi / 180;

// Distance of a point of the groove from its apex line, in face lengths.
double FromApex(const VGroove& groove, const Vec3& p) {
    return (p.z() + groove.DepthM()) / groove.DepthM();
}

// What slices at N azimuths h = 2 pi / N apart may be off, at any turn. As a function of phi
// what a slice sees is smooth but for kinks at the two azimuths along the groove, x away from
// which the horizon stands m |x| above the level: with beta half the opening, m = cot(beta) on
// the facet's own side, less on the other. So solid angle, dG/dth = 1, has a jump of
// J = 2 cot(beta) in its derivative; the cosine, dG/dth = c = cos(beta) x, one of
// J_2 = 4 cos(beta) cot(beta) in its second derivative only. By Euler and Maclaurin a jump
// costs J h^2 max|B_2| / 2 = J h^2 / 12, or J_2 h^3 max|B_3| / 6 = J_2 h^3 sqrt(3) / 216. There
// are two; the totals are 2 pi and pi. Half as much again for the orders that follow.
struct QuadratureBound {
    double alpha, V;
};
QuadratureBound BoundOf(const VGroove& groove, int slices) {
    const double beta = groove.opening_rad / 2, h = 2 * kPi / slices;
    const double J = 2 / std::tan(beta), J_2 = 2 * std::cos(beta) * J;
    return {1.5 * 2 * J * h * h / 12 / (2 * kPi),
            1.5 * 2 * J_2 * h * h * h * std::sqrt(3) / 216 / kPi};
}

TEST(VGrooveLight, EveryFacetHasItsClosedForm) {
    for (const double opening : {30 * kDegree, 60 * kDegree, 90 * kDegree, 140 * kDegree}) {
        const VGroove groove{.opening_rad = opening, .texels_per_face = 9, .rows = 2};
        const HeightField field = MakeVGroove(groove);
        for (const int slices : {16, 64, 512}) {
            const QuadratureBound bound = BoundOf(groove, slices);
            const Links links = LinksBySlices(field, {.slices = slices,
                                                      .origins = Origins::kCentroid,
                                                      .horizon_tolerance_rad = 1e-8});
            double worst_alpha = 0, worst_V = 0;
            for (std::int64_t i = 0; i < field.Facets(); ++i) {
                const double s = FromApex(groove, FacetOf(field, i).CentroidM());
                worst_alpha = std::max(
                    worst_alpha,
                    std::abs(links.alpha[i] - GrooveUniformVisibility(opening, s).value));
                worst_V = std::max(worst_V,
                                   std::abs(links.V[i] - GrooveVisibility(opening, s).value));
            }
            EXPECT_LE(worst_alpha, bound.alpha + 1e-12) << opening << ", " << slices;
            EXPECT_LE(worst_V, bound.V + 2 * kFloatRow) << opening << ", " << slices;
        }
    }
}

// The same without any quadrature error: the sums over the very azimuths, worked out here from
// the groove's cross-section. On its own side a facet sees all above its plane; on the other the
// horizon is the crest, H up and D away. V = Sum G(th_horizon) / Sum G(th_plane),
// alpha = Sum (1 - cos th_horizon) / Sum (1 - cos th_plane), with
// G(th) = Int_0^th (c sin t + n_z cos t) sin t dt integrated by Simpson's rule (error below
// 1e-12 at 400 steps).
TEST(VGrooveLight, SlicesSumWhatTheySay) {
    const auto G = [](double c, double n_z, double th) {
        const int steps = 400;
        double sum = 0;
        for (int k = 0; k <= steps; ++k) {
            const double t = th * k / steps;
            const double f = (c * std::sin(t) + n_z * std::cos(t)) * std::sin(t);
            sum += f * (k == 0 || k == steps ? 1 : k % 2 == 1 ? 4 : 2);
        }
        return sum * th / steps / 3;
    };
    for (const double opening : {30 * kDegree, 100 * kDegree}) {
        const VGroove groove{.opening_rad = opening, .texels_per_face = 3, .rows = 2};
        const HeightField field = MakeVGroove(groove);
        for (const int slices : {4, 8, 32}) {  // None runs along the groove.
            const Links links = LinksBySlices(field, {.slices = slices,
                                                      .origins = Origins::kCentroid,
                                                      .rotate = false,
                                                      .horizon_tolerance_rad = 1e-9});
            for (std::int64_t i = 0; i < field.Facets(); ++i) {
                const Facet f = FacetOf(field, i);
                const double s = FromApex(groove, f.CentroidM());
                const double H = groove.DepthM() * (1 - s), D = groove.PeriodM() / 2 * (1 + s);
                double cosine = 0, cosine_all = 0, solid = 0, solid_all = 0;
                for (int k = 0; k < slices; ++k) {
                    const double cos_phi = std::cos(2 * kPi * (k + 0.5) / slices);
                    const double c = f.normal.x() * cos_phi, n_z = f.normal.z();
                    const double plane = kPi / 2 + std::atan2(c, n_z);
                    // Towards its normal a facet looks at the other face.
                    const double horizon =
                        c > 0 ? kPi / 2 - std::atan(H / D * std::abs(cos_phi)) : plane;
                    cosine += G(c, n_z, horizon), cosine_all += G(c, n_z, plane);
                    solid += 1 - std::cos(horizon), solid_all += 1 - std::cos(plane);
                }
                EXPECT_NEAR(links.V[i], cosine / cosine_all, 2 * kFloatRow + 1e-8);
                EXPECT_NEAR(links.alpha[i], solid / solid_all, 1e-8);
            }
        }
    }
}

// The apex is the limit in which a groove is an endless wedge.
TEST(VGrooveLight, NearTheApexAGrooveIsAWedge) {
    const VGroove groove{.opening_rad = kPi / 3, .texels_per_face = 30, .rows = 2};
    const HeightField field = MakeVGroove(groove);
    const Links links = LinksBySlices(field, {.slices = 64, .origins = Origins::kCentroid});
    int compared = 0;
    for (std::int64_t i = 0; i < field.Facets(); ++i) {
        const double s = FromApex(groove, FacetOf(field, i).CentroidM());
        if (s > 1.0 / 30) continue;
        ++compared;
        // dV/ds <= 1/2, d alpha/ds <= sin(phi)/pi at the apex, and the quadrature.
        const QuadratureBound bound = BoundOf(groove, 64);
        EXPECT_NEAR(links.V[i], WedgeVisibility(kPi / 3).value, 0.5 * s + bound.V + 1e-4);
        EXPECT_NEAR(links.alpha[i], WedgeUniformVisibility(kPi / 3).value,
                    0.5 * s + bound.alpha + 1e-4);
    }
    EXPECT_EQ(compared, 8);
}

struct Reference {
    double opening_deg, rho, middle, mean, effective;
};
// Facts table: Nystroem's method with 200 and 400 nodes, which agree to six digits, and
// independent Monte Carlo within 2e-4.
constexpr Reference kReferences[] = {
    {60, .2, .556065, .550631, .118990}, {60, .5, .666494, .654098, .345902},
    {60, .8, .831219, .818385, .672646}, {60, .9, .907075, .898292, .820342},
    {90, .2, .765188, .749080, .152512}, {90, .5, .837952, .824295, .417136},
    {90, .8, .927447, .919921, .739807}, {90, .9, .962191, .957982, .864521}};

// Expected: E(rho) in the middle of a face, its mean and the effective albedo
// 1 - (1 - rho) Sum A E / A_aperture, of light that is constant on each facet: second order in
// 1/n. In the middle the error is that of reading E(1/2) from the facets of the two cells
// beside it: they lie 1/(3n) and 2/(3n) off and are themselves spread, a variance of 1/(3 n^2)
// in all, so E'' / (6 n^2), and |E''| <= 0.45 (the 90 degree groove at rho = 0: 0.75 / 1.25^2.5
// = 0.43; bounces are smoother). For the mean, and the effective albedo, 0.03 / n^2 and 0.011 /
// n^2 were found at n = 4, 8, 16 and 32 alike (0.017 to 0.025 and 0.005 to 0.007). Chance, over
// seeds: standard errors of 4e-5 in the middle and 8e-5 of the mean at most; four of them.
TEST(VGrooveLight, BouncesConvergeToTheReferencesAtSecondOrder) {
    for (const int n : {4, 8, 16}) {
        for (const double opening : {60.0, 90.0}) {
            const VGroove groove{
                .opening_rad = opening * kDegree, .texels_per_face = n, .rows = 2};
            const HeightField field = MakeVGroove(groove);
            const Links links = LinksBySlices(field, {.slices = 4096 / n});
            for (const Reference& reference : kReferences) {
                if (reference.opening_deg != opening) continue;
                const double rho = reference.rho;
                const Series series = RunSeries(links, {.bounces = 0, .albedos = {rho}},
                                                [](int, std::span<const double>) {});
                const TotalLight light =
                    SolveTotal(links, std::vector<double>(links.V.size(), rho));
                double middle = 0, mean = 0;
                for (std::int64_t i = 0; i < field.Facets(); ++i) {
                    const double s = FromApex(groove, FacetOf(field, i).CentroidM());
                    if (std::abs(s - 0.5) < 1.0 / n) middle += light.E[i] / 16;
                    mean += light.E[i] / double(field.Facets());
                    EXPECT_NEAR(series.total[0][i], light.E[i], 1e-4);
                }
                // Every facet of a face has the n_z of the groove: A_aperture / A = sin(phi/2).
                const double effective =
                    1 - (1 - rho) * mean / GrooveFaceMeanVisibility(opening * kDegree);
                const double square = 1.0 / (n * n);
                EXPECT_NEAR(middle, reference.middle, 0.075 * square + 1.6e-4)
                    << opening << ", " << rho << ", " << n;
                EXPECT_NEAR(mean, reference.mean, 0.03 * square + 3.2e-4)
                    << opening << ", " << rho << ", " << n;
                EXPECT_NEAR(effective, reference.effective, 0.011 * square + 3.2e-4)
                    << opening << ", " << rho << ", " << n;
            }
        }
    }
}

}  // namespace
}  // namespace plumb
