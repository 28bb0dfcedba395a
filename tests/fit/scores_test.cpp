#include "fit/scores.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fit/mayaux_faults.h"
#include "fit/mayaux_refit.h"
#include "fit/models/plain_visibility.h"
#include "fit/residuals.h"
#include "made_maps.h"

namespace plumb {
namespace {

Sample At(double V, double y, double weight) {
    return {.at = {UniformVisibility(V), CosineVisibility(V), Albedo(0.5)},
            .y = y,
            .weight = weight};
}

const Formula kPlainV = AtInitialValues(ModelOf<PlainVModel>(), "plain V");

// Expected: differences 0.3 and -0.1 with weights 1 and 3: sqrt((0.09 + 0.03) / 4) =
// sqrt(0.03).
TEST(Score, ByHand) {
    const Score score = ScoreOf(kPlainV, std::vector{At(0.5, 0.2, 1), At(0.5, 0.6, 3)});
    EXPECT_NEAR(score.rms, std::sqrt(0.03), 1e-15);
    EXPECT_NEAR(score.max_abs, 0.3, 1e-15);
    EXPECT_EQ(score.samples, 2);
    EXPECT_EQ(score.poles, 0);
    EXPECT_EQ(score.out_of_range, 0);
}

TEST(Score, ASampleWithoutWeightHasNoSay) {
    const Score score = ScoreOf(kPlainV, std::vector{At(0.5, 0.5, 1), At(0.5, 0.9, 0)});
    EXPECT_EQ(score.max_abs, 0);
    EXPECT_EQ(score.samples, 1);
}

// Expected: open ground is 0 / 0 in the formula as printed; just above F0 = 1's root it
// predicts a total above 1.
TEST(Score, CountsPolesAndLightFromNowhereApart) {
    const Formula printed = MayauxFormula(kMayaux18, PoleGuard::kNone, "printed");
    const Score score =
        ScoreOf(printed, std::vector{At(1, 1, 1), At(0.999, 1, 1), At(0.5, 0.8, 1)});
    EXPECT_EQ(score.samples, 3);
    EXPECT_EQ(score.poles, 1);
    EXPECT_EQ(score.out_of_range, 1);
    EXPECT_TRUE(std::isfinite(score.rms));
}

// Expected: sqrt((0.3^2 + 0.1^2) / 2) whatever the number of samples.
TEST(Score, PoolsMapsWithTheSameSay) {
    const Score pooled =
        Pooled(std::vector<Score>{{.rms = 0.3, .max_abs = 0.4, .samples = 1000},
                                  {.rms = 0.1, .max_abs = 0.5, .samples = 10}});
    EXPECT_NEAR(pooled.rms, std::sqrt(0.05), 1e-15);
    EXPECT_EQ(pooled.max_abs, 0.5);
    EXPECT_EQ(pooled.samples, 1010);
}

// Expected: the formula that made the map has no error on it; plain V, weighed by hand, has the
// error E - V of each bin by its facets.
TEST(Score, OnAMap) {
    const BounceHistogram map = MakeMap("made");
    const Formula truth{.name = "truth", .model = ModelOf<EscapeOfV>(), .values = {0.95, 0.5}};
    EXPECT_LT(ScoreOf(truth, map).rms, 1e-15);
    double sum_n = 0, sum = 0;
    for (const BounceBin& bin : map.bins)
        for (const Spread& E : bin.total) {
            sum_n += double(bin.count);
            sum += double(bin.count) * (E.mean - bin.V) * (E.mean - bin.V);
        }
    const std::vector maps{map, map};
    const ScoreRow row = ScoreOver(kPlainV, maps);
    EXPECT_EQ(row.formula, "plain V");
    ASSERT_EQ(row.maps.size(), 2);
    EXPECT_NEAR(row.maps[1].rms, std::sqrt(sum / sum_n), 1e-14);
    EXPECT_NEAR(row.pooled.rms, std::sqrt(sum / sum_n), 1e-14);
}

TEST(Residuals, ArePredictedMinusMeasured) {
    const std::vector<Residual> residuals = Residuals(kPlainV, std::vector{At(0.5, 0.2, 1)});
    ASSERT_EQ(residuals.size(), 1);
    EXPECT_EQ(residuals[0].predicted, 0.5);
    EXPECT_NEAR(residuals[0].difference, 0.3, 1e-16);
    EXPECT_EQ(residuals[0].sample.y, 0.2);
}

}  // namespace
}  // namespace plumb
