#include "fit/models/escape_probability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "fit/models/escape_bent_of_v.h"
#include "fit/models/escape_of_alpha_and_v.h"
#include "fit/models/mayaux_total.h"
#include "fit/models/uniform_cavity.h"
#include "tests/fit/light_laws.h"

namespace plumb {
namespace {

/// The corners and middles of a model's bounds, far beyond them too: the laws need no bounds.
const std::vector<double> kAnyFactor{-5, 0, 1e-12, 0.05, 0.5, 1, 4, 1e6};
const std::vector<double> kAnyExponent{0, 0.01, 0.4, 1, 6, 100};

// Expected: a V^b = 4 * 0.9 and -5 * 0.9 are no probabilities; 0.5 * 0.9^2 is. (The laws of the
// total hold for any g >= 0, so they cannot see a missing clamp.)
TEST(EscapeProbability, IsAProbability) {
    EXPECT_EQ(Evaluate(EscapeProbability<>{.a = 4, .b = 1}, 0.9), 1);
    EXPECT_EQ(Evaluate(EscapeProbability<>{.a = -5, .b = 1}, 0.9), 0);
    EXPECT_EQ(Evaluate(EscapeProbability<>{.a = 0.5, .b = 0}, 0.0), 0);
    EXPECT_NEAR(Evaluate(EscapeProbability<>{.a = 0.5, .b = 2}, 0.9), 0.405, kRounding);
}

TEST(EscapeOfV, KeepsItsLawsForAnyConstants) {
    for (double a : kAnyFactor)
        for (double b : kAnyExponent)
            for (double V : Shares()) {
                const std::array p{a, b};
                ExpectLaws(
                    [&](double rho) {
                        return EscapeOfV::Evaluate(p.data(), CosineVisibility(V), Albedo(rho));
                    },
                    V, testing::PrintToString(p) + " V " + testing::PrintToString(V));
            }
}

TEST(EscapeOfAlpha, KeepsItsLawsWithinTheBoundsOfF0) {
    for (double a0 : {-1.0, 0.0, 0.5, 1.0})
        for (double p0 : {1.0, 1.3, 10.0})
            for (double a : kAnyFactor)
                for (double alpha : Shares()) {
                    const std::array p{a0, p0, a, 0.4};
                    const UniformVisibility at(alpha);
                    const double V = Evaluate(DirectFactor<>{a0, p0}, at);
                    ASSERT_GE(V, 0);
                    ASSERT_LE(V, 1);
                    ExpectLaws(
                        [&](double rho) {
                            return EscapeOfAlpha::Evaluate(p.data(), at, Albedo(rho));
                        },
                        V,
                        testing::PrintToString(p) + " alpha " + testing::PrintToString(alpha));
                }
}

TEST(EscapeOfAlphaClamped, KeepsItsLawsForAnyF0ThatOnlyBrightens) {
    for (double a0 : {0.0, 0.5, 4.0, 1e6})
        for (double p0 : {0.0, 0.05, 0.75, 10.0})
            for (double a : kAnyFactor)
                for (double alpha : Shares()) {
                    const std::array p{a0, p0, a, 0.4};
                    const UniformVisibility at(alpha);
                    const double V = std::min(Evaluate(DirectFactor<>{a0, p0}, at),
                                              GreatestCosineVisibility(at));
                    ExpectLaws(
                        [&](double rho) {
                            return EscapeOfAlphaClamped::Evaluate(p.data(), at, Albedo(rho));
                        },
                        V,
                        testing::PrintToString(p) + " alpha " + testing::PrintToString(alpha));
                }
}

// Expected: with a0 = 1/2, p0 = 3/4 the clamp begins at alpha = 15/16 (fit/mayaux_faults.h):
// at rho = 0 the value is F0 before, and the bound after.
TEST(EscapeOfAlphaClamped, ClampsWhereF0BreaksTheBound) {
    const std::array p{0.5, 0.75, 1.0, 0.4};
    const auto E_0 = [&](double alpha) {
        return EscapeOfAlphaClamped::Evaluate(p.data(), UniformVisibility(alpha), Albedo(0));
    };
    EXPECT_NEAR(E_0(0.9), Evaluate(kMayaux18DirectFactor, UniformVisibility(0.9)), kRounding);
    EXPECT_NEAR(E_0(0.97), 0.97 * 1.03, kRounding);
}

// Expected: the bounds that a fit keeps are those that the laws need.
TEST(EscapeOfAlpha, BoundsOfTheFitKeepF0WithinTheBoundsOfV) {
    const auto& [a0, p0, a, b] = EscapeOfAlpha::kParameters;
    EXPECT_GE(a0.low, -1);
    EXPECT_LE(a0.high, 1);
    EXPECT_GE(p0.low, 1);
}

TEST(EscapeBentOfV, KeepsItsLawsWithinItsDomain) {
    for (double b : kAnyExponent)
        for (double c : {0.0, 0.3, 1.0})
            for (double V : Shares()) {
                const std::array p{b, c};
                ExpectLaws(
                    [&](double rho) {
                        return EscapeBentOfV::Evaluate(p.data(), CosineVisibility(V),
                                                       Albedo(rho));
                    },
                    V, testing::PrintToString(p) + " V " + testing::PrintToString(V));
            }
}

// V runs over all that an alpha allows: the least, the greatest, and their middle.
TEST(EscapeOfAlphaAndV, KeepsItsLawsWithinItsDomain) {
    for (double b : kAnyExponent)
        for (double c : kAnyExponent)
            for (double alpha : Shares())
                for (double share : {0.0, 0.5, 1.0}) {
                    const std::array p{b, c};
                    const UniformVisibility at(alpha);
                    const double V = std::lerp(LeastCosineVisibility(at),
                                               GreatestCosineVisibility(at), share);
                    ExpectLaws(
                        [&](double rho) {
                            return EscapeOfAlphaAndV::Evaluate(
                                p.data(), at, CosineVisibility(V), Albedo(rho));
                        },
                        V,
                        testing::PrintToString(p) + " alpha " + testing::PrintToString(alpha));
                }
}

// Expected: b = 1, c = 0 makes g = V, the cavity; b = 0, c = 1 makes g = alpha, which shows
// that the second input is read.
TEST(EscapeOfAlphaAndV, CornersByHand) {
    const UniformVisibility alpha(0.5);
    const CosineVisibility V(0.7);
    const Albedo rho(0.8);
    EXPECT_NEAR(EscapeOfAlphaAndV::Evaluate(std::array{1.0, 0.0}.data(), alpha, V, rho),
                CavityTotal(V, rho), kRounding);
    EXPECT_NEAR(EscapeOfAlphaAndV::Evaluate(std::array{0.0, 1.0}.data(), alpha, V, rho),
                EscapeTotal(0.7, 0.5, rho), kRounding);
}

// Expected: g = V^2 (1 - (1 - V) / 2) = 1/4 * 3/4 at V = 1/2.
TEST(EscapeBentOfV, ByHand) {
    EXPECT_NEAR(EscapeBentOfV::Evaluate(std::array{2.0, 0.5}.data(), CosineVisibility(0.5),
                                        Albedo(0.8)),
                EscapeTotal(0.5, 3.0 / 16, Albedo(0.8)), kRounding);
}

// Expected: a = b = 1, g = V, is the cavity: V / (1 - rho (1 - V)), exact in a spherical bowl.
TEST(EscapeOfV, HasTheCavityAsAMember) {
    const std::array p{1.0, 1.0};
    for (double V : {0.05, 0.3, 0.75})
        for (double rho : {0.0, 0.2, 0.9, 1.0})
            EXPECT_NEAR(EscapeOfV::Evaluate(p.data(), CosineVisibility(V), Albedo(rho)),
                        CavityTotal(CosineVisibility(V), Albedo(rho)), kRounding);
}

// Expected: the family is [Mayaux18 eq. 10] with F1 = (1 - F0) g, tau = 1 - g; and that tau is
// the one of [Mayaux18 eq. 9].
TEST(EscapeTotal, IsThePapersSeriesReparametrized) {
    for (double V : {0.05, 0.3, 0.75})
        for (double g : {0.1, 0.4, 0.9})
            for (double rho : {0.2, 0.5, 0.9}) {
                const double F1 = (1 - V) * g;
                EXPECT_NEAR(BounceRatio(V, F1), 1 - g, kRounding);
                EXPECT_NEAR(EscapeTotal(V, g, Albedo(rho)),
                            GeometricTotal(V, F1, 1 - g, Albedo(rho)), kRounding);
            }
}

// Expected: the infinite wedge of 60 degrees: V = sin^2(30 deg) = 1/4 everywhere on it, so at
// rho = 4/5 E = (1/4) / (1 - (4/5)(3/4)) = 5/8.
TEST(Cavity, WedgeOfSixtyDegrees) {
    EXPECT_NEAR(CavityTotal(CosineVisibility(0.25), Albedo(0.8)), 0.625, kRounding);
    EXPECT_EQ(CavityTotal(CosineVisibility(0), Albedo(1)), 1);
}

}  // namespace
}  // namespace plumb
