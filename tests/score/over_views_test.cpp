// Several views as one: known sums by hand, and coverage.
#include "score/over_views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/distributions.h"
#include "tests/score/made_images.h"

namespace plumb {
namespace {

Measured Of(double value, double noise = 0) {
    return {.value = value,
            .standard_error = 9,
            .interval = {value - 1, value + 1},
            .noise_error = noise};
}

// By hand: of 1, 2 and 6 the mean is 3, the variance (4 + 1 + 9) / 2 = 7, so se = sqrt(7/3); t of two
// degrees of freedom is 4.302653 ([Abramowitz64] table 26.10: 4.303).
TEST(OverViews, IsTheMeanWithStudentsInterval) {
    const std::vector<Measured> views{Of(1, 0.3), Of(2, 0.4), Of(6, 1.2)};
    const Measured mean = MeanOverViews(views);
    EXPECT_DOUBLE_EQ(mean.value, 3);
    EXPECT_NEAR(mean.standard_error, std::sqrt(7 / 3.0), 1e-12);
    EXPECT_NEAR(mean.interval.high, 3 + 4.302653 * std::sqrt(7 / 3.0), 1e-5);
    EXPECT_NEAR(mean.interval.low, 3 - 4.302653 * std::sqrt(7 / 3.0), 1e-5);
    EXPECT_NEAR(mean.noise_error, 1.3 / 3,
                1e-12);  // 0.3, 0.4 and 1.2: a box's diagonal of 1.3.

    const Measured square = MeanSquareOverViews(views);
    EXPECT_DOUBLE_EQ(square.value, 3);
    EXPECT_NEAR(square.interval.high, 3 * std::exp(4.302653 * std::sqrt(7 / 3.0) / 3), 1e-4);
    EXPECT_NEAR(square.interval.low * square.interval.high, 9, 1e-9);
}

TEST(OverViews, OfRootsIsTheRootOfTheMeanSquare) {
    const std::vector<Measured> roots{Of(3), Of(4), Of(0)};
    const std::vector<Measured> squares{Of(9), Of(16), Of(0)};
    const Measured root = RootMeanSquareOverViews(roots), square = MeanSquareOverViews(squares);
    EXPECT_DOUBLE_EQ(root.value, std::sqrt(25 / 3.0));
    EXPECT_DOUBLE_EQ(root.interval.low, std::sqrt(square.interval.low));
    EXPECT_DOUBLE_EQ(root.interval.high, std::sqrt(square.interval.high));
}

TEST(OverViews, OfOneViewIsThatView) {
    const std::vector<Measured> one{Of(0.25)};
    for (const Measured& f :
         {MeanOverViews(one), MeanSquareOverViews(one), RootMeanSquareOverViews(one)}) {
        EXPECT_EQ(f.value, 0.25);
        EXPECT_EQ(f.standard_error, 9);
        EXPECT_EQ(f.interval.low, -0.75);
    }
}

// Two views of constant errors of +0.1 and -0.3: bias -0.1, MAE 0.2, MSE (0.01 + 0.09) / 2.
TEST(OverViews, ScoresAreThoseOfTheirMeans) {
    const Image<float> truth(32, 32, 0.5f);
    const std::vector<ErrorScore> views{ScoreErrors(Image<float>(32, 32, 0.6f), truth),
                                        ScoreErrors(Image<float>(32, 32, 0.2f), truth)};
    const ErrorScore score = ScoreOverViews(views);
    EXPECT_EQ(score.pixels, 2048);
    EXPECT_NEAR(score.bias.value, -0.1, 1e-7);
    EXPECT_NEAR(score.bias.standard_error, 0.2, 1e-7);
    EXPECT_NEAR(score.mae.value, 0.2, 1e-7);
    EXPECT_NEAR(score.mse.value, 0.05, 1e-7);
    EXPECT_NEAR(score.rmse.value, std::sqrt(0.05), 1e-7);
    EXPECT_NEAR(score.psnr_db.value, 10 * std::log10(20), 1e-5);
    EXPECT_NEAR(score.psnr_paper_db.value - score.psnr_db.value, 48.1308, 1e-4);
    EXPECT_NEAR(score.max, 0.3, 1e-7);
    EXPECT_NEAR(score.psnr_db.interval.low, 10 * std::log10(1 / score.mse.interval.high), 1e-9);
}

// MSE of views as scenes have them: log-normal with a sigma of 0.4 (a factor of 1.5 each way), whose
// mean is exp(sigma^2 / 2). Of 4000 draws a share of 95 % is known to 0.35 % (1 sigma); the mean of
// three skewed numbers is itself skewed, which costs one or two per cent.
TEST(OverViews, CoversTheMeanOfAllViews) {
    for (const int n : {3, 6}) {
        int held = 0, plain_below_zero = 0;
        constexpr int kRuns = 4000;
        for (int run = 0; run < kRuns; ++run) {
            std::vector<Measured> views;
            for (int v = 0; v < n; ++v) {
                views.push_back(Of(std::exp(0.4 * MadeNormal(77, std::uint64_t(v), run))));
            }
            const Measured f = MeanSquareOverViews(views);
            const double expected = std::exp(0.08);
            held += f.interval.low <= expected && expected <= f.interval.high;
            plain_below_zero += MeanOverViews(views).interval.low < 0;
        }
        EXPECT_GT(held, 0.93 * kRuns) << n;
        EXPECT_LT(held, 0.98 * kRuns) << n;
        if (n == 3) {
            EXPECT_GT(plain_below_zero, kRuns / 20);
        }
    }
}

}  // namespace
}  // namespace plumb
