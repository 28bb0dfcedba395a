// The taps of SAO: hash, spiral, radius, level and texel, against values of the shipped shaders
// that were worked out apart from this code.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

#include "core/conventions.h"
#include "core/error.h"
#include "screen_space/sao/rotation_hash.h"
#include "screen_space/sao/spiral_taps.h"
#include "screen_space/sao/tap_lookup.h"
#include "tests/screen_space/made_gbuffers.h"

namespace plumb {
namespace {

// By hand for the first three; the others with another language's integers.
TEST(RotationHash, AllReadings) {
    struct Row {
        int x, y;
        std::int64_t code, c_precedence, xor_first;
    };
    for (const Row& row :
         {Row{1, 1, 10, 21, 41}, Row{2, 3, 150, 3, 123}, Row{3, 2, 10, 100, 148},
          Row{100, 50, 47580, 51258, 52954}, Row{960, 540, 5161880, 5205148, 5213340},
          Row{1919, 1079, 20671970, 20649971, 20764591}}) {
        EXPECT_EQ(RotationHash(row.x, row.y, HashReading::kCode), row.code);
        EXPECT_EQ(RotationHash(row.x, row.y, HashReading::kCPrecedence), row.c_precedence);
        EXPECT_EQ(RotationHash(row.x, row.y, HashReading::kXorFirst), row.xor_first);
    }
}

TEST(RotationHash, FitsIn32BitsForEveryPixelThatAViewMayHave) {
    for (const HashReading reading :
         {HashReading::kCode, HashReading::kCPrecedence, HashReading::kXorFirst}) {
        std::int64_t most = 0;
        for (int x = 16383; x > 16000; --x) {
            for (int y = 16383; y > 16000; --y) {
                most = std::max(most, RotationHash(x, y, reading));
            }
        }
        EXPECT_LT(most, std::int64_t{1} << 32);
    }
}

// The expected angles carry six decimals.
TEST(TurnedAngle, ExactIsTheHashModuloAFullTurn) {
    struct Row {
        int x, y;
        double phi_rad;
    };
    for (const Row& row :
         {Row{0, 1, 3.716815}, Row{1, 0, 4.867259}, Row{2, 3, 5.486738}, Row{100, 50, 3.720854},
          Row{960, 540, 4.509110}, Row{1919, 1079, 1.312855}}) {
        const std::int64_t hash = RotationHash(row.x, row.y, HashReading::kCode);
        EXPECT_NEAR(TurnedAngle(0, hash, PhiArithmetic::kExact), row.phi_rad, 5.1e-7);
        EXPECT_NEAR(TurnedAngle(0.25, hash, PhiArithmetic::kExact), 0.25 + row.phi_rad, 5.1e-7);
    }
}

/// Angles that remain different of a spiral at a pixel, modulo a full turn.
std::size_t DistinctAngles(int samples, int turns, std::int64_t hash, PhiArithmetic phi) {
    std::set<long> distinct;
    for (int i = 0; i < samples; ++i) {
        const double spiral = SpiralTap(i, samples, turns, 6.28).angle_rad;
        distinct.insert(
            std::lround(1e4 * std::remainder(TurnedAngle(spiral, hash, phi), 2 * kPi)));
    }
    return distinct.size();
}

// 20671970 lies between 2^24 and 2^25, where neighbouring floats differ by 2.
TEST(TurnedAngle, Float32CollapsesTheSpiralAndReducingFirstDoesNot) {
    const std::int64_t hash = RotationHash(1919, 1079, HashReading::kCode);
    EXPECT_EQ(DistinctAngles(9, 2, hash, PhiArithmetic::kFloat32), 7u);
    EXPECT_EQ(DistinctAngles(9, 2, hash, PhiArithmetic::kReduced), 9u);
    EXPECT_EQ(DistinctAngles(9, 2, hash, PhiArithmetic::kExact), 9u);
    const double step = TurnedAngle(1, hash, PhiArithmetic::kFloat32) -
                        TurnedAngle(0, hash, PhiArithmetic::kFloat32);
    EXPECT_TRUE(step == 0 || step == 2) << step;
}

// Shares of a 1080p frame, worked out apart from this code: 47, 23 and 2 %, to the digits given.
TEST(TurnedAngle, Float32IsCoarseInMostOfAFrame) {
    const auto share = [](std::int64_t at_least) {
        std::int64_t pixels = 0;
        for (int y = 0; y < 1080; ++y) {
            for (int x = 0; x < 1920; ++x) {
                pixels += RotationHash(x, y, HashReading::kCode) >= at_least;
            }
        }
        return double(pixels) / (1920.0 * 1080);
    };
    EXPECT_NEAR(share(std::int64_t{1} << 22), 0.47, 0.005);  // steps of 1/2 rad and more
    EXPECT_NEAR(share(std::int64_t{1} << 23), 0.23, 0.005);  // 1 rad
    EXPECT_NEAR(share(std::int64_t{1} << 24), 0.02, 0.005);  // 2 rad
}

TEST(SpiralTurns, AreCoprimeWithTheTapsAndAsPublished) {
    for (int s = 1; s < 100; ++s) EXPECT_EQ(std::gcd(SpiralTurns(s), s), 1) << s;
    for (int s = 100; s <= 4096; ++s) EXPECT_EQ(std::gcd(SpiralTurns(s), s), 1) << s;
    EXPECT_EQ(SpiralTurns(3), 2);
    EXPECT_EQ(SpiralTurns(4), 3);
    EXPECT_EQ(SpiralTurns(9), 2);
    EXPECT_EQ(SpiralTurns(11), 3);
    EXPECT_EQ(SpiralTurns(19), 7);
    EXPECT_EQ(SpiralTurns(44), 13);
    EXPECT_EQ(SpiralTurns(67), 18);
    EXPECT_EQ(SpiralTurns(99), 29);
    EXPECT_EQ(SpiralTurns(100), 5779);
}

// Pairs (s, tau) and (s, s - tau) are mirror images: cos is even.
TEST(SpiralTap, PublishedPairsAgainstTheTable) {
    const auto mirrored = [](int s, int a, int b) {
        for (int i = 0; i < s; ++i) {
            const double one = SpiralTap(i, s, a, 2 * kPi).angle_rad;
            const double two = SpiralTap(i, s, b, 2 * kPi).angle_rad;
            // alpha (a + b) is (i + 1/2) (a + b) / s turns: a multiple of a half.
            if (std::abs(std::cos(one) - std::cos(two + (a + b) / s * kPi)) > 1e-9 &&
                std::abs(std::cos(one) + std::cos(two)) > 1e-9) {
                return false;
            }
        }
        return true;
    };
    EXPECT_TRUE(mirrored(9, 7, SpiralTurns(9)));
    EXPECT_TRUE(mirrored(11, 7, 4));
    EXPECT_FALSE(mirrored(11, 7, SpiralTurns(11)));
}

TEST(SpiralTap, ByHand) {
    const UnitTap tap = SpiralTap(4, 9, 7, 2 * kPi);  // the middle one: alpha = 1/2
    EXPECT_DOUBLE_EQ(tap.alpha, 0.5);
    EXPECT_DOUBLE_EQ(tap.angle_rad, 7 * kPi);
    EXPECT_DOUBLE_EQ(SpiralTap(4, 9, 7, 6.28).angle_rad, 21.98);
    EXPECT_DOUBLE_EQ(SpiralTap(0, 1, 1, 2 * kPi).alpha, 0.5);
}

// The least distance of two taps of a unit disc: 0.1696 for (11, 7), 0.1498 for (11, 3). So the
// table does not maximize it: it minimizes the discrepancy.
TEST(SpiralTap, LeastDistances) {
    const auto least = [](int s, int turns) {
        double least_distance = 1;
        for (int i = 0; i < s; ++i) {
            for (int j = 0; j < i; ++j) {
                const UnitTap a = SpiralTap(i, s, turns, 2 * kPi);
                const UnitTap b = SpiralTap(j, s, turns, 2 * kPi);
                least_distance = std::min(
                    least_distance,
                    std::hypot(
                        a.alpha * std::cos(a.angle_rad) - b.alpha * std::cos(b.angle_rad),
                        a.alpha * std::sin(a.angle_rad) - b.alpha * std::sin(b.angle_rad)));
            }
        }
        return least_distance;
    };
    EXPECT_NEAR(least(11, 7), 0.1696, 5e-5);
    EXPECT_NEAR(least(11, 3), 0.1498, 5e-5);
}

// Of s taps even over the disc's area the share within the radius a is a^2, to one tap.
TEST(SunflowerTap, IsEvenOverTheArea) {
    for (const double a : {0.3, 0.5, 0.9}) {
        int within = 0;
        for (int i = 0; i < 1000; ++i) within += SunflowerTap(i, 1000).alpha < a;
        EXPECT_NEAR(within, 1000 * a * a, 1) << a;
    }
}

// 1 m at 1 m covers height / (2 tan) pixels, at 4 m a quarter.
TEST(DiscRadius, IsTheProjectedRadius) {
    const View view = MadeView(640, 480, 0.5);
    EXPECT_DOUBLE_EQ(DiscRadiusPx(view, 1, -1), 480);
    EXPECT_DOUBLE_EQ(DiscRadiusPx(view, 0.5, -4), 60);
    EXPECT_EQ(DiscRadiusPx(view, 1e6, -1e-6), kWidestPx);
}

TEST(LevelOfTap, BeginsAtTwiceTheSwitchRadius) {
    const auto level = [](double h) { return LevelOfTap(h, 3, 5); };
    EXPECT_EQ(level(0), 0);
    EXPECT_EQ(level(0.3), 0);
    EXPECT_EQ(level(8), 0);
    EXPECT_EQ(level(15.99), 0);
    EXPECT_EQ(level(16), 1);
    EXPECT_EQ(level(31.99), 1);
    EXPECT_EQ(level(32), 2);
    EXPECT_EQ(level(64), 3);
    EXPECT_EQ(level(128), 4);
    EXPECT_EQ(level(255.9), 4);
    EXPECT_EQ(level(256), 5);
    EXPECT_EQ(level(5000), 5);
    EXPECT_EQ(LevelOfTap(64, 5, 5), 1);
    EXPECT_EQ(LevelOfTap(5000, 3, 0), 0);
}

ZPyramid SlopePyramid(int coarsest) {
    Image<float> z(64, 48);
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) z(x, y) = -1 - float(x + 100 * y);
    }
    return {z, ZFilter::kRotatedGrid, coarsest};
}

