#include "core/sobol.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "core/statistics.h"
#include "tests/core/significance.h"

namespace plumb {
namespace {

// The definition of a (0, k, 2)-net in base 2, for every aligned block and every shape of box.
TEST(Sobol, EveryBlockOfAPairHasOnePointInEveryElementaryInterval) {
    for (std::uint32_t pair : {0u, 1u, 5u, 31u}) {
        for (std::uint64_t seed : {0, 1, 99}) {
            for (int k = 0; k <= 10; ++k) {
                for (std::uint32_t block : {0u, 1u, 6u}) {
                    for (int a = 0; a <= k; ++a) {
                        std::vector<int> boxes(std::size_t{1} << k);
                        for (std::uint32_t i = block << k; i < (block + 1) << k; ++i) {
                            const Vec2 u = SobolOwenPair(i, pair, seed);
                            const auto column = std::size_t(std::ldexp(u.x(), a));
                            const auto row = std::size_t(std::ldexp(u.y(), k - a));
                            ++boxes[(column << (k - a)) + row];
                        }
                        ASSERT_EQ(boxes, std::vector<int>(boxes.size(), 1))
                            << "pair " << pair << " seed " << seed << " k " << k << " a " << a;
                    }
                }
            }
        }
    }
}

TEST(Sobol, HalfOfThePointsLieBelowOneHalf) {
    for (std::uint32_t dimension = 0; dimension < 64; ++dimension) {
        int below = 0;
        for (std::uint32_t i = 0; i < 64; ++i) below += SobolOwen(i, dimension, 3) < 0.5;
        EXPECT_EQ(below, 32) << "dimension " << dimension;
    }
}

TEST(Sobol, APairIsItsTwoDimensions) {
    for (std::uint32_t i : {0u, 1u, 77u, 0xffffffffu}) {
        const Vec2 u = SobolOwenPair(i, 4, 11);
        EXPECT_EQ(u.x(), SobolOwen(i, 8, 11));
        EXPECT_EQ(u.y(), SobolOwen(i, 9, 11));
    }
}

TEST(Sobol, AllPointsLieInTheHalfOpenSquare) {
    static_assert(0xffffffffu * 0x1p-32 < 1);
    EXPECT_EQ(ReverseBits(1), 0x80000000u);
    EXPECT_EQ(ReverseBits(0x12345678u), 0x1e6a2c48u);  // by hand, nibble by nibble
}

// Unscrambled, Sobol's second dimension of i = 0 ... 7 is 0, 1/2, 3/4, 1/4, 5/8, 1/8, 3/8, 7/8
// ([Sobol67]'s order; the direction numbers are 1/2, 3/4, 5/8).
TEST(Sobol, SecondDimensionHasThePublishedDirectionNumbers) {
    const double expected[] = {0, 1. / 2, 3. / 4, 1. / 4, 5. / 8, 1. / 8, 3. / 8, 7. / 8};
    for (std::uint32_t i = 0; i < 8; ++i) {
        EXPECT_EQ(ReverseBits(SobolSecondReversed(i)) * 0x1p-32, expected[i]) << i;
    }
}

// Over seeds each point is uniform: that is what makes a mean of any block unbiased.
TEST(Sobol, EachPointIsUniformOverSeeds) {
    const int seeds = 1 << 15;
    for (std::uint32_t index : {0u, 1u, 1000u}) {
        for (std::uint32_t pair : {0u, 3u}) {
            std::vector<int> cells(16 * 16);
            for (std::uint64_t seed = 0; seed < seeds; ++seed) {
                const Vec2 u = SobolOwenPair(index, pair, seed);
                ++cells[std::size_t(u.x() * 16) * 16 + std::size_t(u.y() * 16)];
            }
            EXPECT_GT(ChiSquarePValue(cells, seeds / 256.), kLevel);
        }
    }
}

TEST(Sobol, DifferentPairsAreIndependentOverSeeds) {
    const int seeds = 1 << 15;
    std::vector<int> cells(16 * 16);
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        const double u = SobolOwen(5, 0, seed), v = SobolOwen(5, 2, seed);
        ++cells[std::size_t(u * 16) * 16 + std::size_t(v * 16)];
    }
    EXPECT_GT(ChiSquarePValue(cells, seeds / 256.), kLevel);
}

// Within one net too: pairs must not be copies or mirrors of each other.
TEST(Sobol, DifferentPairsAreIndependentWithinANet) {
    const int n = 1 << 16;
    for (std::uint32_t other : {2u, 3u, 63u}) {
        std::vector<int> cells(16 * 16);
        for (std::uint32_t i = 0; i < n; ++i) {
            ++cells[std::size_t(SobolOwen(i, 0, 1) * 16) * 16 +
                    std::size_t(SobolOwen(i, other, 1) * 16)];
        }
        // Both marginals are exactly even, so there are 15 * 15 degrees of freedom.
        double chi2 = 0;
        for (int count : cells) chi2 += std::pow(count - n / 256., 2) / (n / 256.);
        EXPECT_GT(ChiSquareSurvival(chi2, 225), kLevel) << "dimension " << other;
    }
}

// Expected: an input bit flips each higher bit with probability 1/2 over inputs and keys, so
// the rate over n trials has standard error 1 / (2 sqrt(n)). Beside the noise of 496 rates
// (kSigmas) the hash itself may be off by 0.01: what its 4 lines can do.
TEST(NestedHash, FlipsEveryHigherBitHalfOfTheTime) {
    const int n = 1 << 14;
    for (int bit = 0; bit < 31; ++bit) {
        std::vector<int> flips(32);
        for (std::uint64_t i = 0; i < n; ++i) {
            const auto x = std::uint32_t(RandomBits(1, i, 0, 0));
            const std::uint64_t key = RandomBits(1, i, 1, 0);
            const std::uint32_t flipped = NestedHash(x, key) ^ NestedHash(x ^ (1u << bit), key);
            ASSERT_EQ(std::countr_zero(flipped), bit);  // nested: nothing below it changes
            for (int b = 0; b < 32; ++b) flips[std::size_t(b)] += (flipped >> b) & 1;
        }
        for (int b = bit + 1; b < 32; ++b) {
            EXPECT_NEAR(double(flips[std::size_t(b)]) / n, 0.5,
                        kSigmas / (2 * std::sqrt(double(n))) + 0.01)
                << bit << " to " << b;
        }
    }
}

// Expected: in one dimension an Owen-scrambled block of n points has one independent uniform
// point in each of n cells ([Owen97], Monte Carlo Variance of Scrambled Net Quadrature), so the
// mean of f(u) = u has the variance 1 / (12 n^3).
// Tolerance: the variance of m normal values has the relative standard error sqrt(2 / (m-1)).
TEST(Sobol, VarianceOfALinearFunctionIsThatOfOneUniformPointPerCell) {
    const int replicates = 4000;
    for (std::uint32_t n : {4u, 16u, 64u, 256u}) {
        for (std::uint32_t dimension : {0u, 1u, 6u}) {
            Moments moments;
            for (std::uint64_t seed = 0; seed < replicates; ++seed) {
                double sum = 0;
                for (std::uint32_t i = 0; i < n; ++i) sum += SobolOwen(i, dimension, seed);
                moments.Add(sum / n);
            }
            const double expected = 1 / (12 * std::pow(n, 3));
            EXPECT_NEAR(moments.Variance() / expected, 1,
                        kSigmas * std::sqrt(2. / (replicates - 1)))
                << "n " << n << " dimension " << dimension;
            EXPECT_NEAR(moments.Mean(), 0.5, kSigmas * std::sqrt(expected / replicates));
        }
    }
}

// The reason to have it: 8 replicates of 256 points with Student's t cover a known integral as
// often as they say. Expected: the covered count of m runs is binomial (m, 0.95). The integrand
// is a disk of radius 0.9 in the corner: Int = pi 0.81 / 4, with an edge, as visibility has.
TEST(Sobol, StudentIntervalsOverReplicatesCoverAsOftenAsTheySay) {
    const int runs = 2000, replicates = 8;
    const double truth = 3.14159265358979 * 0.81 / 4;
    std::int64_t covered = 0;
    for (int run = 0; run < runs; ++run) {
        Moments means;
        for (int r = 0; r < replicates; ++r) {
            int inside = 0;
            for (std::uint32_t i = 0; i < 256; ++i) {
                inside += SobolOwenPair(i, 0, std::uint64_t(run * replicates + r)).norm() < 0.9;
            }
            means.Add(inside / 256.);
        }
        const Estimate estimate = means.Estimate();
        covered += std::abs(estimate.mean - truth) <= HalfWidth(estimate, 0.95);
    }
    const Interval rate = ClopperPearsonInterval(covered, runs, 1 - kLevel);
    EXPECT_LE(rate.low, 0.95);
    EXPECT_GE(rate.high, 0.95);
}

}  // namespace
}  // namespace plumb
