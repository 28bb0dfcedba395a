#include "score/errors.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/parallel.h"
#include "tests/score/made_images.h"

namespace plumb {
namespace {

Image<float> Of(std::initializer_list<float> pixels, int width = 2) {
    Image<float> image(width, int(pixels.size()) / width);
    std::copy(pixels.begin(), pixels.end(), image.Pixels().begin());
    return image;
}

// d = 1/4, -1/4, 1/2, 0: all numbers of the tests below are exact in float.
const Image<float> kCandidate = Of({0.5f, 0.25f, 1, 0});
const Image<float> kTruth = Of({0.25f, 0.5f, 0.5f, 0});
const ErrorOptions kPixelTiles{.tile_px = 1};

TEST(ScoreErrors, TwoByTwoByHand) {
    const ErrorScore score = ScoreErrors(kCandidate, kTruth, {}, {}, kPixelTiles);
    EXPECT_EQ(score.pixels, 4);
    EXPECT_EQ(score.tiles, 4);
    EXPECT_DOUBLE_EQ(score.bias.value, 0.125);   // (1/4 - 1/4 + 1/2 + 0) / 4
    EXPECT_DOUBLE_EQ(score.mae.value, 0.25);     // (1/4 + 1/4 + 1/2 + 0) / 4
    EXPECT_DOUBLE_EQ(score.mse.value, 0.09375);  // (1/16 + 1/16 + 1/4 + 0) / 4
    EXPECT_DOUBLE_EQ(score.rmse.value, std::sqrt(0.09375));
    EXPECT_NEAR(score.psnr_db.value, 10.280287, 1e-6);        // 10 log10(1 / 0.09375)
    EXPECT_NEAR(score.psnr_paper_db.value, 58.411091, 1e-6);  // + 20 log10(255) = 48.130804
    EXPECT_DOUBLE_EQ(score.max, 0.5);
    EXPECT_EQ(score.max_column, 0);
    EXPECT_EQ(score.max_row, 1);
    EXPECT_DOUBLE_EQ(score.max_at_least, 0.5);
    EXPECT_EQ(score.truth_variance, 0);
    EXPECT_EQ(score.mae_noise_bias, 0);
}

// Expected: with four tiles of one pixel the error of a mean is s / sqrt n. About 1/8 the
// squares of d sum to 2 (1/8)^2 + 2 (3/8)^2 = 5/16, so se = sqrt(5/16 / 3 / 4); t_3 at 97.5 %
// is 3.182446 ([Abramowitz64] table 26.10 gives 3.182).
TEST(ScoreErrors, IntervalOfTheBiasByHand) {
    const Measured bias = ScoreErrors(kCandidate, kTruth, {}, {}, kPixelTiles).bias;
    const double se = std::sqrt(5.0 / 16 / 3 / 4);
    EXPECT_NEAR(bias.standard_error, se, 1e-15);
    EXPECT_NEAR(bias.interval.high, 0.125 + 3.182446 * se, 1e-6);
    EXPECT_NEAR(bias.interval.low, 0.125 - 3.182446 * se, 1e-6);
}

TEST(ScoreErrors, TakesOffTheNoiseOfTheTruthByHand) {
    const Image<float> s = Of({0.25f, 0, 0.125f, 0});
    ErrorOptions options = kPixelTiles;
    options.truth_dof = std::numeric_limits<double>::infinity();
    const ErrorScore score = ScoreErrors(kCandidate, kTruth, s, {}, options);
    // mean s^2 = (1/16 + 1/64) / 4
    EXPECT_DOUBLE_EQ(score.truth_variance, 0.01953125);
    EXPECT_DOUBLE_EQ(score.mse.value, 0.09375 - 0.01953125);
    EXPECT_DOUBLE_EQ(score.bias.noise_error, std::sqrt(1.0 / 16 + 1.0 / 64) / 4);
    // v = 4 d^2 s^2 - 2 s^4: 4/16/16 - 2/256 = 1/128, and 4/4/64 - 2/4096 = 1/64 - 1/2048
    EXPECT_DOUBLE_EQ(score.mse.noise_error, std::sqrt(1.0 / 128 + 1.0 / 64 - 1.0 / 2048) / 4);
    // 2/sqrt(pi) s exp(-d^2 / 2 s^2), of d = s = 1/4 and of d = 1/2 = 4 s, over 4 pixels
    EXPECT_NEAR(score.mae_noise_bias,
                1.1283791671 / 4 * (0.25 * std::exp(-0.5) + 0.125 * std::exp(-8.0)), 1e-10);
}

TEST(ScoreErrors, CountsTheMaskAlone) {
    Mask mask(2, 2, 1);
    mask(0, 1) = 0;  // The greatest error.
    Image<float> candidate = kCandidate;
    candidate(0, 1) = std::numeric_limits<float>::quiet_NaN();  // Nobody asks for it.
    const ErrorScore score = ScoreErrors(candidate, kTruth, {}, mask, kPixelTiles);
    EXPECT_EQ(score.pixels, 3);
    EXPECT_DOUBLE_EQ(score.bias.value, 0);
    EXPECT_DOUBLE_EQ(score.mse.value, 1.0 / 24);  // 2/16 / 3
    EXPECT_DOUBLE_EQ(score.max, 0.25);
}

TEST(ScoreErrors, OfAPictureAgainstItselfIsZero) {
    const auto image = MadeImage<float>(37, 23, [](int i, int j) { return 0.01 * i * j; });
    const ErrorScore score = ScoreErrors(image, image);
    for (const Measured* figure : {&score.bias, &score.mae, &score.mse, &score.rmse}) {
        EXPECT_EQ(figure->value, 0);
        EXPECT_EQ(figure->standard_error, 0);
        EXPECT_EQ(figure->interval.low, 0);
        EXPECT_EQ(figure->interval.high, 0);
    }
    EXPECT_EQ(score.psnr_db.value, std::numeric_limits<double>::infinity());
    EXPECT_EQ(score.max, 0);
}

TEST(ScoreErrors, BiasChangesSignWithTheRoles) {
    const ErrorScore one = ScoreErrors(kCandidate, kTruth),
                     other = ScoreErrors(kTruth, kCandidate);
    EXPECT_EQ(one.bias.value, -other.bias.value);
    EXPECT_EQ(one.mse.value, other.mse.value);
    EXPECT_EQ(one.mae.value, other.mae.value);
}

// Expected: [Hollander13], whose tables print 91.14, 93.24 and 92.34 dB (cut off, not rounded)
// for these mean squared errors of data in [0, 1].
TEST(Psnr, TheTableOfThePaper) {
    struct Row {
        double mse, db, paper_db;
    };
    for (const Row& row : {Row{5.0e-5, 43.0103, 91.1411}, Row{3.08e-5, 45.1145, 93.2453},
                           Row{3.79e-5, 44.2136, 92.3444}}) {
        EXPECT_NEAR(PsnrDb(row.mse), row.db, 5e-5);
        EXPECT_NEAR(PsnrDb(row.mse, kPaperPeak), row.paper_db, 5e-5);
    }
    EXPECT_EQ(PsnrDb(0), std::numeric_limits<double>::infinity());
}

// (a - b)(a + b - 2 t) = d_a^2 - d_b^2, pixel by pixel.
TEST(CompareMse, IsTheDifferenceOfTheTwo) {
    const Image<float> other = Of({0.25f, 0.375f, 0.75f, 0.5f});
    const Measured difference = CompareMse(kCandidate, other, kTruth, {}, {}, kPixelTiles);
    EXPECT_DOUBLE_EQ(difference.value, ScoreErrors(kCandidate, kTruth).mse.value -
                                           ScoreErrors(other, kTruth).mse.value);
    EXPECT_EQ(CompareMse(other, other, kTruth).value, 0);
}

TEST(ScoreErrors, SameBitsOnOneThreadAndTwo) {
    const auto candidate = CorrelatedNoise(150, 90, 3, 1, 0),
               truth = CorrelatedNoise(150, 90, 3, 1, 1);
    const auto run = [&](int threads) {
        SetThreadCount(threads);
        const ErrorScore score = ScoreErrors(candidate, truth);
        SetThreadCount(0);
        return std::vector<double>{score.bias.value, score.mse.value, score.mse.standard_error,
                                   score.mae.interval.low, score.max};
    };
    EXPECT_EQ(run(1), run(2));
}

TEST(ScoreErrors, NothingCountedIsNoError) {
    const ErrorScore score = ScoreErrors(kCandidate, kTruth, {}, Mask(2, 2, 0));
    EXPECT_EQ(score.pixels, 0);
    EXPECT_TRUE(std::isnan(score.mse.value));
}

template <class Call>
std::string MessageOf(const Call& call) {
    try {
        call();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(ScoreErrors, NamesWhatIsWrong) {
    Image<float> broken = kCandidate;
    broken(1, 0) = std::numeric_limits<float>::infinity();
    EXPECT_EQ(MessageOf([&] { ScoreErrors(broken, kTruth); }),
              "candidate[1, 0] = inf, must be finite");
    EXPECT_EQ(MessageOf([&] { ScoreErrors(Image<float>(3, 2), kTruth); }),
              "candidate: width = 3, must be that of the truth, 2");
    EXPECT_EQ(MessageOf([&] { ScoreErrors(kCandidate, kTruth, Image<float>(2, 1)); }),
              "standard error: height = 1, must be that of the truth, 2");
    EXPECT_EQ(MessageOf([&] { ScoreErrors({}, {}); }), "truth: pixels = 0, must be >= 1");
    EXPECT_EQ(MessageOf([&] { ScoreErrors(kCandidate, kTruth, {}, {}, {.confidence = 1}); }),
              "ErrorOptions::confidence = 1, must be in (0, 1)");
    EXPECT_EQ(MessageOf([&] { ScoreErrors(kCandidate, kTruth, {}, {}, {.tile_px = -1}); }),
              "ErrorOptions::tile_px = -1, must be in [0, 65536]");
    EXPECT_EQ(MessageOf([&] { ScoreErrors(kCandidate, kTruth, {}, {}, {.truth_dof = 0}); }),
              "ErrorOptions::truth_dof = 0, must be > 0");
}

TEST(Tiling, CoversThePictureOnce) {
    const Tiling tiling(50, 30, 16);
    EXPECT_EQ(tiling.Columns(), 4);
    EXPECT_EQ(tiling.Rows(), 2);
    EXPECT_EQ(tiling.TileOf(0, 0), 0);
    EXPECT_EQ(tiling.TileOf(49, 29), 7);
    EXPECT_EQ(tiling.TileOf(16, 15), 1);
    EXPECT_EQ(Tiling(960, 540).tile_px, 45);  // sqrt(960 540 / 256) = 45
    EXPECT_EQ(Tiling(1, 1).Count(), 1);
}

}  // namespace
}  // namespace plumb
