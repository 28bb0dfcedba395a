#include "score/ssim.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/statistics.h"
#include "tests/score/made_images.h"

namespace plumb {
namespace {

constexpr double C1 = 1e-4, C2 = 9e-4;  // (0.01)^2, (0.03)^2

TEST(Ssim, OfAPictureWithItselfIsOne) {
    const auto image = CorrelatedNoise(20, 15, 2, 1, 0);
    const Image<float> map = SsimMap(image, image);
    int whole = 0;
    for (int j = 5; j < 10; ++j)
        for (int i = 5; i < 15; ++i) whole += map(i, j) == 1;
    EXPECT_EQ(whole, 50);
    EXPECT_TRUE(std::isnan(map(4, 7)));
    EXPECT_TRUE(std::isnan(map(7, 10)));
    EXPECT_EQ(ScoreSsim(map).value, 1);
}

// Two constants: no variance, so only the first factor is left. Tolerance: float pixels.
TEST(Ssim, OfTwoConstantsByHand) {
    const Image<float> map = SsimMap(Image<float>(11, 11, 0.5f), Image<float>(11, 11, 0.75f));
    EXPECT_NEAR(map(5, 5), (2 * 0.375 + C1) / (0.25 + 0.5625 + C1), 1e-7);
    EXPECT_NEAR(map(5, 5), 0.923086, 1e-6);
}

// Expected: the window of a single bright pixel in the middle of the truth, and of one beside
// it in the candidate. With the middle's weight w and the neighbour's v,
//   mu_t = w, sigma_t^2 = w - w^2, mu_c = v, sigma_c^2 = v - v^2, sigma_ct = -w v.
// The weights: g(k) = exp(-k^2 / 4.5) over their sum over -5 ... 5, here summed by hand:
//   1 + 2 (0.8007374 + 0.4111123 + 0.1353353 + 0.0285655 + 0.0038659) = 3.7592328
// w = 1 / 3.7592328^2 = 0.0707622, v = 0.8007374 w = 0.0566620.
TEST(Ssim, OfOneBrightPixelByHand) {
    Image<float> truth(11, 11, 0.0f), candidate(11, 11, 0.0f);
    truth(5, 5) = 1;
    candidate(6, 5) = 1;
    const double w = 0.0707622, v = 0.0566620;
    const double expected = (2 * w * v + C1) * (-2 * w * v + C2) /
                            ((w * w + v * v + C1) * (w - w * w + v - v * v + C2));
    EXPECT_NEAR(SsimMap(candidate, truth)(5, 5), expected, 1e-6);
    EXPECT_LT(expected, 0);
}

TEST(Ssim, IsSymmetric) {
    const auto a = CorrelatedNoise(16, 16, 2, 2, 0), b = CorrelatedNoise(16, 16, 2, 2, 1);
    const Image<float> one = SsimMap(a, b), other = SsimMap(b, a);
    for (int j = 5; j < 11; ++j)
        for (int i = 5; i < 11; ++i) EXPECT_FLOAT_EQ(one(i, j), other(i, j));
}

// What is not seen changes nothing, whatever it holds.
TEST(Ssim, LeavesOutWhatIsNotSeen) {
    auto a = CorrelatedNoise(16, 11, 2, 3, 0), b = CorrelatedNoise(16, 11, 2, 3, 1);
    Mask seen(16, 11, 1);
    for (int j = 0; j < 11; ++j) seen(9, j) = 0;
    const Image<float> before = SsimMap(a, b, {}, seen);
    for (int j = 0; j < 11; ++j) a(9, j) = b(9, j) = std::numeric_limits<float>::quiet_NaN();
    const Image<float> after = SsimMap(a, b, {}, seen);
    EXPECT_EQ(before(6, 5), after(6, 5));
    EXPECT_TRUE(std::isnan(after(9, 5)));
    EXPECT_FALSE(std::isnan(after(6, 5)));
    EXPECT_NE(after(6, 5), SsimMap(CorrelatedNoise(16, 11, 2, 3, 0),
                                   CorrelatedNoise(16, 11, 2, 3, 1))(6, 5));
}

// Expected: on average the score of the noiseless truth. Tolerance: what is left is of second
// order, here below 2 % of what the noise did; and kSigmas standard errors of the mean over
// 60.
TEST(Ssim, TakesOffTheNoiseOfTheTruth) {
    constexpr int kSide = 64;
    const auto truth = MadeImage<float>(kSide, kSide, [](int i, int j) {
        return 0.5 + 0.2 * std::sin(0.4 * i) * std::cos(0.3 * j);
    });
    const auto candidate = MadeImage<float>(kSide, kSide, [](int i, int j) {
        return 0.45 + 0.15 * std::sin(0.4 * i + 0.2) * std::cos(0.3 * j);
    });
    const double expected = ScoreSsim(SsimMap(candidate, truth)).value;
    const Image<float> s(kSide, kSide, 0.04f);
    Moments corrected, raw;
    for (int run = 0; run < 60; ++run) {
        const auto noisy = MadeImage<float>(kSide, kSide, [&](int i, int j) {
            return truth(i, j) + 0.04 * MadeNormal(4, std::uint64_t(j) * kSide + i, run);
        });
        corrected.Add(ScoreSsim(SsimMap(candidate, noisy, s)).value);
        raw.Add(ScoreSsim(SsimMap(candidate, noisy)).value);
    }
    const double done = expected - raw.Mean();
    EXPECT_GT(done, 0.02);
    EXPECT_NEAR(corrected.Mean(), expected, 0.02 * done + kSigmas * corrected.StandardError());
}

TEST(Ssim, HasNoWindowInASmallPicture) {
    const Image<float> map = SsimMap(Image<float>(10, 40, 0.5f), Image<float>(10, 40, 0.5f));
    EXPECT_TRUE(std::isnan(ScoreSsim(map).value));
    EXPECT_THROW(SsimMap(Image<float>(10, 40), Image<float>(11, 40)), Error);
}

}  // namespace
}  // namespace plumb