// From pixel (30, 20), 17.5 px at an angle whose cosine is -0.6: the offset is (-10.5, 14).
TEST(LookUpTap, RoundsAndPlacesAsItsOptionsSay) {
    const ZPyramid pyramid = SlopePyramid(5);
    const Vec2 u(-0.6, 0.8);
    TapOptions taps;
    TapTexel found = LookUpTap(taps, pyramid, 30, 20, 17.5, u);
    EXPECT_EQ(found.level, 1);
    EXPECT_EQ(found.i, 10);  // 30 - 10 = 20, >> 1
    EXPECT_EQ(found.j, 17);
    EXPECT_EQ(found.place_px, Vec2(20.5, 34.5));

    taps.rounding = TapRounding::kSum;  // trunc(19.5) = 19
    found = LookUpTap(taps, pyramid, 30, 20, 17.5, u);
    EXPECT_EQ(found.i, 9);
    EXPECT_EQ(found.place_px, Vec2(19.5, 34.5));

    taps.place = TapPlace::kLevelTexel;  // texel (9, 17) of level 1 covers 18..20, 34..36
    EXPECT_EQ(LookUpTap(taps, pyramid, 30, 20, 17.5, u).place_px, Vec2(19, 35));
    taps.place = TapPlace::kTap;
    EXPECT_LT((LookUpTap(taps, pyramid, 30, 20, 17.5, u).place_px - Vec2(20, 34.5)).norm(),
              1e-12);
}

