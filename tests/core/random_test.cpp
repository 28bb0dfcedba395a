#include "core/random.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <set>

#include "tests/core/significance.h"

namespace plumb {
namespace {

constexpr int kSamples = 1 << 16;

// The counters that a renderer counts through, one at a time, the rest held: neighbours must
// look as independent as strangers.
std::uint64_t ByCounter(int counter, std::uint64_t i) {
    switch (counter) {
        case 0:
            return RandomBits(i, 0, 0, 0);
        case 1:
            return RandomBits(7, i, 0, 0);
        case 2:
            return RandomBits(7, 5, i, 0);
        default:
            return RandomBits(7, 5, 3, i);
    }
}

class Random : public testing::TestWithParam<int> {};

TEST_P(Random, IsUniformAlongEachCounter) {
    std::vector<int> cells(256), low_cells(256);
    for (int i = 0; i < kSamples; ++i) {
        const std::uint64_t bits = ByCounter(GetParam(), std::uint64_t(i));
        ++cells[std::size_t(UnitFromBits(bits) * 256)];
        ++low_cells[bits % 256];
    }
    EXPECT_GT(ChiSquarePValue(cells, kSamples / 256.), kLevel);
    EXPECT_GT(ChiSquarePValue(low_cells, kSamples / 256.), kLevel);
}

TEST_P(Random, NeighboursAreUniformInTheSquare) {
    for (std::uint64_t lag : {1, 2, 256}) {
        std::vector<int> cells(32 * 32);
        for (std::uint64_t i = 0; i < kSamples; ++i) {
            const double u = UnitFromBits(ByCounter(GetParam(), i));
            const double v = UnitFromBits(ByCounter(GetParam(), i + lag));
            ++cells[std::size_t(u * 32) * 32 + std::size_t(v * 32)];
        }
        EXPECT_GT(ChiSquarePValue(cells, kSamples / 1024.), kLevel) << "lag " << lag;
    }
}

// Expected: for independent uniforms the correlation of n pairs is normal with standard error
// 1 / sqrt(n).
TEST_P(Random, NeighboursDoNotCorrelate) {
    for (std::uint64_t lag : {1, 2, 3, 1024}) {
        double sum = 0;
        for (std::uint64_t i = 0; i < kSamples; ++i) {
            sum += (UnitFromBits(ByCounter(GetParam(), i)) - 0.5) *
                   (UnitFromBits(ByCounter(GetParam(), i + lag)) - 0.5);
        }
        EXPECT_LT(std::abs(12 * sum / kSamples), kSigmas / std::sqrt(double(kSamples)));
    }
}

// Expected: a bit of the counter flips each of the 64 output bits with probability 1/2, so the
// flips of m trials are binomial (64 m, 1/2) with standard deviation sqrt(64 m) / 2.
TEST_P(Random, EachCounterBitFlipsHalfOfTheOutput) {
    const int m = 4096;
    for (int bit : {0, 1, 7, 31, 63}) {
        double flips = 0;
        for (std::uint64_t i = 0; i < m; ++i) {
            flips += std::popcount(ByCounter(GetParam(), i) ^
                                   ByCounter(GetParam(), i ^ (std::uint64_t{1} << bit)));
        }
        EXPECT_LT(std::abs(flips - 32. * m), kSigmas * std::sqrt(64. * m) / 2) << "bit " << bit;
    }
}

INSTANTIATE_TEST_SUITE_P(Counters, Random, testing::Range(0, 4));

TEST(RandomBits, CountersAreNotInterchangeable) {
    std::set<std::uint64_t> seen;
    for (int i = 0; i < 4; ++i) {
        seen.insert(RandomBits(i == 0, i == 1, i == 2, i == 3));
    }
    EXPECT_EQ(seen.size(), 4u);
}

// By construction: each word is absorbed by a bijection.
TEST(RandomBits, NeverCollideAlongOneCounter) {
    std::set<std::uint64_t> seen;
    for (std::uint64_t i = 0; i < 20'000; ++i) seen.insert(RandomBits(1, 2, i, 4));
    EXPECT_EQ(seen.size(), 20'000u);
}

TEST(UnitFromBits, IsInTheHalfOpenInterval) {
    EXPECT_EQ(UnitFromBits(0), 0);
    EXPECT_EQ(UnitFromBits(~std::uint64_t{0}), 1 - 0x1p-53);
}

}  // namespace
}  // namespace plumb
