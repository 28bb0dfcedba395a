// The closed forms against the tables of numbers that were found independently, and against
// their definitions, integrated by brute force.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "core/conventions.h"
#include "core/vec.h"
#include "tests/closed_forms/equal_sky.h"
#include "tests/closed_forms/pit.h"
#include "tests/closed_forms/trench.h"

namespace plumb {
namespace {

constexpr double kDegree = kPi / 180;

// alpha and V of a point of something endless along y, from its cross-section: directions at
// equal angles a about the normal, blocked where they cut a segment. In the plane,
// alpha = 1/pi Int v da and V = 1/2 Int v cos a da. An edge between open and blocked is off by
// half a step pi/N at most, and there are two of them: alpha is off by 1/N, V by pi/(2N).
constexpr int kDirections = 20000;
constexpr double kSectionError = 2.0 / kDirections;

std::pair<double, double> SectionVisibility(const Vec2& x, const Vec2& normal,
                                            const std::vector<std::pair<Vec2, Vec2>>& walls) {
    double alpha = 0, V = 0;
    for (int k = 0; k < kDirections; ++k) {
        const double a = kPi * ((k + 0.5) / kDirections - 0.5);
        const Vec2 d(std::cos(a) * normal.x() - std::sin(a) * normal.y(),
                     std::sin(a) * normal.x() + std::cos(a) * normal.y());
        bool open = true;
        for (const auto& [p, q] : walls) {
            const Vec2 e = q - p, o = p - x;
            const double det = d.x() * e.y() - d.y() * e.x();
            const double t = (o.x() * e.y() - o.y() * e.x()) / det;
            const double s = (o.x() * d.y() - o.y() * d.x()) / det;
            if (t > 0 && s >= 0 && s <= 1) open = false;
        }
        alpha += open;
        V += open ? std::cos(a) : 0;
    }
    return {alpha / kDirections, V * kPi / 2 / kDirections};
}

// Facts table: infinite wedge, V at 30, 60, 90, 120 degrees, six digits.
TEST(Wedge, HasTheTabulatedVisibility) {
    EXPECT_NEAR(WedgeVisibility(30 * kDegree).value, 0.066987, 5e-7);
    EXPECT_NEAR(WedgeVisibility(60 * kDegree).value, 0.25, 1e-15);
    EXPECT_NEAR(WedgeVisibility(90 * kDegree).value, 0.5, 1e-15);
    EXPECT_NEAR(WedgeVisibility(120 * kDegree).value, 0.75, 1e-15);
    EXPECT_NEAR(WedgeUniformVisibility(60 * kDegree).value, 1.0 / 3, 1e-15);
}

// The other face seen from distance 1, as a segment 1e6 long: it ends 1e-6 rad early.
TEST(Wedge, IsItsDefinition) {
    for (const double beta : {0.3, 1.0, 1.7, 2.9}) {
        const Vec2 far(1e6 * std::cos(beta), 1e6 * std::sin(beta));
        const auto [alpha, V] = SectionVisibility({1, 0}, {0, 1}, {{Vec2(0, 0), far}});
        EXPECT_NEAR(WedgeUniformVisibility(beta).value, alpha, kSectionError);
        EXPECT_NEAR(WedgeVisibility(beta).value, V, kSectionError);
    }
}

TEST(Groove, IsItsDefinition) {
    for (const double phi : {0.4, 1.0, kPi / 2, 2.5}) {
        for (const double s : {0.02, 0.3, 0.5, 0.98}) {
            // One face along x, the other from the apex at angle phi.
            const auto [alpha, V] = SectionVisibility(
                {s, 0}, {0, 1}, {{Vec2(0, 0), Vec2(std::cos(phi), std::sin(phi))}});
            EXPECT_NEAR(GrooveUniformVisibility(phi, s).value, alpha, kSectionError);
            EXPECT_NEAR(GrooveVisibility(phi, s).value, V, kSectionError);
        }
    }
}

// At 60 degrees and s = 1/2 the crest of the other face stands upright over the point: half the
// sky's cosine. Close to the apex a groove is a wedge.
TEST(Groove, HasItsKnownLimits) {
    EXPECT_NEAR(GrooveVisibility(60 * kDegree, 0.5).value, 0.5, 1e-15);
    EXPECT_NEAR(GrooveUniformVisibility(60 * kDegree, 0.5).value, 0.5, 1e-15);
    for (const double phi : {0.5, 1.5, 2.5}) {
        // d V / d s is at most 1/2 at s = 0.
        EXPECT_NEAR(GrooveVisibility(phi, 1e-9).value, WedgeVisibility(phi).value, 1e-9);
        EXPECT_NEAR(GrooveUniformVisibility(phi, 1e-9).value, WedgeUniformVisibility(phi).value,
                    1e-9);
    }
}

// Midpoint rule, n = 20 000: its error is f'' / (24 n^2), and |V''| < 1e4 down to 0.4 rad.
TEST(Groove, FaceMeanIsTheMeanOfTheFace) {
    for (const double phi : {0.4, 1.0, kPi / 2, 2.5}) {
        const int n = 20000;
        double sum = 0;
        for (int k = 0; k < n; ++k) sum += GrooveVisibility(phi, (k + 0.5) / n).value;
        EXPECT_NEAR(GrooveFaceMeanVisibility(phi), sum / n, 1e-6);
    }
}

// Facts table of trenches, w = d = 1, eight digits.
TEST(TrenchForms, HaveTheTabulatedVisibility) {
    EXPECT_NEAR(TrenchFloorVisibility(1, 1, 0.5).value, 0.44721360, 5e-9);
    EXPECT_NEAR(TrenchFloorVisibility(1, 1, 0.25).value, 0.42126781, 5e-9);
    EXPECT_NEAR(TrenchWallVisibility(1, 0.5).value, 0.27639320, 5e-9);
}

TEST(TrenchForms, AreTheirDefinition) {
    for (const auto& [w, d] : {std::pair(1.0, 1.0), std::pair(1.0, 4.0), std::pair(5.0, 1.0)}) {
        const std::vector<std::pair<Vec2, Vec2>> walls = {{Vec2(0, 0), Vec2(0, d)},
                                                          {Vec2(w, 0), Vec2(w, d)}};
        for (const double share : {0.05, 0.3, 0.5, 0.9}) {
            const auto [alpha, V] = SectionVisibility({share * w, 0}, {0, 1}, walls);
            EXPECT_NEAR(TrenchFloorVisibility(w, d, share * w).value, V, kSectionError);
            EXPECT_NEAR(TrenchFloorUniformVisibility(w, d, share * w).value, alpha,
                        kSectionError);
            // On the left wall, at depth share d; the floor is in the way too.
            const auto [alpha_wall, V_wall] =
                SectionVisibility({0, d - share * d}, {1, 0},
                                  {{Vec2(w, 0), Vec2(w, d)}, {Vec2(0, 0), Vec2(w, 0)}});
            EXPECT_NEAR(TrenchWallVisibility(w, share * d).value, V_wall, kSectionError);
            EXPECT_NEAR(0.5 - std::atan(share * d / w) / kPi, alpha_wall, kSectionError);
        }
    }
}

// Facts table of round pits, r/d = 1/4, 1/2, 1, 2, nine digits.
TEST(PitForms, HaveTheTabulatedVisibility) {
    const double r[] = {0.25, 0.5, 1, 2};
    const double V[] = {0.058823529, 0.2, 0.5, 0.8};
    const double alpha[] = {0.029857500, 0.105572809, 0.292893219, 0.552786405};
    for (int k = 0; k < 4; ++k) {
        EXPECT_NEAR(PitFloorVisibility(3 * r[k], 3).value, V[k], 5e-10);
        EXPECT_NEAR(PitFloorUniformVisibility(3 * r[k], 3).value, alpha[k], 5e-10);
        // A cap of sky about the normal: the greatest V for its alpha.
        EXPECT_NEAR(GreatestCosineVisibility(PitFloorUniformVisibility(r[k], 1)),
                    PitFloorVisibility(r[k], 1).value, 1e-15);
    }
}

// Facts table of bowls: depth h = R, R/2, R/4 (cos psi = 1 - h/R), V = 1 - h/(2R).
TEST(BowlForms, HaveTheTabulatedVisibility) {
    const double h[] = {1, 0.5, 0.25};
    const double V[] = {0.5, 0.75, 0.875};
    const double alpha[] = {0.292893219, 0.5, 0.646446609};
    for (int k = 0; k < 3; ++k) {
        const double psi = std::acos(1 - h[k]);
        EXPECT_NEAR(BowlVisibility(psi).value, V[k], 1e-15);
        EXPECT_NEAR(BowlBottomUniformVisibility(psi).value, alpha[k], 5e-10);
        // The rim is a circle about the bottom's normal.
        EXPECT_NEAR(GreatestCosineVisibility(BowlBottomUniformVisibility(psi)), V[k], 1e-15);
    }
}

// Facts table: E(rho) of bowls, rho = 1/2 and 0.8; of the 90 degree wedge, 1 / (2 - rho).
TEST(CavityBounces, SumToTheTabulatedTotals) {
    const auto total = [](CosineVisibility V, double rho) {
        double sum = 0;
        for (int k = 0; k < 400; ++k) sum += std::pow(rho, k) * CavityBounce(V, k);
        return sum;
    };
    const CosineVisibility half = BowlVisibility(kPi / 2), shallow = BowlVisibility(kPi / 3);
    EXPECT_NEAR(total(half, 0.5), 2.0 / 3, 1e-12);
    EXPECT_NEAR(total(half, 0.8), 5.0 / 6, 1e-12);
    EXPECT_NEAR(total(shallow, 0.5), 0.857142857, 5e-10);
    EXPECT_NEAR(total(shallow, 0.8), 0.9375, 1e-12);
    EXPECT_NEAR(total(BowlVisibility(std::acos(0.75)), 0.5), 0.933333, 5e-7);
    EXPECT_NEAR(total(BowlVisibility(std::acos(0.75)), 0.8), 0.972222, 5e-7);
    EXPECT_NEAR(total(WedgeVisibility(kPi / 2), 0.5), 1 / 1.5, 1e-12);
    EXPECT_NEAR(total(WedgeVisibility(60 * kDegree), 0.8), 0.625, 1e-12);
    EXPECT_NEAR(total(shallow, 1), 1, 1e-12);
}

}  // namespace
}  // namespace plumb
