#include "core/distributions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/conventions.h"

// Where a comment says "40 digits", the value was computed with 40 significant digits by
// mpmath 1.3 (betainc, gammainc, erfc, or the sum of the binomial or Poisson terms where those
// fail) and is an independent method.
namespace plumb {
namespace {

const double kInfinity = std::numeric_limits<double>::infinity();

void ExpectRelative(double value, double expected, double tolerance) {
    EXPECT_NEAR(value / expected, 1, tolerance) << value << " instead of " << expected;
}

TEST(Normal, QuantilesAreThePublishedOnes) {
    // [Abramowitz64] table 26.5; 40 digits.
    ExpectRelative(NormalQuantile(0.975), 1.95996398454005424, 1e-15);
    ExpectRelative(NormalQuantile(0.9), 1.28155156554460047, 1e-15);
    ExpectRelative(NormalQuantile(1e-10), -6.3613409024040562, 1e-15);
    // 1 - p = 1e-6 is known to 1e-16 only, and dz/dp = 1 / (1e-6 z) there.
    ExpectRelative(NormalQuantile(0.999999), 4.75342430882289895, 1e-11);
    EXPECT_EQ(NormalQuantile(0.5), 0);
    EXPECT_EQ(NormalQuantile(0), -kInfinity);
    EXPECT_EQ(NormalQuantile(1), kInfinity);
}

TEST(Normal, QuantileUndoesCdf) {
    for (double z : {-30., -8., -3., -0.1, 0.5, 2., 5.}) {
        // Tolerance: P(Z <= z) carries 1e-16, above the median as an absolute error.
        const double density = std::exp(-z * z / 2) / std::sqrt(2 * kPi);
        const double carried = (z > 0 ? 1 : NormalCdf(z)) * 4e-16 / density;
        EXPECT_NEAR(NormalQuantile(NormalCdf(z)), z, carried + 1e-14);
    }
}

// Closed forms: dof 1 is Cauchy's, t = tan(pi (p - 1/2)); dof 2 has
// t = (2p - 1) / sqrt(2 p (1-p)).
TEST(Student, OneAndTwoDegreesOfFreedomHaveClosedForms) {
    for (double p : {0.001, 0.2, 0.6, 0.975}) {
        ExpectRelative(StudentQuantile(p, 1), std::tan(kPi * (p - 0.5)), 1e-13);
        ExpectRelative(StudentQuantile(p, 2), (2 * p - 1) / std::sqrt(2 * p * (1 - p)), 1e-13);
    }
    ExpectRelative(StudentQuantile(1e-10, 1), -1 / std::tan(kPi * 1e-10), 1e-13);
}

TEST(Student, QuantilesAreThePublishedOnes) {
    // [Abramowitz64] table 26.10 has 2.365, 4.144; 40 digits.
    ExpectRelative(StudentQuantile(0.975, 7), 2.36462425159278534, 1e-13);
    ExpectRelative(StudentQuantile(0.999, 10), 4.14370049404658967, 1e-12);
    ExpectRelative(StudentQuantile(0.95, 2.5), 2.55821861413593662, 1e-13);
    EXPECT_EQ(StudentQuantile(0.5, 3), 0);
    EXPECT_EQ(StudentQuantile(1, 3), kInfinity);
    EXPECT_EQ(StudentQuantile(0, 3), -kInfinity);
}

TEST(Student, ManyDegreesOfFreedomAreNormal) {
    // Cornish-Fisher: t = z + (z^3 + z) / (4 nu) + O(1 / nu^2), [Abramowitz64] 26.7.5.
    const double z = NormalQuantile(0.975), nu = 1e9;
    ExpectRelative(StudentQuantile(0.975, nu), z + (z * z * z + z) / (4 * nu), 1e-12);
}

TEST(Student, CdfIsSymmetricAndUndoesQuantile) {
    EXPECT_EQ(StudentCdf(0, 5), 0.5);
    for (double t : {0.3, 1.7, 6.}) {
        EXPECT_NEAR(StudentCdf(t, 5) + StudentCdf(-t, 5), 1, 1e-15);
        ExpectRelative(StudentQuantile(StudentCdf(-t, 5), 5), -t, 1e-13);
    }
}

// I_x(a, 1) = x^a, I_x(1, b) = 1 - (1-x)^b, I_x(1/2, 1/2) = 2/pi asin(sqrt(x)).
TEST(Beta, ClosedForms) {
    for (double x : {1e-6, 0.1, 0.5, 0.77, 0.999}) {
        ExpectRelative(BetaCdf(x, 3.5, 1), std::pow(x, 3.5), 1e-13);
        ExpectRelative(BetaCdf(x, 1, 40), -std::expm1(40 * std::log1p(-x)), 1e-13);
        ExpectRelative(BetaCdf(x, 0.5, 0.5), 2 / kPi * std::asin(std::sqrt(x)), 1e-13);
    }
    EXPECT_EQ(BetaCdf(0, 2, 3), 0);
    EXPECT_EQ(BetaCdf(1, 2, 3), 1);
}

TEST(Beta, ValuesOfFortyDigits) {
    ExpectRelative(BetaCdf(0.3, 2.5, 4), 0.352197585906767214, 1e-13);
    ExpectRelative(BetaCdf(0.001, 0.5, 3), 0.059253189515946234, 1e-13);
    ExpectRelative(BetaCdf(0.48, 500, 500), 0.102917527306995714, 1e-12);
    ExpectRelative(BetaCdf(0.25, 250'100, 750'000), 0.431402010398784701, 1e-12);
    ExpectRelative(BetaCdf(0.001, 1'003'000, 999'000'000), 0.00136473749201568329, 1e-9);
}

TEST(Beta, QuantileUndoesCdf) {
    for (double x : {1e-9, 0.01, 0.4, 0.9}) {
        for (double a : {0.5, 1., 7., 3000.}) {
            const double p = BetaCdf(x, a, 2.5);
            if (p < 1e-300) continue;  // 1e-9^3000 is no double
            ExpectRelative(BetaQuantile(p, a, 2.5), x, 1e-12);
        }
    }
    EXPECT_EQ(BetaQuantile(0, 2, 2), 0);
    EXPECT_EQ(BetaQuantile(1, 2, 2), 1);
}

// dof 1: erfc(sqrt(x/2)); dof 2: exp(-x/2); dof 4: exp(-x/2) (1 + x/2).
TEST(ChiSquare, ClosedForms) {
    for (double x : {0.01, 1., 3., 20., 200.}) {
        ExpectRelative(ChiSquareSurvival(x, 1), std::erfc(std::sqrt(x / 2)), 1e-12);
        ExpectRelative(ChiSquareSurvival(x, 2), std::exp(-x / 2), 1e-13);
        ExpectRelative(ChiSquareSurvival(x, 4), std::exp(-x / 2) * (1 + x / 2), 1e-13);
    }
    EXPECT_EQ(ChiSquareSurvival(0, 3), 1);
}

TEST(ChiSquare, ValuesOfFortyDigits) {
    ExpectRelative(ChiSquareSurvival(3.5, 5), 0.623387627749582035, 1e-13);
    ExpectRelative(ChiSquareSurvival(150, 100), 0.000903932042354009086, 1e-12);
    ExpectRelative(ChiSquareSurvival(1'003'000, 1'000'000), 0.0170167729332663151, 1e-12);
}

}  // namespace
}  // namespace plumb
