#include "fit/samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.h"

namespace plumb {
namespace {

/// Two bins of 1 and 3 facets, one empty bin between them, one albedo, two bounces.
BounceHistogram TwoBins() {
    BounceHistogram map;
    map.surface = "two bins";
    map.albedos = {0.5};
    map.bins.resize(3);
    map.bins[0] = {.low = 0,
                   .high = 0.25,
                   .count = 1,
                   .alpha = 0.125,
                   .V = 0.25,
                   .bounce = {{.mean = 0.25}, {.mean = 0.4, .variance = 0.03}},
                   .total = {{.mean = 0.45, .variance = 0.01}}};
    map.bins[2] = {.low = 0.5,
                   .high = 1,
                   .count = 3,
                   .alpha = 0.75,
                   .V = 0.875,
                   .bounce = {{.mean = 0.875}, {.mean = 0.1}},
                   .total = {{.mean = 0.925, .variance = 0.03}}};
    return map;
}

std::string MessageOf(const BounceHistogram& map, int k = -1) {
    try {
        k < 0 ? TotalSamples({&map, 1}) : BounceSamples({&map, 1}, k);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(Samples, TakeTheBinsOwnMeansAndSkipEmptyBins) {
    const std::vector maps{TwoBins(), TwoBins()};
    const std::vector<Sample> samples = TotalSamples(maps);
    ASSERT_EQ(samples.size(), 4);
    EXPECT_EQ(samples[1].at.alpha, UniformVisibility(0.75));
    EXPECT_EQ(samples[1].at.V, CosineVisibility(0.875));
    EXPECT_EQ(samples[1].at.rho, Albedo(0.5));
    EXPECT_EQ(samples[1].y, 0.925);
    EXPECT_EQ(samples[1].map, 0);
    EXPECT_EQ(samples[2].map, 1);
}

// Expected: n_bin / n_map = 1/4, 3/4; divided by s^2 + s_0^2 = 0.01 + 0.01 and 0.03 + 0.01.
TEST(Samples, WeightsByHand) {
    const std::vector maps{TwoBins()};
    const auto weights = [&](Weighting weighting) {
        const auto samples = TotalSamples(maps, {.weighting = weighting, .spread_floor = 0.1});
        return std::pair(samples[0].weight, samples[1].weight);
    };
    EXPECT_EQ(weights(Weighting::kUnweighted), std::pair(1.0, 1.0));
    EXPECT_EQ(weights(Weighting::kPopulation), std::pair(0.25, 0.75));
    const auto [first, second] = weights(Weighting::kPopulationOverVariance);
    EXPECT_NEAR(first, 0.25 / 0.02, 1e-13);
    EXPECT_NEAR(second, 0.75 / 0.04, 1e-13);
}

TEST(Samples, OfABounceHaveNoAlbedo) {
    const std::vector maps{TwoBins()};
    const std::vector<Sample> samples = BounceSamples(maps, 1);
    ASSERT_EQ(samples.size(), 2);
    EXPECT_EQ(samples[0].y, 0.4);
    EXPECT_TRUE(std::isnan(samples[0].at.rho.value));
}

TEST(Samples, RefuseHistogramsThatDoNotHoldTogether) {
    BounceHistogram map = TwoBins();
    map.bins[2].total[0].mean = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(MessageOf(map), "two bins: bins[2].total[0].mean = nan, must be finite");
    map = TwoBins();
    map.albedos.push_back(0.7);
    EXPECT_EQ(MessageOf(map), "two bins: bins[0].total.size() = 1, must be 2");
    EXPECT_EQ(MessageOf(TwoBins(), 2), "two bins: bins[0].bounce.size() = 2, must be > 2");
    map.bins.clear();
    EXPECT_EQ(MessageOf(map), "two bins: the histogram holds no facet, nothing to fit");
}

TEST(Samples, PairsKnowOneVisibilityOnly) {
    const std::vector<double> x{0.1, 0.2}, y{0.3, 0.4};
    const auto of_alpha = PairSamples(BinnedBy::kUniformVisibility, x, y);
    EXPECT_EQ(of_alpha[1].at.alpha, UniformVisibility(0.2));
    EXPECT_TRUE(std::isnan(of_alpha[1].at.V.value));
    const auto of_V = PairSamples(BinnedBy::kCosineVisibility, x, y);
    EXPECT_EQ(of_V[1].at.V, CosineVisibility(0.2));
    EXPECT_TRUE(std::isnan(of_V[1].at.alpha.value));
    EXPECT_THROW(PairSamples(BinnedBy::kCosineVisibility, x, std::vector{0.3}), Error);
    EXPECT_THROW(PairSamples(BinnedBy::kCosineVisibility, x, std::vector{0.3, double(NAN)}),
                 Error);
}

}  // namespace
}  // namespace plumb
