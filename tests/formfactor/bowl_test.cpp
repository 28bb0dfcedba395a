// The bowl and the pit: closed forms for all bounces, met on the grid to first order in the
// spacing because a rim falls between texels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/conventions.h"
#include "formfactor/bounces.h"
#include "formfactor/slice_links.h"
#include "tests/closed_forms/analytic_fields.h"
#include "tests/closed_forms/equal_sky.h"
#include "tests/closed_forms/pit.h"
#include "tests/formfactor/fields.h"

namespace plumb {
namespace {

// What a point of the bowl sees more, if the rim at radius r lies up to `wider_m` further out:
// at most the form factor to that ring of the ground's plane.
double RingFormFactor(const Vec3& point, const Vec3& normal, double r_m, double wider_m) {
    const int azimuths = 256, radii = 8;
    double sum = 0;
    for (int a = 0; a < azimuths; ++a) {
        for (int b = 0; b < radii; ++b) {
            const double phi = 2 * kPi * (a + 0.5) / azimuths;
            const double r = r_m + wider_m * (b + 0.5) / radii;
            const Vec3 to = Vec3(r * std::cos(phi), r * std::sin(phi), 0) - point;
            const double area = r * (2 * kPi / azimuths) * (wider_m / radii);
            sum +=
                std::max(0.0, to.dot(normal)) * to.z() * area / (kPi * std::pow(to.norm(), 4));
        }
    }
    return sum;
}

struct OnTheGrid {
    double spacing_m;
    double mean_V_off;      // Mean of V - V_exact over facets well inside.
    double log_off_at_20;   // Mean of ln(E_20 / exact).
    double aperture_V_off;  // What leaves per bounce if light is even: see below.
};

// The rim of the grid's bowl: texels from r outwards stand at z = 0, so the horizon lies
// between r and r + sqrt(2) s, on chords at most a second order lower. V is therefore too large
// by at most the form factor of that ring. A facet's normal is the sphere's at the middle of
// its hypotenuse, a sixth of that, 0.24 s / cos(psi) along the sphere, from its centroid; V
// changes by no more than the angle, so +-0.24 s / (R cos psi) besides.
//
// Bounces: what is under way is spread evenly by area after a bounce, as on the sphere. Of it
// V' = A_aperture / A_bowl would leave, both areas of the very facets, if the sphere were whole
// (the aperture identity); facets at the rim see more sky than the others and send less light
// on. So a bounce loses between V and V' to the sky, E_k >= V (1 - V')^k, and
// E_k <= (V + ring) (1 - V)^k. V' - V is of first order too.
OnTheGrid Check(int rim_texels) {
    const double psi = kPi / 3;
    const Bowl bowl{
        .half_angle_rad = psi, .rim_texels = double(rim_texels), .texels = 2 * rim_texels + 6};
    const HeightField field = MakeBowl(bowl);
    const Links links = LinksBySlices(field, {.slices = 24, .origins = Origins::kCentroid});
    std::vector<std::vector<double>> E;
    ForEachBounce(links, 20, [&](int, std::span<const double> E_k) {
        E.emplace_back(E_k.begin(), E_k.end());
    });
    const double s = bowl.SpacingM(), r = bowl.RimRadiusM();
    const double V = BowlVisibility(psi).value, f = 1 - V;
    const Vec3 middle((bowl.texels / 2 + 0.5) * s, (bowl.texels / 2 + 0.5) * s, 0);
    const Vec3 centre(0, 0, std::cos(psi));

    double aperture_m2 = 0, bowl_m2 = 0;
    for (std::int64_t i = 0; i < field.Facets(); ++i) {
        const Facet facet = FacetOf(field, i);
        const auto& p = facet.corners_m;
        if (p[0].z() == 0 && p[1].z() == 0 && p[2].z() == 0) continue;
        aperture_m2 += facet.area_m2 * facet.normal.z();
        bowl_m2 += facet.area_m2;
    }
    const double V_even = aperture_m2 / bowl_m2;

    OnTheGrid out{s, 0, 0, V_even - V};
    int inside = 0;
    for (std::int64_t i = 0; i < field.Facets(); ++i) {
        const Vec3 p = FacetOf(field, i).CentroidM() - middle;
        if (std::hypot(p.x(), p.y()) > 0.8 * r) continue;
        ++inside;
        const double ring = RingFormFactor(p, (centre - p).normalized(), r, std::sqrt(2) * s);
        const double tilt = 0.24 * s / std::cos(psi);
        EXPECT_GE(links.V[i], V - tilt);
        EXPECT_LE(links.V[i], V + ring + tilt);
        for (int k = 0; k <= 20; ++k) {
            EXPECT_GE(E[k][i], (V - tilt) * std::pow(1 - V_even, k)) << "bounce " << k;
            EXPECT_LE(E[k][i], (V + ring + tilt) * std::pow(f, k)) << "bounce " << k;
        }
        out.mean_V_off += links.V[i] - V;
        out.log_off_at_20 += std::log(E[20][i] / CavityBounce(CosineVisibility(V), 20));
        if (std::hypot(p.x(), p.y()) < 0.6 * s) {
            // At the bottom the rim is a circle about the normal; the centroid lies off the
            // bottom by a distance, and above it by a height, of second order in alpha.
            const double h = bowl.DepthM();
            const double alpha = BowlBottomUniformVisibility(psi).value;
            EXPECT_GE(links.alpha[i], alpha - s * s);
            EXPECT_LE(links.alpha[i],
                      PitFloorUniformVisibility(r + std::sqrt(2) * s, h).value + s * s);
        }
    }
    out.mean_V_off /= inside;
    out.log_off_at_20 /= inside;
    return out;
}

// First order: half the spacing, half the error, to within what the accidents of a circle on a
// grid leave (a factor of 1.5 to 2.7 was asked for, 1.7 to 2.2 found).
TEST(BowlLight, ConvergesAtFirstOrderForAllBounces) {
    const OnTheGrid coarse = Check(8), middle = Check(16), fine = Check(32);
    const auto expect_halved = [](double at_2s, double at_s) {
        EXPECT_GT(at_2s / at_s, 1.5);
        EXPECT_LT(at_2s / at_s, 2.7);
    };
    expect_halved(coarse.mean_V_off, middle.mean_V_off);
    expect_halved(middle.mean_V_off, fine.mean_V_off);
    expect_halved(coarse.log_off_at_20, middle.log_off_at_20);
    expect_halved(middle.log_off_at_20, fine.log_off_at_20);
    expect_halved(coarse.aperture_V_off, middle.aperture_V_off);
    EXPECT_LT(fine.mean_V_off, 0.004);
}

// The rim lies between R - s^2/(4R) and R + sqrt(2) s, so V and alpha in the middle between
// their values there; the two facets beside the middle texel lie within 0.6 s of it, which is a
// second order.
TEST(PitLight, MiddleOfTheFloorLiesBetweenTheRims) {
    for (const double depth_m : {0.5, 1.0, 2.0}) {
        for (const int radius_texels : {6, 18}) {
            const Pit pit{.radius_m = 1,
                          .depth_m = depth_m,
                          .radius_texels = double(radius_texels),
                          .texels = 2 * radius_texels + 6};
            const HeightField field = MakePit(pit);
            const Links links =
                LinksBySlices(field, {.slices = 32, .origins = Origins::kCentroid});
            const double s = pit.SpacingM(), wide = 1 + std::sqrt(2) * s;
            const double middle_m = (pit.texels / 2 + 0.5) * s;
            int compared = 0;
            for (std::int64_t i = 0; i < field.Facets(); ++i) {
                const Vec3 p = FacetOf(field, i).CentroidM();
                if (std::hypot(p.x() - middle_m, p.y() - middle_m) > 0.6 * s) continue;
                ++compared;
                EXPECT_GE(links.V[i], PitFloorVisibility(1, depth_m).value - s * s);
                EXPECT_LE(links.V[i], PitFloorVisibility(wide, depth_m).value + s * s);
                EXPECT_GE(links.alpha[i], PitFloorUniformVisibility(1, depth_m).value - s * s);
                EXPECT_LE(links.alpha[i],
                          PitFloorUniformVisibility(wide, depth_m).value + s * s);
            }
            EXPECT_EQ(compared, 2);
        }
    }
}

}  // namespace
}  // namespace plumb
