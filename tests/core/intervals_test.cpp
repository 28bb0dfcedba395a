#include "core/intervals.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/distributions.h"
#include "core/random.h"

namespace plumb {
namespace {

// Closed forms at the ends: nothing seen in n trials leaves p_high = 1 - (a/2)^(1/n).
TEST(ClopperPearson, EndsHaveClosedForms) {
    const Interval none = ClopperPearsonInterval(0, 10, 0.95);
    EXPECT_EQ(none.low, 0);
    EXPECT_NEAR(none.high, 1 - std::pow(0.025, 0.1), 1e-14);
    const Interval all = ClopperPearsonInterval(10, 10, 0.95);
    EXPECT_NEAR(all.low, std::pow(0.025, 0.1), 1e-14);
    EXPECT_EQ(all.high, 1);
}

// Definition: at the lower end P(at least k successes) = a/2, at the upper end P(at most k).
TEST(ClopperPearson, EndsLeaveTheTailsOfTheBinomial) {
    const int k = 3, n = 12;
    const Interval interval = ClopperPearsonInterval(k, n, 0.9);
    const auto at_most = [&](int most, double p) {
        double sum = 0;
        for (int i = 0; i <= most; ++i) {
            sum += std::tgamma(n + 1) / (std::tgamma(i + 1) * std::tgamma(n - i + 1)) *
                   std::pow(p, i) * std::pow(1 - p, n - i);
        }
        return sum;
    };
    // Tolerance: 13 terms, each rounded a few times at 1e-16.
    EXPECT_NEAR(1 - at_most(k - 1, interval.low), 0.05, 1e-13);
    EXPECT_NEAR(at_most(k, interval.high), 0.05, 1e-13);
}

// By definition Wilson's ends solve |k/n - p| = z sqrt(p (1-p) / n).
TEST(Wilson, EndsLieZStandardErrorsFromTheRate) {
    const Interval interval = WilsonInterval(3, 12, 0.95);
    const double z = NormalQuantile(0.975);
    for (double p : {interval.low, interval.high}) {
        EXPECT_NEAR(std::abs(0.25 - p), z * std::sqrt(p * (1 - p) / 12), 1e-14);
    }
    EXPECT_LT(interval.low, 0.25);
    EXPECT_GT(interval.high, 0.25);
}

TEST(Wilson, StaysWithinZeroAndOne) {
    EXPECT_EQ(WilsonInterval(0, 5, 0.99).low, 0);
    EXPECT_EQ(WilsonInterval(5, 5, 0.99).high, 1);
    EXPECT_GT(WilsonInterval(0, 5, 0.99).high, 0);
}

/// The exact chance that the interval holds p, summed over the binomial.
template <class IntervalOf>
double Coverage(IntervalOf interval_of, int n, double p) {
    double covered = 0;
    for (int k = 0; k <= n; ++k) {
        const Interval interval = interval_of(k, n, 0.95);
        if (interval.low <= p && p <= interval.high) {
            covered +=
                std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) +
                         k * std::log(p) + (n - k) * std::log(1 - p));
        }
    }
    return covered;
}

TEST(ClopperPearson, NeverCoversLessThanItSays) {
    for (int n : {4, 16, 64}) {
        for (double p : {0.01, 0.1, 0.3, 0.5, 0.97}) {
            EXPECT_GE(Coverage(ClopperPearsonInterval, n, p), 0.95) << n << " " << p;
        }
    }
}

// Expected: near 0.95 on the average over p; that is Wilson's bargain. No closed form is known
// for how near, so the tolerance is what we ask for: a tenth of the risk of 0.05.
TEST(Wilson, CoversWhatItSaysOnAverage) {
    double sum = 0;
    for (int i = 0; i < 500; ++i) sum += Coverage(WilsonInterval, 50, (i + 0.5) / 500);
    EXPECT_NEAR(sum / 500, 0.95, 0.005);
}

// (1 - p_1)^m = 1 - p, and Bonferroni's p / m lies just below.
TEST(Sidak, ManyTestsShareOneRisk) {
    const double each = SidakLevel(0.05, 20);
    EXPECT_NEAR(1 - std::pow(1 - each, 20), 0.05, 1e-15);
    EXPECT_GT(each, 0.05 / 20);
    EXPECT_DOUBLE_EQ(SidakLevel(0.05, 1), 0.05);
    // For tiny levels the first order p / m holds to p relative.
    EXPECT_NEAR(SidakLevel(1e-12, 1'000'000) / 1e-18, 1, 1e-11);
}

}  // namespace
}  // namespace plumb
