#include "score/recalibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/statistics.h"
#include "tests/score/made_images.h"

namespace plumb {
namespace {

constexpr int kSide = 60;

/// A smooth picture of values in [0.1, 0.9], none of which is often met twice.
const auto kTrue = MadeImage<float>(kSide, kSide, [](int i, int j) {
    return 0.5 + 0.4 * std::sin(0.11 * i + 0.05 * j) * std::cos(0.07 * j - 0.013 * i);
});

template <class Curve>
Image<float> Through(const Image<float>& image, const Curve& curve) {
    return MadeImage<float>(image.Width(), image.Height(),
                            [&](int i, int j) { return curve(image(i, j)); });
}

// Expected: a wrong contrast is mended whole. Tolerance: in sample, the rounding of float;
// held out, a straight line between data some 1/300 apart of a curve whose second derivative
// is at most 2 / 0.2^3 (of sqrt(x) undone: x^2, derivative 2), far below 1e-3.
TEST(Recalibration, MendsAnyCurve) {
    const Image<float> candidate = Through(kTrue, [](double x) { return x * x; });
    EXPECT_GT(ScoreErrors(candidate, kTrue).rmse.value, 0.15);
    const RecalibrationScore score = ScoreRecalibrated(candidate, kTrue);
    EXPECT_LT(score.fitted.rmse.value, 1e-6);
    EXPECT_LT(score.held_out.rmse.value, 1e-3);
    EXPECT_EQ(score.held_out.pixels, kSide * kSide);
    EXPECT_NEAR(score.map(0.25), 0.5, 1e-3);
}

// Values of either sign, many of them alike, 0 and -0 among them: the map is the plain fit's.
TEST(Recalibration, OrdersValuesOfEitherSign) {
    std::vector<MonotoneSample> samples;
    Image<float> candidate(kSide, kSide), truth(kSide, kSide);
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            candidate(i, j) = float((i * 7 + j * 13) % 41 - 20) / 8 * (j % 2 ? 1 : -1);
            truth(i, j) = 0.3f * candidate(i, j) + 0.01f * float((i * j) % 17);
            samples.push_back({candidate(i, j), truth(i, j)});
        }
    }
    const MonotoneMap expected = FitMonotone(samples);
    const MonotoneMap map = ScoreRecalibrated(candidate, truth).map;
    ASSERT_EQ(map.levels.size(), expected.levels.size());
    ASSERT_GT(map.levels.size(), 10u);
    for (std::size_t k = 0; k < map.levels.size(); ++k) {
        EXPECT_EQ(map.levels[k].first_x, expected.levels[k].first_x);
        EXPECT_NEAR(map.levels[k].y, expected.levels[k].y, 1e-14);  // Sums in another order.
    }
}

// A picture upside down in value: the best rising f is the constant mean, RMSE* the standard
// deviation of the truth.
TEST(Recalibration, DoesNotTurnAround) {
    const Image<float> candidate = Through(kTrue, [](double x) { return 1 - x; });
    Moments truth;
    for (float pixel : kTrue.Pixels()) truth.Add(pixel);
    const double n = kSide * kSide;
    const RecalibrationScore score = ScoreRecalibrated(candidate, kTrue);
    EXPECT_NEAR(score.fitted.rmse.value, std::sqrt(truth.Variance() * (n - 1) / n), 1e-6);
    EXPECT_EQ(score.map.levels.size(), 1u);
}

// Expected: a candidate that is the truth through a curve, plus an error of its own of
// standard deviation 0.05 that no curve mends, of a truth measured with noise 0.03. In the
// truth's terms no more than 0.05 is left (the slope of the curve is 1), and not much less:
// the fit pulls towards the mean by the share 0.05^2 / variance, some 5 %. The fitted score
// lies below the held-out one. Noise must leave no trace: kSigmas of noise_error.
TEST(Recalibration, LeavesTheWrongShapeAndNoNoise) {
    const auto candidate = MadeImage<float>(kSide, kSide, [](int i, int j) {
        return kTrue(i, j) + 0.1 + 0.05 * MadeNormal(1, std::uint64_t(j) * kSide + i, 0);
    });
    const auto noisy = MadeImage<float>(kSide, kSide, [](int i, int j) {
        return kTrue(i, j) + 0.03 * MadeNormal(2, std::uint64_t(j) * kSide + i, 0);
    });
    const Image<float> s(kSide, kSide, 0.03f);
    const RecalibrationScore clean = ScoreRecalibrated(candidate, kTrue);
    const RecalibrationScore score =
        ScoreRecalibrated(candidate, noisy, s, {}, {.truth_dof = 1e9});
    EXPECT_LT(clean.fitted.rmse.value, 0.05);
    EXPECT_GT(clean.fitted.rmse.value, 0.04);
    EXPECT_LT(clean.fitted.mse.value, clean.held_out.mse.value);
    EXPECT_LT(score.fitted.mse.value, score.held_out.mse.value);
    const double tolerance = kSigmas * score.held_out.mse.noise_error;
    EXPECT_GT(score.held_out.mse.value, clean.fitted.mse.value - tolerance);
    EXPECT_NEAR(score.held_out.mse.value, clean.held_out.mse.value, tolerance);
    EXPECT_GT(ScoreRecalibrated(candidate, noisy).held_out.mse.value,
              clean.held_out.mse.value + 3 * tolerance);  // The noise was there.
}

// Of pure noise a fit makes something; what is held out shows that it is nothing.
TEST(Recalibration, HeldOutIsNotFooled) {
    const auto candidate = CorrelatedNoise(kSide, kSide, 1, 3, 0);
    const auto truth = CorrelatedNoise(kSide, kSide, 1, 3, 1);
    const RecalibrationScore score = ScoreRecalibrated(candidate, truth);
    Moments moments;
    for (float pixel : truth.Pixels()) moments.Add(pixel);
    EXPECT_LT(score.fitted.mse.value, moments.Variance());
    EXPECT_GT(score.held_out.mse.value, moments.Variance());
}

TEST(Recalibration, NeedsFiveTilesToHoldOut) {
    const RecalibrationScore score =
        ScoreRecalibrated(kTrue, kTrue, {}, {}, {.tile_px = kSide});
    EXPECT_EQ(score.fitted.pixels, kSide * kSide);
    EXPECT_EQ(score.held_out.pixels, 0);
    EXPECT_EQ(ScoreRecalibrated(kTrue, kTrue, {}, Mask(kSide, kSide, 0)).fitted.pixels, 0);
}

}  // namespace
}  // namespace plumb
