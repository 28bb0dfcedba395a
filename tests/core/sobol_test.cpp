#include "core/sobol.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <set>
#include <span>

#include "core/statistics.h"
#include "tests/core/significance.h"

namespace plumb {
namespace {

// Counts of the points of an aligned block of 2^k in the boxes 2^-a_0 x 2^-a_1 x ...: the
// coordinates' leading bits, strung together, number the box.
std::vector<int> CountInBoxes(std::uint32_t block, int k,
                              std::span<const std::uint32_t> dimensions,
                              std::span<const int> bits, std::uint64_t seed) {
    std::vector<int> boxes(std::size_t{1} << std::accumulate(bits.begin(), bits.end(), 0));
    for (std::uint32_t i = block << k; i < (block + 1) << k; ++i) {
        std::size_t box = 0;
        for (std::size_t d = 0; d < dimensions.size(); ++d) {
            const double u = SobolOwen(i, dimensions[d], seed);
            box = (box << bits[d]) + std::size_t(std::ldexp(u, bits[d]));
        }
        ++boxes[box];
    }
    return boxes;
}

// The definition of a (0, k, 2)-net in base 2, for every aligned block and every shape of box.
// That dimensions 0 and 1 are one: [Sobol67].
TEST(Sobol, EveryBlockOfTheFirstPairHasOnePointInEveryElementaryInterval) {
    for (std::uint32_t first : {0u, kSobolDimensions, 3 * kSobolDimensions}) {
        for (int k = 0; k <= 10; ++k) {
            for (std::uint32_t block : {0u, 1u, 6u}) {
                for (int a = 0; a <= k; ++a) {
                    const std::vector<int> boxes = CountInBoxes(
                        block, k, std::array{first, first + 1}, std::array{a, k - a}, 7);
                    ASSERT_EQ(boxes, std::vector<int>(boxes.size(), 1))
                        << "first " << first << " k " << k << " block " << block << " a " << a;
                }
            }
        }
    }
}

TEST(Sobol, EveryBlockOfEveryDimensionHasOnePointInEveryInterval) {
    for (std::uint32_t dimension = 0; dimension < 2 * kSobolDimensions; ++dimension) {
        for (int k : {1, 5, 9}) {
            const std::vector<int> boxes =
                CountInBoxes(3, k, std::array{dimension}, std::array{k}, 7);
            ASSERT_EQ(boxes, std::vector<int>(boxes.size(), 1)) << "dimension " << dimension;
        }
    }
}

// Expected: dimensions of polynomials of degree s_i form a (t, s)-sequence with
// t = Sum (s_i - 1) ([Sobol67]; dimension 0 counts 0): every box of volume 2^(t-k) has exactly
// 2^t of the 2^k points.
TEST(Sobol, DimensionsTogetherAreAsEvenAsTheirPolynomialsAllow) {
    const std::uint32_t sets[][4] = {{0, 1, 2, 3}, {0, 1, 2, 4}, {1, 2, 3, 4}};
    for (const auto& set : sets) {
        int t = 0;
        for (std::uint32_t d : set) t += d == 0 ? 0 : kSobolRows[d - 1].s - 1;
        const int k = 9, free = k - t;
        for (int a = 0; a <= free; ++a) {
            for (int b = 0; a + b <= free; ++b) {
                for (int c = 0; a + b + c <= free; ++c) {
                    const std::vector<int> boxes =
                        CountInBoxes(2, k, set, std::array{a, b, c, free - a - b - c}, 11);
                    ASSERT_EQ(boxes, std::vector<int>(boxes.size(), 1 << t))
                        << set[3] << ": " << a << " " << b << " " << c;
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

// Unscrambled, dimensions 0 to 2 of points 0 to 7. By hand: dimension 1 has m = 1, 3, 5
// (x + 1: m_k = 2 m_{k-1} ^ m_{k-1}), dimension 2 has m = 1, 3, 3 (x^2 + x + 1: m_3 = 2 m_2 ^
// 4 m_1 ^ m_1 = 6 ^ 4 ^ 1), so the directions are 1/2, 3/4, 5/8 and 1/2, 3/4, 3/8.
TEST(Sobol, FirstPointsByHand) {
    const double expected[3][8] = {{0, 1. / 2, 1. / 4, 3. / 4, 1. / 8, 5. / 8, 3. / 8, 7. / 8},
                                   {0, 1. / 2, 3. / 4, 1. / 4, 5. / 8, 1. / 8, 3. / 8, 7. / 8},
                                   {0, 1. / 2, 3. / 4, 1. / 4, 3. / 8, 7. / 8, 5. / 8, 1. / 8}};
    for (std::uint32_t d = 0; d < 3; ++d) {
        for (std::uint32_t i = 0; i < 8; ++i) {
            EXPECT_EQ(ReverseBits(SobolReversed(i, d)) * 0x1p-32, expected[d][i]) << d << i;
        }
    }
}

/// x^exponent modulo a polynomial of degree s over GF(2).
std::uint32_t PowerOfX(std::uint32_t exponent, std::uint32_t polynomial, int s) {
    std::uint32_t power = 1;
    for (std::uint32_t i = 0; i < exponent; ++i) {
        power <<= 1;
        if ((power >> s) & 1) power ^= polynomial;
    }
    return power;
}

// A slip in the table would break one of its rules: m_k odd and below 2^k, all polynomials
// different and primitive, that is x has the order 2^s - 1 and no smaller one.
TEST(SobolRows, KeepTheRulesOfTheTable) {
    std::set<std::uint32_t> polynomials;
    for (const SobolRow& row : kSobolRows) {
        for (int k = 0; k < row.s; ++k) {
            EXPECT_EQ(row.m[std::size_t(k)] % 2, 1u);
            EXPECT_LT(row.m[std::size_t(k)], 2u << k);
        }
        const std::uint32_t polynomial = (1u << row.s) | (row.a << 1) | 1;
        EXPECT_TRUE(polynomials.insert(polynomial).second);
        const std::uint32_t order = (1u << row.s) - 1;
        for (std::uint32_t e = 1; e <= order; ++e) {
            EXPECT_EQ(PowerOfX(e, polynomial, row.s) == 1, e == order) << polynomial;
        }
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

// Within one net too: padded dimensions must not be copies or mirrors of the first ones.
TEST(Sobol, DifferentBlocksAreIndependentWithinANet) {
    const int n = 1 << 16;
    for (std::uint32_t other : {64u, 65u, 127u}) {
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

/// Variance of the mean over n points of f = 1 where (u + v < 1) == (w + x < 1), over that of
/// n random points, 1 / (4 n); (u, v) the first pair and (w, x) another. Neither pair alone
/// says anything of f: only evenness of the two together helps.
double InteractionVariance(std::uint32_t other_pair) {
    const int n = 1024, replicates = 400;
    Moments moments;
    for (std::uint64_t seed = 0; seed < replicates; ++seed) {
        int equal = 0;
        for (std::uint32_t i = 0; i < n; ++i) {
            equal += (SobolOwenPair(i, 0, seed).sum() < 1) ==
                     (SobolOwenPair(i, other_pair, seed).sum() < 1);
        }
        moments.Add(equal / double(n));
    }
    EXPECT_NEAR(moments.Mean(), 0.5, kSigmas * moments.StandardError());
    return moments.Variance() * 4 * n;
}

// Why real dimensions and not padded pairs: real ones halve the variance of random points at
// least (measured 0.19 and 0.27), padded ones have no reason to (measured 1.3). Each figure has
// the relative standard error sqrt(2 / 399) = 0.07.
TEST(Sobol, TwoRealPairsTogetherBeatRandomPoints) {
    EXPECT_LT(InteractionVariance(1), 0.5);
    EXPECT_LT(InteractionVariance(2), 0.5);
    EXPECT_GT(InteractionVariance(kSobolDimensions / 2), 0.5);
}

// Expected: in one dimension an Owen-scrambled block of n points has one independent uniform
// point in each of n cells ([Owen97], Monte Carlo Variance of Scrambled Net Quadrature), so the
// mean of f(u) = u has the variance 1 / (12 n^3).
// Tolerance: the variance of m normal values has the relative standard error sqrt(2 / (m-1)).
TEST(Sobol, VarianceOfALinearFunctionIsThatOfOneUniformPointPerCell) {
    const int replicates = 4000;
    for (std::uint32_t n : {4u, 16u, 64u, 256u}) {
        for (std::uint32_t dimension : {0u, 1u, 6u, 70u}) {
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
        covered += std::abs(means.Mean() - truth) <= means.HalfWidth(0.95);
    }
    const Interval rate = ClopperPearsonInterval(covered, runs, 1 - kLevel);
    EXPECT_LE(rate.low, 0.95);
    EXPECT_GE(rate.high, 0.95);
}

// Definition: the two ways to a coordinate are one.
TEST(Sobol, DigitsMayBeMadeOnceForManyNets) {
    for (std::uint32_t index : {0u, 1u, 77u, 0xfffffffeu}) {
        for (std::uint32_t dimension : {0u, 1u, 63u}) {
            EXPECT_EQ(ScrambleReversed(SobolReversed(index, dimension),
                                       SobolOwenKey(dimension, 1234567)),
                      SobolOwen(index, dimension, 1234567));
        }
    }
}

}  // namespace
}  // namespace plumb
