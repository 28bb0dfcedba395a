// A 95 % interval holds the truth in 93 to 97 % of pictures whose errors are correlated.
#include <gtest/gtest.h>

#include <cmath>

#include "score/errors.h"
#include "score/temporal.h"
#include "tests/score/made_images.h"

namespace plumb {
namespace {

constexpr int kSize = 96, kRuns = 3000;  // A share of 95 % is known to +- 0.4 % (1 sigma).
constexpr double kMean = 0.02, kSigma = 0.05;

bool Holds(const Measured& figure, double expected) {
    return figure.interval.low <= expected && expected <= figure.interval.high;
}

// Errors are kMean + kSigma times noise that is correlated over 4 pixels, in tiles of 6; so
// the population's bias, MSE, and MAE (of a normal with that mean: sigma sqrt(2/pi) exp(-m^2 /
// 2 sigma^2) + m erf(m / (sigma sqrt 2))) are known. A quarter of the picture is masked. The
// truth is noisy, which the MSE must not show.
TEST(Coverage, OfBiasMaeAndMse) {
    const double mse = kMean * kMean + kSigma * kSigma, t = kMean / kSigma;
    const double mae = kSigma * std::sqrt(2 / std::numbers::pi) * std::exp(-t * t / 2) +
                       kMean * std::erf(t / std::numbers::sqrt2);
    Mask mask(kSize, kSize, 1);
    for (int j = 0; j < kSize / 2; ++j)
        for (int i = 0; i < kSize / 2; ++i) mask(i, j) = 0;
    const Image<float> truth(kSize, kSize, 0.5f), s(kSize, kSize, 0.02f);

    int bias_held = 0, mae_held = 0, mse_held = 0, rmse_held = 0, psnr_held = 0;
    for (int run = 0; run < kRuns; ++run) {
        const Image<float> noise = CorrelatedNoise(kSize, kSize, 4, 7, run);
        const auto candidate = MadeImage<float>(
            kSize, kSize, [&](int i, int j) { return 0.5 + kMean + kSigma * noise(i, j); });
        const auto noisy = MadeImage<float>(kSize, kSize, [&](int i, int j) {
            return 0.5 + 0.02 * MadeNormal(8, std::uint64_t(j) * kSize + i, run);
        });
        const ErrorScore score = ScoreErrors(candidate, noisy, s, mask);
        bias_held += Holds(score.bias, kMean);
        mse_held += Holds(score.mse, mse);
        rmse_held += Holds(score.rmse, std::sqrt(mse));
        psnr_held += Holds(score.psnr_db, PsnrDb(mse));
        mae_held += Holds(ScoreErrors(candidate, truth, {}, mask).mae, mae);
    }
    for (const int held : {bias_held, mae_held, mse_held}) {
        EXPECT_GT(held / double(kRuns), 0.93);
        EXPECT_LT(held / double(kRuns), 0.97);
    }
    EXPECT_EQ(rmse_held, mse_held);
    EXPECT_EQ(psnr_held, mse_held);
}

// A mask that leaves two rows of tiles, 32 of 256, and errors alike over 6 pixels, a whole tile:
// few tiles, much in common. The interval may be too long here, not too short: 95 to 98 %.
TEST(Coverage, OfAStrip) {
    Mask strip(kSize, kSize, 0);
    for (int j = 0; j < 12; ++j)
        for (int i = 0; i < kSize; ++i) strip(i, j) = 1;
    const Image<float> truth(kSize, kSize, 0.0f);
    int held = 0;
    constexpr int kStrips = 1000;
    for (int run = 0; run < kStrips; ++run) {
        const auto noise = CorrelatedNoise(kSize, kSize, 6, 12, run);
        held += Holds(ScoreErrors(noise, truth, {}, strip).bias, 0);
    }
    EXPECT_GT(held, 0.94 * kStrips);
    EXPECT_LT(held, 0.99 * kStrips);
}

// Expected: tiles of a pixel see but its neighbours, and give a far too short interval where
// errors are alike over 9 pixels, so that the test above has something to tell. Of the
// variance of a mean they see, in each dimension, the correlations 1 + 2 8/9 of their sum 9,
// in both 9.5 %; so 95 % becomes 2 Phi(1.96 sqrt(0.095)) - 1 = 45 %.
TEST(Coverage, OfTilesOfOnePixelFails) {
    int held = 0;
    for (int run = 0; run < 300; ++run) {
        const auto noise = CorrelatedNoise(kSize, kSize, 9, 9, run);
        held += Holds(
            ScoreErrors(noise, Image<float>(kSize, kSize, 0.0f), {}, {}, {.tile_px = 1}).bias,
            0);
    }
    EXPECT_LT(held / 300.0, 0.6);
}

// Frames of white noise of variance 1/100 over a still truth: candidate and flicker both vary
// by that; the truth, measured with an error of 1/20, does not vary.
TEST(Coverage, OfTemporalVariance) {
    constexpr int kFrames = 4, kSide = 32, kTemporalRuns = 1000;
    const std::vector<Image<float>> s(kFrames, Image<float>(kSide, kSide, 0.05f));
    int flicker_held = 0, truth_held = 0;
    for (int run = 0; run < kTemporalRuns; ++run) {
        std::vector<Image<float>> candidates, truths;
        for (int frame = 0; frame < kFrames; ++frame) {
            const auto pixels = [&](std::uint64_t seed, double sigma) {
                return MadeImage<float>(kSide, kSide, [&](int i, int j) {
                    return 0.01 * i + sigma * MadeNormal(seed, std::uint64_t(j) * kSide + i,
                                                         std::uint64_t(run) * kFrames + frame);
                });
            };
            candidates.push_back(pixels(10, 0.1));
            truths.push_back(pixels(11, 0.05));
        }
        const TemporalScore score = ScoreTemporal(candidates, truths, s);
        flicker_held += Holds(score.flicker, 0.01);
        truth_held += Holds(score.truth, 0);
    }
    for (const int held : {flicker_held, truth_held}) {
        EXPECT_GT(held / double(kTemporalRuns), 0.93);
        EXPECT_LT(held / double(kTemporalRuns), 0.97);
    }
}

}  // namespace
}  // namespace plumb