TEST(LookUpTap, StaysInsideThePicture) {
    const ZPyramid pyramid = SlopePyramid(5);
    TapOptions taps;
    TapTexel found = LookUpTap(taps, pyramid, 60, 10, 20, {1, 0});
    EXPECT_EQ(found.i, 63 >> 1);
    EXPECT_EQ(found.place_px, Vec2(63.5, 10.5));
    taps.outside = TapOutside::kBorderDepth;
    found = LookUpTap(taps, pyramid, 60, 10, 20, {1, 0});
    EXPECT_EQ(found.i, 63 >> 1);
    EXPECT_EQ(found.place_px, Vec2(80.5, 10.5));
    found = LookUpTap(taps, pyramid, 2, 3, kWidestPx, {-0.6, -0.8});
    EXPECT_EQ(found.i, 0);
    EXPECT_EQ(found.j, 0);
    EXPECT_EQ(found.level, 5);
}

TEST(TapOptions, BadValuesAreNamed) {
    TapOptions taps;
    taps.samples = 0;
    try {
        Validate(taps);
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "TapOptions::samples = 0, must be in [1, 4096]");
    }
    taps = {};
    taps.log2_switch_px = -1;
    EXPECT_THROW(Validate(taps), Error);
    taps = {};
    taps.min_tap_px = std::nan("");
    EXPECT_THROW(Validate(taps), Error);
    taps.min_tap_px = 0;
    taps.hash_shift_px = 16384;
    EXPECT_THROW(Validate(taps), Error);
    taps.hash_shift_px = -16383;
    EXPECT_NO_THROW(Validate(taps));
}

}  // namespace
}  // namespace plumb
