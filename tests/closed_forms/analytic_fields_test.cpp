#include "tests/closed_forms/analytic_fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "core/conventions.h"
#include "core/error.h"

namespace plumb {
namespace {

// A few roundings of numbers of size 1.
constexpr double kRounding = 1e-14;

template <class Params>
std::string MessageOf(const Params& p) {
    try {
        Validate(p);
    } catch (const Error& e) {
        return e.what();
    }
    return "no error";
}

// V of a point at (x, z) of a profile that goes on along y for ever and lies at or above the
// point on either side: V = 1/2 (sin theta_1 + sin theta_2), theta from the vertical to the
// horizon on either side, which stands on a vertex. The definition, not the closed form.
double ProfileV(double x, double z, const std::vector<Vec2>& vertices) {
    double sin_left = 1, sin_right = 1;
    for (const Vec2& vertex : vertices) {
        const double dx = vertex.x() - x, dz = vertex.y() - z;
        const double sine = std::abs(dx) / std::hypot(dx, dz);
        if (dz <= 0 || dx == 0) continue;
        double& horizon = dx < 0 ? sin_left : sin_right;
        horizon = std::min(horizon, sine);
    }
    return (sin_left + sin_right) / 2;
}

// Vertices of row 0, repeated by one period on either side.
std::vector<Vec2> Profile(const HeightField& field) {
    std::vector<Vec2> vertices;
    for (int period = -1; period <= 1; ++period)
        for (int i = 0; i < field.Width(); ++i)
            vertices.emplace_back((period * field.Width() + i + 0.5) * field.SpacingXM(),
                                  field.At(i, 0));
    return vertices;
}

TEST(Flat, IsLevelEverywhere) {
    const HeightField flat = MakeFlat({.width_texels = 5,
                                       .height_texels = 3,
                                       .spacing_m = 0.5,
                                       .height_m = 2,
                                       .boundary = Boundary::kMirror});
    EXPECT_EQ(flat.Width(), 5);
    EXPECT_EQ(flat.Height(), 3);
    EXPECT_EQ(flat.LowestM(), 2);
    EXPECT_EQ(flat.HighestM(), 2);
    EXPECT_EQ(flat.GetBoundary(), Boundary::kMirror);
}

TEST(Tilted, RisesByItsSlopesAndIsOpen) {
    const HeightField tilted = MakeTilted({.width_texels = 6,
                                           .height_texels = 4,
                                           .spacing_m = 0.25,
                                           .slope_x = 0.75,
                                           .slope_y = -2});
    EXPECT_EQ(tilted.GetBoundary(), Boundary::kOpen);
    // At the centre of texel (2, 1): x = 0.625, y = 0.375; exact in binary.
    EXPECT_EQ(tilted.At(2, 1), 0.75 * 0.625 - 2 * 0.375);
    EXPECT_EQ(tilted.At(5, 3), 0.75 * 1.375 - 2 * 0.875);
}

// Expected: from the definition. Every cell lies on one face, so each step is 1/n of a face:
// of the length L / n, and rising by tan(pi/2 - phi/2) on one side, falling so on the other.
TEST(VGroove, EveryCellLiesOnOneFace) {
    const VGroove p{
        .opening_rad = 1.1, .face_m = 2, .texels_per_face = 7, .grooves = 3, .rows = 2};
    const HeightField groove = MakeVGroove(p);
    ASSERT_EQ(groove.Width(), 2 * 7 * 3);
    EXPECT_EQ(groove.GetBoundary(), Boundary::kWrap);
    EXPECT_NEAR(groove.WidthM(), 3 * 2 * 2 * std::sin(0.55), kRounding * 10);
    EXPECT_EQ(groove.HighestM(), 0);
    EXPECT_NEAR(groove.LowestM(), -2 * std::cos(0.55), kRounding);
    for (int i = 0; i < groove.Width(); ++i) {
        const double dz = groove.At((i + 1) % groove.Width(), 1) - groove.At(i, 1);
        const double sign = i % 14 < 7 ? -1 : 1;
        EXPECT_NEAR(dz / groove.SpacingXM(), sign / std::tan(0.55), 100 * kRounding) << i;
        EXPECT_NEAR(std::hypot(dz, groove.SpacingXM()), 2.0 / 7, kRounding) << i;
    }
}

// Expected: the closed form of the header, for vertical walls replaced by ramps of one texel,
// against the horizon over the vertices. Both are exact: rounding only.
TEST(Trench, FloorSeesTheSkyOfItsHeader) {
    const Trench p{.width_m = 1.5, .depth_m = 0.8, .width_texels = 12, .land_texels = 5};
    const HeightField trench = MakeTrench(p);
    ASSERT_EQ(trench.Width(), 17);
    const double s = p.SpacingM(), w = p.width_m, d = p.depth_m;
    const std::vector<Vec2> profile = Profile(trench);
    for (int i = 0; i < 12; ++i) {
        ASSERT_EQ(trench.At(i, 0), -d);
        const double t = (i + 0.5) * s;  // The wall to the left has its middle at x = 0.
        const double right = w - t + s / 2, left = t + s / 2;
        const double V = (right / std::hypot(right, d) + left / std::hypot(left, d)) / 2;
        EXPECT_NEAR(ProfileV(t, -d, profile), V, kRounding) << i;
    }
    for (int i = 12; i < 17; ++i) EXPECT_EQ(trench.At(i, 0), 0);
}

// Expected: with vertical walls the mean of V over the floor is (sqrt(w^2 + d^2) - d) / w. The
// grid's error in the middle, t = w/2, is positive and halves with the spacing: to first order
// (s/2) d/dx (x / sqrt(x^2 + d^2)) at x = w/2 = (s/2) d^2 / (w^2/4 + d^2)^(3/2).
TEST(Trench, ErrorOfTheFloorIsOfFirstOrder) {
    const double w = 1, d = 1;
    const double exact = (w / 2) / std::hypot(w / 2, d);
    for (const int n : {101, 201, 401}) {
        const Trench p{.width_m = w, .depth_m = d, .width_texels = n, .land_texels = 3};
        const double s = p.SpacingM();
        const double error = ProfileV(w / 2, -d, Profile(MakeTrench(p))) - exact;
        const double first_order = s / 2 * d * d / std::pow(w * w / 4 + d * d, 1.5);
        // The second-order term is 3/2 x d^2 / (x^2 + d^2)^(5/2) (s/2)^2 < 0.11 s^2.
        EXPECT_NEAR(error, first_order, 0.11 * s * s) << n;
    }
}

TEST(Pit, RimLiesWithinADiagonalOfItsRadius) {
    const Pit p{.radius_m = 2, .depth_m = 0.7, .radius_texels = 9.3, .texels = 24};
    const HeightField pit = MakePit(p);
    const double s = p.SpacingM();
    EXPECT_EQ(pit.At(12, 12), -0.7);
    for (int j = 0; j < 24; ++j) {
        for (int i = 0; i < 24; ++i) {
            const double r = std::hypot((i - 12) * s, (j - 12) * s);
            EXPECT_EQ(pit.At(i, j), r < 2 ? -0.7 : 0) << i << ", " << j;
        }
    }
    EXPECT_NEAR(s, 2 / 9.3, kRounding);
    // The plane at z = 0 all round: the pit does not touch its own copy.
    for (int k = 0; k < 24; ++k) {
        EXPECT_EQ(pit.At(0, k), 0);
        EXPECT_EQ(pit.At(k, 0), 0);
        EXPECT_EQ(pit.At(23, k), 0);
    }
}

// Expected: the definition, every centre inside the rim stands on the sphere.
TEST(Bowl, TexelsStandOnTheSphere) {
    for (const double psi : {0.3, 1.0, kPi / 2}) {
        const Bowl p{
            .sphere_radius_m = 3, .half_angle_rad = psi, .rim_texels = 13, .texels = 32};
        const HeightField bowl = MakeBowl(p);
        const double s = p.SpacingM(), R = 3;
        EXPECT_NEAR(bowl.LowestM(), -R * (1 - std::cos(psi)), kRounding * R);
        EXPECT_EQ(bowl.HighestM(), 0);
        int inside = 0;
        for (int j = 0; j < 32; ++j) {
            for (int i = 0; i < 32; ++i) {
                const double r = std::hypot((i - 16) * s, (j - 16) * s);
                if (r >= R * std::sin(psi)) {
                    EXPECT_EQ(bowl.At(i, j), 0);
                    continue;
                }
                ++inside;
                EXPECT_NEAR(std::hypot(r, bowl.At(i, j) - R * std::cos(psi)), R, 2e-14 * R);
            }
        }
        // Lattice points in a circle of 13: pi 13^2 = 530.9, give or take its circumference.
        EXPECT_NEAR(inside, kPi * 13 * 13, 2 * kPi * 13);
    }
}

// Expected: the middle of a cell's diagonal, of length sqrt(2) s, lies above the sphere by
// (sqrt(2) s)^2 / 8 times the second derivative along it, between 1 / R (at the bottom) and
// 1 / (R cos^3 psi) (the rim): never below.
TEST(Bowl, FacetsAreChordsInsideTheSphere) {
    const double psi = 1, R = 1;
    const Bowl p{.sphere_radius_m = R, .half_angle_rad = psi, .rim_texels = 29, .texels = 64};
    const HeightField bowl = MakeBowl(p);
    const double s = p.SpacingM();
    double largest = 0;
    for (int j = 0; j + 1 < 64; ++j) {
        for (int i = 0; i + 1 < 64; ++i) {
            const double reach =
                std::max({std::hypot(i - 32, j - 32), std::hypot(i - 31, j - 31)});
            if (reach >= p.rim_texels) continue;
            const double z = (bowl.At(i, j) + bowl.At(i + 1, j + 1)) / 2;
            const double r = std::hypot((i - 31.5) * s, (j - 31.5) * s);
            const double error = z - (R * std::cos(psi) - std::sqrt(R * R - r * r));
            EXPECT_GE(error, 0.9 * s * s / (4 * R));  // 0.9: the fourth derivative, s small.
            largest = std::max(largest, error);
        }
    }
    EXPECT_LE(largest, s * s / (4 * R * std::pow(std::cos(psi), 3)));
    EXPECT_GE(largest, 2 * s * s / (4 * R));  // The bound is not idle: cos^-3 psi is 6.3.
}

// Expected: the wave itself at the centres; at the middle of a diagonal the chord is off by at
// most the header's bound, and by nearly that at the crests.
TEST(Sinusoid, ChordsStayWithinTheBoundOfTheHeader) {
    const Sinusoid p{.amplitude_m = 0.4,
                     .periods_x = 2,
                     .periods_y = 3,
                     .width_texels = 96,
                     .height_texels = 96,
                     .width_m = 2};
    const HeightField wave = MakeSinusoid(p);
    const double s = 2.0 / 96;
    const double k2 = (2 * 2 + 3 * 3) / 4.0;  // Tile of 2 m by 2 m.
    const double bound = kPi * kPi * 0.4 * s * s * k2 / 2;
    double largest = 0;
    for (int j = 0; j + 1 < 96; ++j) {
        for (int i = 0; i + 1 < 96; ++i) {
            const double u = (i + 1.0) / 96, v = (j + 1.0) / 96;
            const double exact = 0.2 * std::sin(2 * kPi * (2 * u + 3 * v));
            const double chord = (wave.At(i, j) + wave.At(i + 1, j + 1)) / 2;
            largest = std::max(largest, std::abs(chord - exact));
        }
    }
    EXPECT_LE(largest, bound);
    // Along the rising diagonal the wave number is (2 + 3) / sqrt(2): k^2 = 25/2 against 13.
    EXPECT_GE(largest, 0.95 * bound * 12.5 / 13);
    EXPECT_NEAR(wave.HighestM() - wave.LowestM(), 0.4, 2 * bound);
}

TEST(AnalyticFields, RefuseWhatTheyCannotMake) {
    EXPECT_EQ(MessageOf(Flat{.width_texels = 1}),
              "Flat::width_texels = 1, must be in [2, 16384]");
    EXPECT_EQ(MessageOf(Flat{.spacing_m = 0}), "Flat::spacing_m = 0, must be finite and > 0");
    EXPECT_EQ(MessageOf(Tilted{.slope_x = NAN}), "Tilted::slope_x = nan, must be finite");
    EXPECT_EQ(MessageOf(VGroove{.opening_rad = 0}),
              "VGroove::opening_rad = 0, must be in (0, pi)");
    EXPECT_EQ(MessageOf(VGroove{.rows = 1}), "VGroove::rows = 1, must be in [2, 16384]");
    EXPECT_EQ(MessageOf(Trench{.depth_m = -1}), "Trench::depth_m = -1, must be finite and > 0");
    EXPECT_EQ(MessageOf(Pit{.radius_texels = 30.5, .texels = 64}),
              "Pit::radius_texels = 30.5, must be in [1, texels / 2 - 2]");
    EXPECT_EQ(MessageOf(Bowl{.half_angle_rad = 2}),
              "Bowl::half_angle_rad = 2, must be in (0, pi/2]");
    EXPECT_EQ(MessageOf(Sinusoid{.periods_x = 32}),
              "Sinusoid::periods_x = 32, must be in [0, width_texels / 2)");
    EXPECT_EQ(MessageOf(Sinusoid{.periods_x = 0}),
              "Sinusoid::periods_x = 0, must be > 0 where periods_y is 0");
    EXPECT_THROW(MakePit({.depth_m = INFINITY}), Error);
    EXPECT_THROW(MakeTrench({.width_m = 0}), Error);
}

}  // namespace
}  // namespace plumb
