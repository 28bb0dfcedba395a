#include "fit/bootstrap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "core/statistics.h"
#include "fit/model_fit.h"
#include "fit/models/escape_probability.h"
#include "made_maps.h"

namespace plumb {
namespace {

std::vector<BounceHistogram> MapsWithFactors(const std::vector<double>& factors) {
    std::vector<BounceHistogram> maps;
    for (double a : factors)
        maps.push_back(
            MakeMap("map " + std::to_string(maps.size()), {.g = {.a = a, .b = 0.5}}));
    return maps;
}

// Expected: for maps that differ in one constant only, the fit is nearly the mean of theirs,
// and the bootstrap's standard error of a mean of M values is sqrt(M - 1) / M times their
// standard deviation. Tolerance: 400 replicates scatter by 1 / sqrt(800) = 3.5 % of it, 4 of
// those, and 3 % for the curvature of E in a over a spread of 5 %.
TEST(Bootstrap, StandardErrorOfAMean) {
    const std::vector<double> factors{0.80, 0.82, 0.85, 0.88, 0.90, 0.81, 0.86, 0.84};
    const auto maps = MapsWithFactors(factors);
    const BootstrapResult result = BootstrapOverMaps(ModelOf<EscapeOfV>(), TotalSamples(maps),
                                                     {.replicates = 400}, {.starts = 1});
    Moments moments;
    for (double a : factors) moments.Add(a);
    const double M = double(factors.size());
    const double expected = std::sqrt(moments.Variance() * (M - 1)) / M;
    EXPECT_EQ(result.replicates, 400);
    EXPECT_EQ(result.failed, 0);
    EXPECT_EQ(result.parameters[0].name, "a");
    EXPECT_NEAR(result.parameters[0].standard_error / expected, 1, 4 / std::sqrt(800.0) + 0.03);
    EXPECT_LT(result.parameters[0].low, moments.Mean());
    EXPECT_GT(result.parameters[0].high, moments.Mean());
    // A normal 95 % interval is 3.92 standard errors wide. Each percentile of 400 replicates
    // scatters by sqrt(0.025 * 0.975 / 400) / 0.0584 = 0.13 standard errors (0.0584: the normal
    // density there), so the width by 4.8 %; 4 of those, and 6 % for eight discrete maps.
    EXPECT_NEAR((result.parameters[0].high - result.parameters[0].low) / (3.92 * expected), 1,
                0.25);
}

// Expected: maps that agree leave nothing to vary but the end of the descent.
TEST(Bootstrap, AlikeMapsGiveNoSpread) {
    const auto maps = MapsWithFactors({0.9, 0.9, 0.9});
    const BootstrapResult result = BootstrapOverMaps(ModelOf<EscapeOfV>(), TotalSamples(maps),
                                                     {.replicates = 20}, {.starts = 1});
    EXPECT_LT(result.parameters[0].standard_error, 1e-7);
}

TEST(Bootstrap, IsAFunctionOfItsSeedOnAnyNumberOfThreads) {
    const auto maps = MapsWithFactors({0.8, 0.85, 0.9, 0.95});
    const auto run = [&](std::uint64_t seed, int threads) {
        SetThreadCount(threads);
        const auto result = BootstrapOverMaps(ModelOf<EscapeOfV>(), TotalSamples(maps),
                                              {.replicates = 30, .seed = seed}, {.starts = 1});
        SetThreadCount(0);
        return result.parameters[0].standard_error;
    };
    EXPECT_EQ(run(1, 1), run(1, 4));
    EXPECT_NE(run(1, 1), run(2, 1));
}

// Expected: of two maps one is flat; a replicate of it alone, 1 in 4, has nothing to fit.
// Tolerance: 4 standard deviations of a binomial count of 64.
TEST(Bootstrap, CountsReplicatesWithNothingToFit) {
    auto maps = MapsWithFactors({0.9, 0.9});
    for (BounceBin& bin : maps[1].bins) {
        bin.alpha = bin.V = 1;
        for (Spread& E : bin.total) E.mean = 1;
    }
    const BootstrapResult result = BootstrapOverMaps(ModelOf<EscapeOfV>(), TotalSamples(maps),
                                                     {.replicates = 64}, {.starts = 1});
    EXPECT_NEAR(result.failed, 16, 4 * std::sqrt(64 * 0.25 * 0.75));
    EXPECT_EQ(result.replicates + result.failed, 64);
}

TEST(Bootstrap, ValidatesItsInput) {
    const auto samples = TotalSamples(MapsWithFactors({0.9, 0.8}));
    const Model& model = ModelOf<EscapeOfV>();
    EXPECT_THROW(BootstrapOverMaps(model, samples, {.replicates = 1}), Error);
    EXPECT_THROW(BootstrapOverMaps(model, samples, {.confidence = 1}), Error);
    EXPECT_THROW(BootstrapOverMaps(model, TotalSamples(MapsWithFactors({0.9}))), Error);
}

}  // namespace
}  // namespace plumb
