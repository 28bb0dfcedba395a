#include "score/other_tools.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace plumb {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Channels Row(std::initializer_list<float> values) {
    Image<float> image(int(values.size()), 1);
    std::copy(values.begin(), values.end(), image.Pixels().begin());
    return {image};
}

// idiff of OpenImageIO 2.4.7 itself, of two grey pictures of 8 bits: 128 against 129 gives RMS
// 0.00392157 and PSNR 48.1308; a step at column 32 against one at 33 of 64 gives mean 0.015625,
// RMS 0.125, PSNR 18.0618.
TEST(FiguresOfIdiff, AsThatProgramPrintsThem) {
    const IdiffFigures step = FiguresOfIdiff(Row({129 / 255.0F}), Row({128 / 255.0F}));
    EXPECT_NEAR(step.rms, 0.00392157, 5e-9);
    EXPECT_NEAR(step.psnr_db, 48.1308, 5e-5);
    Image<float> a(64, 64, 0.0F), b(64, 64, 0.0F);
    for (int j = 0; j < 64; ++j)
        for (int i = 32; i < 64; ++i) a(i, j) = b(i, j) = 1;
    for (int j = 0; j < 64; ++j) b(32, j) = 0;
    const IdiffFigures edge = FiguresOfIdiff(Channels{a}, Channels{b});
    EXPECT_DOUBLE_EQ(edge.mean, 0.015625);
    EXPECT_DOUBLE_EQ(edge.rms, 0.125);
    EXPECT_NEAR(edge.psnr_db, 18.0618, 5e-5);
    EXPECT_EQ(edge.max, 1);
}

// The peak is the brightest of both, not 1: 20 log10(4 / 1).
TEST(FiguresOfIdiff, PeakOfAHighRangeIsItsBrightest) {
    const IdiffFigures figures = FiguresOfIdiff(Row({4, 3}), Row({3, 2}));
    EXPECT_EQ(figures.peak, 4);
    EXPECT_NEAR(figures.psnr_db, 12.041200, 1e-6);
    EXPECT_EQ(FiguresOfIdiff(Row({4}), Row({4})).psnr_db, kInfinity);
}

TEST(FiguresOfIdiff, WhatIsNotFiniteMatchesItsLike) {
    EXPECT_EQ(FiguresOfIdiff(Row({kNan, kInfinity, 1}), Row({kNan, -kInfinity, 1})).rms, 0);
    EXPECT_TRUE(std::isnan(FiguresOfIdiff(Row({kNan, 1}), Row({1, 1})).rms));
    EXPECT_TRUE(std::isnan(FiguresOfIdiff(Row({kNan, 1}), Row({1, 1})).max));
    EXPECT_EQ(FiguresOfIdiff(Row({kInfinity, 1}), Row({1, 1})).max, kInfinity);
}

// d = 1/2, -1/4 about t = 1/4, 3/4.
TEST(FiguresOfPbrt, ByHand) {
    const PbrtFigures figures = FiguresOfPbrt(Row({0.75F, 0.5F}), Row({0.25F, 0.75F}));
    EXPECT_DOUBLE_EQ(figures.mae, 0.375);
    EXPECT_DOUBLE_EQ(figures.mse, 0.15625);
    EXPECT_NEAR(figures.mrse, (0.25 / (0.26 * 0.26) + 0.0625 / (0.76 * 0.76)) / 2, 1e-12);
    // An infinity is 0; a term that is not finite counts as 0, but is counted.
    EXPECT_EQ(FiguresOfPbrt(Row({kInfinity, 0}), Row({0.5F, 0})).mse, 0.125);
    EXPECT_EQ(FiguresOfPbrt(Row({kNan, 0}), Row({0.5F, 0})).mrse, 0);
}

// The candidate is below the line, and "mae" is the mean square.
TEST(FiguresOfFalcor, ByHand) {
    const FalcorFigures figures = FiguresOfFalcor(Row({0.75F, 0.5F}), Row({0.25F, 0.75F}));
    EXPECT_DOUBLE_EQ(figures.mse, 0.15625);
    EXPECT_DOUBLE_EQ(figures.mae, 0.15625);
    EXPECT_NEAR(figures.rmse, (0.25 / (0.5625 + 1e-3) + 0.0625 / (0.25 + 1e-3)) / 2, 1e-12);
    EXPECT_NEAR(figures.mape, 50 * (0.5 / 0.751 + 0.25 / 0.501), 1e-12);
}

}  // namespace
}  // namespace plumb
