#include "core/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/random.h"

namespace plumb {
namespace {

const double kInfinity = std::numeric_limits<double>::infinity();

Moments Of(const std::vector<double>& values) {
    Moments moments;
    for (double x : values) moments.Add(x);
    return moments;
}

// By hand: mean 5, deviations -3 -1 -1 -1 0 0 2 4, squares 9 1 1 1 0 0 4 16 = 32, over 7.
TEST(Moments, MeanAndVarianceOfEightNumbers) {
    const Moments moments = Of({2, 4, 4, 4, 5, 5, 7, 9});
    EXPECT_DOUBLE_EQ(moments.Mean(), 5);
    EXPECT_DOUBLE_EQ(moments.Variance(), 32. / 7);
    EXPECT_EQ(moments.Count(), 8);
}

// Expected: shifting by 1e9 leaves the variance 32/7. Sum(x^2) - n mean^2 in double would lose
// all of it (1e18 * 2^-53 = 111). Tolerance: the means carry 1e9 * 2^-53 = 1e-7 each.
TEST(Moments, VarianceSurvivesALargeMean) {
    const double far = 1e9;
    EXPECT_NEAR(
        Of({far + 2, far + 4, far + 4, far + 4, far + 5, far + 5, far + 7, far + 9}).Variance(),
        32. / 7, 1e-6);
}

TEST(Moments, MergingIsAddingInARow) {
    Moments whole, first, second;
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const double x = RandomUnit(1, i, 0, 0);
        whole.Add(x);
        (i < 300 ? first : second).Add(x);
    }
    first.Merge(second);
    EXPECT_EQ(first.Count(), 1000);
    // Tolerance: 1000 roundings of numbers of size 1, of random sign.
    EXPECT_NEAR(first.Mean(), whole.Mean(), 1e-14);
    EXPECT_NEAR(first.Variance(), whole.Variance(), 1e-14);
}

TEST(Moments, MergingWithNothingChangesNothing) {
    Moments moments = Of({1, 4}), empty;
    moments.Merge(empty);
    EXPECT_DOUBLE_EQ(moments.Variance(), 4.5);
    empty.Merge(moments);
    EXPECT_DOUBLE_EQ(empty.Mean(), 2.5);
    EXPECT_DOUBLE_EQ(empty.Variance(), 4.5);
    EXPECT_EQ(empty.Count(), 2);
}

TEST(Moments, TheStandardErrorIsThatOfTheMean) {
    EXPECT_DOUBLE_EQ(Of({2, 4, 4, 4, 5, 5, 7, 9}).StandardError(), std::sqrt(32. / 7 / 8));
}

TEST(Moments, OneSampleSaysNothingOfTheError) {
    EXPECT_EQ(Of({3}).StandardError(), kInfinity);
    EXPECT_EQ(Of({3}).HalfWidth(0.95), kInfinity);
    EXPECT_EQ(Moments().Variance(), 0);
}

// t of 0.975 with 7 degrees of freedom is 2.364624 (distributions_test.cpp).
TEST(Moments, TheHalfWidthIsStudentsFactorTimesTheStandardError) {
    EXPECT_NEAR(Of({2, 4, 4, 4, 5, 5, 7, 9}).HalfWidth(0.95), std::sqrt(32. / 7 / 8) * 2.364624,
                1e-6);
}

// Definition 7: position share * (n - 1) among the sorted values 1 2 4 8.
TEST(Percentile, InterpolatesBetweenNeighboursInOrder) {
    const std::vector<double> values{8, 1, 4, 2};
    EXPECT_EQ(Percentile(values, 0), 1);
    EXPECT_EQ(Percentile(values, 1), 8);
    EXPECT_EQ(Percentile(values, 0.5), 3);
    EXPECT_EQ(Percentile(values, 0.75), 5);  // position 2.25: 4 + (8 - 4) / 4
    EXPECT_EQ(Percentile({7}, 0.3), 7);
}

}  // namespace
}  // namespace plumb
