// The z pyramid: the five filters of the paper's table 1 by hand, and sizes that are not even.
#include "screen_space/sao/z_pyramid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.h"

namespace plumb {
namespace {

constexpr float kSkyZ = -std::numeric_limits<float>::infinity();

// z = -(1 + 4y + x) of 4 x 4 texels.
Image<float> Ramp(int width = 4, int height = 4) {
    Image<float> z(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) z(x, y) = -float(1 + width * y + x);
    }
    return z;
}

std::vector<float> LevelOne(const Image<float>& z, ZFilter filter) {
    const ZPyramid pyramid(z, filter, 1);
    std::vector<float> level;
    for (int y = 0; y < pyramid.At(1).height; ++y) {
        for (int x = 0; x < pyramid.At(1).width; ++x) level.push_back(pyramid(1, x, y));
    }
    return level;
}

// Of z = 4y + x the sources are {5, 3; 12, 10} with "^ 1" and {0, 6; 9, 15} without.
TEST(ZPyramid, RotatedGrids) {
    EXPECT_EQ(LevelOne(Ramp(), ZFilter::kRotatedGrid), (std::vector<float>{-6, -4, -13, -11}));
    EXPECT_EQ(LevelOne(Ramp(), ZFilter::kRotatedGridG3d10),
              (std::vector<float>{-1, -7, -10, -16}));
}

// The first quad is {1, 2; 5, 6}.
TEST(ZPyramid, MeansAndExtremesByHand) {
    EXPECT_EQ(LevelOne(Ramp(), ZFilter::kMean), (std::vector<float>{-3.5, -5.5, -11.5, -13.5}));
    EXPECT_EQ(LevelOne(Ramp(), ZFilter::kMin), (std::vector<float>{-6, -8, -14, -16}));
    EXPECT_EQ(LevelOne(Ramp(), ZFilter::kMax), (std::vector<float>{-1, -3, -9, -11}));
    const double harmonic = -4 / (1 + 1 / 2.0 + 1 / 5.0 + 1 / 6.0);
    EXPECT_NEAR(LevelOne(Ramp(), ZFilter::kHarmonicMean)[0], harmonic, 4 * 6e-8 * 2.2);
}

// Table 1 as printed would give z / 16.
TEST(ZPyramid, EveryFilterKeepsAConstant) {
    for (const ZFilter filter :
         {ZFilter::kRotatedGrid, ZFilter::kRotatedGridG3d10, ZFilter::kMean,
          ZFilter::kHarmonicMean, ZFilter::kMin, ZFilter::kMax}) {
        const ZPyramid pyramid(Image<float>(37, 23, -8.0f), filter, 7);
        for (int level = 0; level <= 7; ++level) {
            const ZPyramid::Level& l = pyramid.At(level);
            for (int y = 0; y < l.height; ++y) {
                for (int x = 0; x < l.width; ++x) ASSERT_EQ(pyramid(level, x, y), -8);
            }
        }
    }
}

TEST(ZPyramid, EveryPixelHasItsTexelInEveryLevel) {
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {37, 23}, {1024, 3}}) {
        const ZPyramid pyramid(Ramp(width, height), ZFilter::kRotatedGrid, 6);
        for (int level = 0; level <= 6; ++level) {
            EXPECT_GT(pyramid.At(level).width, (width - 1) >> level);
            EXPECT_GT(pyramid.At(level).height, (height - 1) >> level);
            const std::int32_t last = pyramid.At(level).offset + pyramid.At(level).width - 1;
            EXPECT_EQ(last / pyramid.Pitch(), pyramid.At(level).offset / pyramid.Pitch())
                << "a level's row runs over the end of the pitch";
        }
        EXPECT_EQ(pyramid.At(6).width, std::max(1, (width + 63) / 64));
    }
}

// 3 x 3: the last column has one source column. Values -(1 + 3y + x).
TEST(ZPyramid, BorderTexelsStandInForWhatIsBeyond) {
    EXPECT_EQ(LevelOne(Ramp(3, 3), ZFilter::kMean),
              (std::vector<float>{-3, (-3 - 3 - 6 - 6) / 4.0f, (-7 - 8 - 7 - 8) / 4.0f, -9}));
    EXPECT_EQ(LevelOne(Ramp(3, 3), ZFilter::kRotatedGrid),
              (std::vector<float>{-5, -3, -7, -9}));
    EXPECT_EQ(LevelOne(Ramp(1, 1), ZFilter::kMin), (std::vector<float>{-1}));
}

// Level m of the rotated grid holds only depths that were drawn, of the texel's own square.
TEST(ZPyramid, RotatedGridTakesDepthsOfItsOwnSquare) {
    const int size = 64;
    const ZPyramid pyramid(Ramp(size, size), ZFilter::kRotatedGrid, 5);
    for (int level = 0; level <= 5; ++level) {
        for (int y = 0; y < pyramid.At(level).height; ++y) {
            for (int x = 0; x < pyramid.At(level).width; ++x) {
                const int source = int(-pyramid(level, x, y)) - 1;
                ASSERT_EQ(source % size >> level, x);
                ASSERT_EQ(source / size >> level, y);
            }
        }
    }
}

TEST(ZPyramid, SkyIsNoNumberToAverage) {
    Image<float> z(2, 2, -2.0f);
    z(1, 1) = kSkyZ;
    EXPECT_EQ(LevelOne(z, ZFilter::kMean)[0], kSkyZ);
    EXPECT_EQ(LevelOne(z, ZFilter::kMin)[0], kSkyZ);
    EXPECT_EQ(LevelOne(z, ZFilter::kMax)[0], -2);
    EXPECT_FLOAT_EQ(LevelOne(z, ZFilter::kHarmonicMean)[0], -4 / 1.5f);
    const Image<float> sky(2, 2, kSkyZ);
    EXPECT_EQ(LevelOne(sky, ZFilter::kHarmonicMean)[0], kSkyZ);
}

TEST(ZPyramid, BadDepthsAreNamed) {
    for (const auto& [z, digits] : {std::pair{std::numeric_limits<float>::quiet_NaN(), "nan"},
                                    {0.0f, "0"},
                                    {2.5f, "2.5"},
                                    {std::numeric_limits<float>::infinity(), "inf"}}) {
        Image<float> depth(5, 4, -1.0f);
        depth(3, 2) = z;
        try {
            const ZPyramid pyramid(depth, ZFilter::kMean, 2);
            FAIL() << digits;
        } catch (const Error& error) {
            EXPECT_EQ(error.what(), "GBuffer::z_m(3, 2) = " + std::string(digits) +
                                        ", must be in [-1e18, -1e-18] or the sky's -inf");
        }
    }
}

}  // namespace
}  // namespace plumb
