#include "fit/mayaux_faults.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fit/models/bounce_ratio.h"

namespace plumb {
namespace {

// Expected: found by an independent program with the published constants, to the digits given.
TEST(Poles, PublishedConstantsHaveOneForEveryAlbedo) {
    struct Known {
        double rho, alpha, half_unit;
    };
    for (const auto& [rho, alpha, half_unit] :
         {Known{0.05, 0.9511, 5e-5}, Known{0.2, 0.9570, 5e-5}, Known{0.5, 0.970264, 5e-7},
          Known{0.8, 0.9867, 5e-5}, Known{0.9, 0.9932, 5e-5}}) {
        const auto poles = PolesOf(kMayaux18, Albedo(rho));
        ASSERT_EQ(poles.size(), 1) << rho;
        EXPECT_NEAR(poles[0].value, alpha, half_unit) << rho;
    }
}

// Expected: at a pole 1 - rho tau passes through zero, so E changes its sign there, and is
// larger the nearer one comes. 1e-9 beside it, |E| is about F1 / (1e-9 d(rho tau)/dalpha).
TEST(Poles, TheTotalExplodesThere) {
    const Albedo rho(0.5);
    const double pole = PolesOf(kMayaux18, rho).at(0).value;
    const auto E = [&](double alpha) {
        return Evaluate(kMayaux18, PoleGuard::kNone, UniformVisibility(alpha), rho);
    };
    EXPECT_LT(E(pole - 1e-9) * E(pole + 1e-9), 0);
    EXPECT_GT(std::abs(E(pole + 1e-9)), 1e3);
}

TEST(Poles, NoneWithoutBouncesNorAtAlbedoOne) {
    EXPECT_TRUE(PolesOf(kMayaux18, Albedo(0)).empty());
    EXPECT_TRUE(PolesOf(kMayaux18, Albedo(1)).empty());
}

// Expected: p >= 1 and a <= 1 keep F0 <= 1, so (1 - rho)(1 - F0) + rho F1 > 0.
TEST(Poles, NoneWhereF0KeepsBelowOne) {
    const MayauxConstants<> bounded{.F0 = {.a = 1, .p = 1}, .F1 = kMayaux18FirstBounce};
    for (double rho : {0.05, 0.5, 0.95}) EXPECT_TRUE(PolesOf(bounded, Albedo(rho)).empty());
}

// Expected: a (1 - alpha)^(p - 1) > 1 <=> 1 - alpha < a^(1 / (1 - p)) = (1/2)^4 = 1/16.
// Tolerance: bisected to the last bit, in a function with roundings of 1e-16 and slope 1/4.
TEST(DirectFactorBound, PublishedIsBrokenBeyondFifteenSixteenths) {
    const auto broken = DirectFactorAboveBound(kMayaux18DirectFactor);
    ASSERT_EQ(broken.size(), 1);
    EXPECT_NEAR(broken[0].low, 15.0 / 16, 1e-14);
    EXPECT_EQ(broken[0].high, 1);
    EXPECT_TRUE(DirectFactorBelowBound(kMayaux18DirectFactor).empty());
}

// Expected: 0.949253, and the maximum 1.00614 at 0.98316, found by an independent program, to
// the digits given.
TEST(DirectFactorAboveOne, PublishedWhereAndByHowMuch) {
    const auto broken = DirectFactorAboveOne(kMayaux18DirectFactor);
    ASSERT_EQ(broken.size(), 1);
    EXPECT_NEAR(broken[0].low, 0.949253, 5e-7);
    EXPECT_EQ(broken[0].high, 1);
    EXPECT_NEAR(broken[0].worst_alpha, 0.98316, 5e-6);
    EXPECT_NEAR(broken[0].worst_excess, 0.00614, 5e-6);
}

// Expected: the excess over the bound is alpha (a u^p - u), u = 1 - alpha; where a = -2, p = 1,
// F0 = alpha (1 - 2u) < alpha^2 = alpha (1 - u) for all u in (0, 1), worst by alpha u at 1/2.
TEST(DirectFactorBound, BelowIsFoundToo) {
    const auto broken = DirectFactorBelowBound({.a = -2, .p = 1});
    ASSERT_EQ(broken.size(), 1);
    EXPECT_EQ(broken[0].low, 0);
    EXPECT_EQ(broken[0].high, 1);
    EXPECT_NEAR(broken[0].worst_alpha, 0.5, 1e-7);  // A maximum is flat: sqrt(epsilon).
    EXPECT_NEAR(broken[0].worst_excess, 0.25, 1e-14);
}

// Expected: a = 3, p = 2 gives a u^2 > u for u > 1/3 only: an interval that ends inside.
TEST(DirectFactorBound, AnIntervalMayEndInside) {
    const auto broken = DirectFactorAboveBound({.a = 3, .p = 2});
    ASSERT_EQ(broken.size(), 1);
    EXPECT_EQ(broken[0].low, 0);
    EXPECT_NEAR(broken[0].high, 2.0 / 3, 1e-14);
}

TEST(DirectFactorBound, TouchingItIsNotBreakingIt) {
    EXPECT_TRUE(DirectFactorAboveBound({.a = 1, .p = 1}).empty());
    EXPECT_TRUE(DirectFactorAboveOne({.a = 1, .p = 1}).empty());
    EXPECT_TRUE(DirectFactorBelowBound({.a = -1, .p = 1}).empty());
}

}  // namespace
}  // namespace plumb
