// Bins against an example worked by hand.
#include "formfactor/histogram.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/formfactor/fields.h"

namespace plumb {
namespace {

constexpr BinnedBy kByAlpha = BinnedBy::kUniformVisibility;
constexpr BinnedBy kByV = BinnedBy::kCosineVisibility;

// Seven facets in four bins by alpha: [0, .25) two, [.25, .5) none, [.5, .75) three, [.75, 1]
// two, one of them at 1.
const std::vector<double> kAlpha = {0.625, 0.125, 1.0, 0.5, 0.1875, 0.75, 0.6875};
const std::vector<double> kV = {0.5, 0.25, 1.0, 0.375, 0.125, 0.625, 0.75};
const std::vector<double> kE = {0.1, 0.4, 0.0, 0.2, 0.8, 0.5, 0.6};

// 1e-15: roundings of numbers below 1.
constexpr double kRounding = 1e-15;

HistogramBuilder ByHand() {
    HistogramBuilder builder("seven", kByAlpha, 4, kAlpha, kV);
    builder.AddBounce(kE);
    return builder;
}

TEST(Histogram, CountsFacetsAndKeepsTheirTrueMeanAbscissa) {
    const HistogramBuilder builder = ByHand();
    const BounceHistogram& h = builder.Result();
    EXPECT_EQ(h.surface, "seven");
    EXPECT_EQ(h.binned_by, kByAlpha);
    ASSERT_EQ(h.bins.size(), 4u);
    const std::int64_t counts[] = {2, 0, 3, 2};
    const double alpha[] = {0.15625, 0, (0.625 + 0.5 + 0.6875) / 3, 0.875};
    const double V[] = {0.1875, 0, (0.5 + 0.375 + 0.75) / 3, 0.8125};
    for (std::size_t b = 0; b < 4; ++b) {
        EXPECT_EQ(h.bins[b].low, 0.25 * double(b));
        EXPECT_EQ(h.bins[b].high, 0.25 * double(b + 1));
        EXPECT_EQ(h.bins[b].count, counts[b]);
        EXPECT_NEAR(h.bins[b].alpha, alpha[b], kRounding);
        EXPECT_NEAR(h.bins[b].V, V[b], kRounding);
    }
}

// Bin [.5, .75) holds E = .1, .2, .6: mean .3, variance (.04 + .01 + .09) / 2 = .07; definition
// 7 puts the 5th percentile at position .1 between .1 and .2, the 95th at 1.9 between .2 and
// .6. Bin [.75, 1] holds 0 and .5.
TEST(Histogram, GivesMeanVarianceAndPercentiles) {
    const HistogramBuilder builder = ByHand();
    const Spread& spread = builder.Result().bins[2].bounce[0];
    EXPECT_NEAR(spread.mean, 0.3, kRounding);
    EXPECT_NEAR(spread.variance, 0.07, kRounding);
    EXPECT_NEAR(spread.p05, 0.11, kRounding);
    EXPECT_NEAR(spread.p50, 0.2, kRounding);
    EXPECT_NEAR(spread.p95, 0.56, kRounding);
    const Spread& last = builder.Result().bins[3].bounce[0];
    EXPECT_NEAR(last.mean, 0.25, kRounding);
    EXPECT_NEAR(last.variance, 0.125, kRounding);
    EXPECT_NEAR(last.p05, 0.025, kRounding);
    EXPECT_NEAR(last.p50, 0.25, kRounding);
    EXPECT_NEAR(last.p95, 0.475, kRounding);
}

TEST(Histogram, EmptyBinsHoldZeros) {
    const HistogramBuilder builder = ByHand();
    const BounceBin& empty = builder.Result().bins[1];
    EXPECT_EQ(empty.count, 0);
    EXPECT_EQ(empty.alpha, 0);
    ASSERT_EQ(empty.bounce.size(), 1u);
    EXPECT_EQ(empty.bounce[0].mean, 0);
    EXPECT_EQ(empty.bounce[0].variance, 0);
    EXPECT_EQ(empty.bounce[0].p95, 0);
}

TEST(Histogram, CanBeCutByV) {
    const HistogramBuilder builder("seven", kByV, 4, kAlpha, kV);
    const std::int64_t counts[] = {1, 2, 2, 2};
    for (std::size_t b = 0; b < 4; ++b) {
        EXPECT_EQ(builder.Result().bins[b].count, counts[b]) << "bin " << b;
    }
    EXPECT_NEAR(builder.Result().bins[1].alpha, (0.125 + 0.5) / 2, kRounding);
}

// By both: the square (row alpha, column V) of a grid. At two bins a side, by hand: alpha below
// 1/2 holds (.125, .25) and (.1875, .125); above, V below 1/2 holds (.5, .375) alone.
TEST(Histogram, CanBeCutByBoth) {
    HistogramBuilder builder("seven", BinnedBy::kBothVisibilities, 2, kAlpha, kV);
    builder.AddBounce(kE);
    const BounceHistogram& h = builder.Result();
    ASSERT_EQ(h.bins.size(), 4u);
    const std::int64_t counts[] = {2, 0, 1, 4};
    for (std::size_t b = 0; b < 4; ++b) {
        EXPECT_EQ(h.bins[b].count, counts[b]) << "bin " << b;
        EXPECT_EQ(h.bins[b].low, b < 2 ? 0 : 0.5);
        EXPECT_EQ(h.bins[b].high, b < 2 ? 0.5 : 1);
    }
    EXPECT_EQ(h.bins[2].alpha, 0.5);
    EXPECT_EQ(h.bins[2].V, 0.375);
    EXPECT_NEAR(h.bins[3].V, (0.5 + 1 + 0.625 + 0.75) / 4, kRounding);
    // Single facets are left out: .08 of two, and .1, 0, .5, .6 about .3: .26 / 3 of four.
    EXPECT_NEAR(FloorOf(h, 0, false), std::sqrt((2 * 0.08 + 4 * 0.26 / 3) / 6), kRounding);
}

TEST(FloorOf, IsZeroWhereEveryFacetIsAlone) {
    HistogramBuilder builder("two", kByAlpha, 4, std::vector<double>{0.1, 0.9},
                             std::vector<double>{0.1, 0.9});
    builder.AddBounce(std::vector<double>{0.3, 0.7});
    EXPECT_EQ(FloorOf(builder.Result(), 0, false), 0);
}

// [low, high): a value on an edge belongs to the bin that it opens, although 0.29 * 100 is
// 28.999... in a double; 1 belongs to the last.
TEST(Histogram, PutsAValueOnAnEdgeIntoTheBinItOpens) {
    for (const int bins : {1, 3, 7, 10, 49, 100, 1000}) {
        std::vector<double> edges;
        for (int b = 0; b <= bins; ++b) edges.push_back(double(b) / bins);
        const HistogramBuilder builder("edges", kByAlpha, bins, edges, edges);
        for (int b = 0; b < bins; ++b) {
            const BounceBin& bin = builder.Result().bins[std::size_t(b)];
            EXPECT_EQ(bin.count, b == bins - 1 ? 2 : 1) << "bin " << b << " of " << bins;
        }
        // And the last number below an edge to the bin that ends there.
        std::vector<double> below;
        for (int b = 1; b <= bins; ++b) below.push_back(std::nextafter(double(b) / bins, 0.0));
        const HistogramBuilder ends("ends", kByAlpha, bins, below, below);
        for (int b = 0; b < bins; ++b) {
            EXPECT_EQ(ends.Result().bins[std::size_t(b)].count, 1)
                << "bin " << b << " of " << bins;
        }
    }
}

TEST(Histogram, NumbersBouncesAndTotalsInTheOrderOfTheirComing) {
    HistogramBuilder builder = ByHand();
    std::vector<double> next(kE);
    for (double& e : next) e /= 2;
    builder.AddBounce(next);
    builder.AddTotal(0.5, std::vector<float>{1, 1, 1, 0, 1, 1, 0.5F});
    builder.AddTotal(1.0, std::vector<float>(7, 1));
    const BounceHistogram& h = builder.Result();
    EXPECT_EQ(h.Bounces(), 1);
    EXPECT_EQ(h.albedos, (std::vector<double>{0.5, 1.0}));
    EXPECT_NEAR(h.bins[2].bounce[1].mean, 0.15, kRounding);
    EXPECT_NEAR(h.bins[2].total[0].mean, 0.5, kRounding);
    EXPECT_NEAR(h.bins[2].total[1].mean, 1, kRounding);
}

// Variances of E over the bins: (.4, .8): .08; .07; .125. So the floor is
// sqrt((2 .08 + 3 .07 + 2 .125) / 7). Totals: (1, 0, .5): .25, elsewhere none.
TEST(FloorOf, IsTheSpreadWithinBins) {
    HistogramBuilder builder = ByHand();
    builder.AddTotal(0.5, std::vector<float>{1, 1, 1, 0, 1, 1, 0.5F});
    EXPECT_NEAR(FloorOf(builder.Result(), 0, false), std::sqrt(0.62 / 7), kRounding);
    EXPECT_NEAR(FloorOf(builder.Result(), 0, true), std::sqrt(0.75 / 7), kRounding);
}

TEST(Histogram, RefusesWhatItCannotBin) {
    const std::vector<double> one = {0.5}, two = {0.5, 0.6}, none;
    const auto make = [](int bins, const std::vector<double>& alpha,
                         const std::vector<double>& V) {
        return MessageOf([&] { HistogramBuilder("x", kByAlpha, bins, alpha, V); });
    };
    EXPECT_EQ(make(0, one, one), "histogram: bins = 0, must be in [1, 100000]");
    EXPECT_EQ(make(100001, one, one), "histogram: bins = 100001, must be in [1, 100000]");
    const char* const lengths =
        "histogram: alpha and V must hold one value a facet, and at least one";
    EXPECT_EQ(make(4, none, none), lengths);
    EXPECT_EQ(make(4, one, two), lengths);
    EXPECT_EQ(make(4, one, one), "no error");
    EXPECT_EQ(
        MessageOf([&] { HistogramBuilder("x", BinnedBy::kBothVisibilities, 1001, one, one); }),
        "histogram: bins = 1001, must be in [1, 1000]");
}

}  // namespace
}  // namespace plumb
