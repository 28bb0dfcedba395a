#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/visibility.h"
#include "fit/models/bounce_curve.h"
#include "fit/models/bounce_ratio.h"
#include "fit/models/direct_factor.h"
#include "fit/models/first_bounce.h"

namespace plumb {
namespace {

// A handful of roundings of numbers near 1.
constexpr double kRounding = 1e-15;

// Expected: alpha = 15/16 makes (1 - alpha)^(3/4) = 1/8 exactly, so F0 = 15/16 (1 + 1/16).
TEST(DirectFactor, PublishedValueByHand) {
    EXPECT_NEAR(Evaluate(kMayaux18DirectFactor, UniformVisibility(15.0 / 16)),
                15.0 / 16 * 17 / 16, kRounding);
}

// Expected: the two forms that [Mayaux18 eq. 7] prints are one: (1 - alpha)^(3/4) / 2 =
// (1 - alpha) / (2 (1 - alpha)^(1/4)).
TEST(DirectFactor, BothPrintedFormsAgree) {
    for (double alpha = 0.05; alpha < 1; alpha += 0.05)
        EXPECT_NEAR(Evaluate(kMayaux18DirectFactor, UniformVisibility(alpha)),
                    alpha * (1 + (1 - alpha) / (2 * std::sqrt(std::sqrt(1 - alpha)))),
                    kRounding);
}

TEST(DirectFactor, ClosedIsDarkAndOpenIsOne) {
    EXPECT_EQ(Evaluate(kMayaux18DirectFactor, UniformVisibility(0)), 0);
    EXPECT_EQ(Evaluate(kMayaux18DirectFactor, UniformVisibility(1)), 1);
}

// Expected: the header's rule, a <= 1 and p >= 1 keep alpha^2 <= F0 <= alpha (2 - alpha).
TEST(DirectFactor, KeepsTheBoundsOfVWithinTheRulesConstants) {
    for (double a : {-1.0, -0.5, 0.0, 0.5, 1.0})
        for (double p : {1.0, 1.5, 3.0, 10.0})
            for (double alpha = 0; alpha <= 1; alpha += 1.0 / 128) {
                const UniformVisibility at(alpha);
                const double F0 = Evaluate(DirectFactor<>{a, p}, at);
                EXPECT_GE(F0, LeastCosineVisibility(at) - kRounding) << a << " " << p;
                EXPECT_LE(F0, GreatestCosineVisibility(at) + kRounding) << a << " " << p;
            }
}

// Expected: the author's notebook fits E_1, and prints A as 86.635502983679205 / pi.
TEST(FirstBounce, PublishedAIsOfIrradianceOverPi) {
    EXPECT_NEAR(kMayaux18FirstBounce.A * std::numbers::pi, 86.635502983679205, 1e-13);
}

// Expected: alpha = 1/16 makes alpha^(1/4) = 1/2: F1 = A / 16 (15/16)^1.5 e^(-B/2).
// Tolerance: the value is about 0.3; four roundings.
TEST(FirstBounce, PublishedValueByHand) {
    const auto [A, B] = kMayaux18FirstBounce;
    EXPECT_NEAR(Evaluate(kMayaux18FirstBounce, UniformVisibility(1.0 / 16)),
                A / 16 * (15.0 / 16) * std::sqrt(15.0 / 16) * std::exp(-B / 2), kRounding);
}

TEST(FirstBounce, NothingComesBackWhereAllIsSkyOrAllIsWall) {
    EXPECT_EQ(Evaluate(kMayaux18FirstBounce, UniformVisibility(0)), 0);
    EXPECT_EQ(Evaluate(kMayaux18FirstBounce, UniformVisibility(1)), 0);
}

// Expected: 2 * 1/4 * (3/4)^2 * e^(-3 / 16) with C = 2, q = 2.
TEST(BounceCurve, FourConstantsByHand) {
    EXPECT_NEAR(
        Evaluate(BounceCurve<>{.A = 2, .B = 3, .C = 2, .q = 2}, UniformVisibility(0.25)),
        2 * 0.25 * 9.0 / 16 * std::exp(-3.0 / 16), kRounding);
}

// Expected: tau is made so that F0 + F1 / (1 - tau) = 1, that is, no light is lost at albedo 1.
TEST(BounceRatio, ClosesTheSeriesAtAlbedoOne) {
    const double F0 = 0.4, F1 = 0.25;
    EXPECT_NEAR(F0 + F1 / (1 - BounceRatio(F0, F1)), 1, kRounding);
    double sum = F0, F_k = F1;
    for (int k = 1; k <= 200; ++k, F_k *= BounceRatio(F0, F1)) sum += F_k;
    EXPECT_NEAR(sum, 1, 1e-13);  // tau^200 is nothing; 200 roundings of 1.
}

}  // namespace
}  // namespace plumb
