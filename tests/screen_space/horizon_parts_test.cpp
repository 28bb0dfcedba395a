// The parts of HBAO, GTAO and the visibility bitmask, each by hand.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <numbers>

#include "screen_space/horizon/slice_integral.h"
#include "tests/screen_space/horizon_scenes.h"

namespace plumb {
namespace {

using std::numbers::pi;

constexpr int M = Pit::kMiddle;

// a' = cos(h - gamma) |sin h| by central differences: their error is a''' e^2 / 6 < 2 e^2.
TEST(SliceIntegral, DerivativeIsTheIntegrand) {
    constexpr double e = 1e-5;
    for (const double gamma : {-1.2, -0.3, 0.0, 0.7, 1.5}) {
        EXPECT_EQ(SliceIntegral(0, gamma), 0);
        for (const double h : {-1.4, -0.5, 0.2, 1.1, 2.0}) {
            const double slope =
                (SliceIntegral(h + e, gamma) - SliceIntegral(h - e, gamma)) / (2 * e);
            EXPECT_NEAR(slope, std::cos(h - gamma) * std::sin(h), 2 * e * e + 1e-10);
        }
        EXPECT_NEAR(OpenSlice(gamma),
                    SliceIntegral(gamma - pi / 2, gamma) + SliceIntegral(gamma + pi / 2, gamma),
                    1e-14);
    }
}

// h(th) against the integral of its density by 4000 midpoints.
TEST(SectorShare, IsTheShareBeforeTheAngle) {
    for (const double gamma : {-1.0, 0.0, 0.6}) {
        const double begin = gamma - pi / 2, step = pi / 4000;
        double uniform = 0, cosine = 0;
        for (int k = 0; k < 4000; ++k) {
            const double th = begin + (k + 0.5) * step;
            uniform += step / pi;
            cosine += step * std::cos(th - gamma) * std::abs(std::sin(th)) / OpenSlice(gamma);
            const double end = begin + (k + 1) * step;
            ASSERT_NEAR(SectorShare(end, gamma, SectorMeasure::kUniform), uniform, 1e-9);
            ASSERT_NEAR(SectorShare(end, gamma, SectorMeasure::kCosine), cosine, 1e-6);
        }
        EXPECT_NEAR(cosine, 1, 1e-6);
        EXPECT_EQ(SectorShare(begin, gamma, SectorMeasure::kUniform), 0);
    }
}

// Of 8 sectors, by hand. ceil: [0.25, 0.5) is sectors 2 and 3; [0.3, 0.31) is floor(2.4) = 2,
// and ceil(0.08) = 1 of them; [0.9, 1] is 7, ceil(0.8) = 1. round: [0.3, 0.31) is 2 up to 2,
// none; [0.3, 0.45) is 2 up to round(3.6) = 4.
TEST(ClosedSectors, ByHand) {
    const auto ceil = [](double a, double b) {
        return ClosedSectors(a, b, 8, SectorRounding::kCeil);
    };
    const auto round = [](double a, double b) {
        return ClosedSectors(a, b, 8, SectorRounding::kRound);
    };
    EXPECT_EQ(ceil(0.25, 0.5), 0b1100u);
    EXPECT_EQ(ceil(0.3, 0.31), 0b100u);
    EXPECT_EQ(ceil(0.9, 1), 0b10000000u);
    EXPECT_EQ(ceil(0, 1), 0b11111111u);
    EXPECT_EQ(ceil(0.5, 0.5), 0u);
    EXPECT_EQ(ceil(1, 1), 0u);
    EXPECT_EQ(round(0.3, 0.31), 0u);
    EXPECT_EQ(round(0.3, 0.45), 0b1100u);
    EXPECT_EQ(round(0, 1), 0b11111111u);
    EXPECT_EQ(ClosedSectors(0, 1, 64, SectorRounding::kCeil), ~std::uint64_t{0});
    EXPECT_EQ(ClosedSectors(0.5, 1, 64, SectorRounding::kRound), ~std::uint64_t{0} << 32);
}

// Rounding both ends is right on average over where a gap lies; ceil is half a sector too
// much.
TEST(ClosedSectors, CeilCountsHalfASectorTooManyOnAverage) {
    double ceil = 0, round = 0;
    constexpr int kPlaces = 1000;
    for (int k = 0; k < kPlaces; ++k) {
        const double begin = 0.3 + (k + 0.5) / kPlaces / 32, end = begin + 0.2;  // 6.4 sectors.
        ceil += std::popcount(ClosedSectors(begin, end, 32, SectorRounding::kCeil));
        round += std::popcount(ClosedSectors(begin, end, 32, SectorRounding::kRound));
    }
    EXPECT_NEAR(round / kPlaces, 6.4, 0.002);
    EXPECT_NEAR(ceil / kPlaces, 7, 1e-12);
}

// Only the rim rises, at the distance d = sqrt(R^2 + 1): A = 1 - W(d) (cos h - sin bias), with
// W = 1 - d^2 / r^2. Tolerance as in the pit.
TEST(Hbao, AttenuatesAndBiasesByHand) {
    const Pit pit(1);
    SliceSampling s = pit.Sampling();
    s.radius_m = 3;
    for (const double bias : {0.0, 0.3}) {
        for (const double strength : {1.0, 0.5}) {
            const HbaoOptions options{.sampling = s, .bias_rad = bias, .strength = strength};
            ExpectOfPit(pit, HbaoOfPixel(pit.gbuffer, options, M, M), 1e-5, [&](double h) {
                const double d2 = 1 / std::pow(std::cos(h), 2);
                return 1 - strength * (1 - d2 / 9) * (std::cos(h) - std::sin(bias));
            });
        }
    }
}

// The rim's cosine cos h is drawn to that of the plane, 0, by w = (r - d) / (r - start), and
// then V = 1 - (w cos h)^2 on both sides of each slice.
TEST(Gtao, FallsOffByHand) {
    const Pit pit(1);
    SliceSampling s = pit.Sampling();
    s.radius_m = 3;
    const GtaoOptions options{.sampling = s, .falloff_start = 0.25};
    ExpectOfPit(pit, GtaoOfPixel(pit.gbuffer, options, M, M), 1e-5, [](double h) {
        const double d = 1 / std::cos(h), w = (3 - d) / (3 - 0.75);
        return 1 - std::pow(w * std::cos(h), 2);
    });
}

// A column of 41 pixels: a floor 5 m away, and a thin bar 1 m nearer in the fifth pixel on
// both sides of the middle. The pixel offset of 5 at depth 4 is 5 (2 tan / 41) 4 m = 0.39 m
// across. The 15 samples behind the bar lie in the floor: each lowers cos h by a tenth of
// itself.
TEST(Gtao, ThinBarsFadeByHand) {
    GBuffer g = MadeGBuffer(MadeView(1, 41, 0.4), MadePlane({0, 0, 1}, -5));
    g.z_m(0, 15) = g.z_m(0, 25) = -4;
    const SliceSampling s{
        .radius_m = 10, .slices = 1, .steps = 4096, .step_power = 1, .jitter = false};
    const double across = 5 * 0.8 / 41 * 4, c = 1 / std::sqrt(1 + across * across);
    EXPECT_NEAR(GtaoOfPixel(g, HardGtao(s), 0, 20), 1 - c * c, 1e-6);
    GtaoOptions thin = HardGtao(s);
    thin.thickness_blend = 0.1;
    EXPECT_NEAR(GtaoOfPixel(g, thin, 0, 20), 1 - std::pow(c * std::pow(0.9, 15), 2), 1e-6);
}

// The same bar for the bitmask: 0.5 m thick it hides the angles from atan(across / 1) to
// atan(across / 0.5) on each side, and light comes in below. Tolerance: half a sector an end.
TEST(VisibilityBitmask, SeesBehindABarByHand) {
    GBuffer g = MadeGBuffer(MadeView(1, 41, 0.4), MadePlane({0, 0, 1}, -5));
    g.z_m(0, 15) = g.z_m(0, 25) = -4;
    const SliceSampling s{
        .radius_m = 10, .slices = 1, .steps = 4096, .step_power = 1, .jitter = false};
    const double across = 5 * 0.8 / 41 * 4;
    const double front = std::atan(across), back = std::atan(across / 0.5);
    BitmaskOptions options{.sampling = s,
                           .thickness_m = 0.5,
                           .sectors = 64,
                           .measure = SectorMeasure::kCosine,
                           .rounding = SectorRounding::kRound};
    const double hidden = std::pow(std::sin(back), 2) - std::pow(std::sin(front), 2);
    EXPECT_NEAR(VisibilityBitmaskOfPixel(g, options, 0, 20), 1 - hidden, 2.0 / 64);
    options.measure = SectorMeasure::kUniform;
    EXPECT_NEAR(VisibilityBitmaskOfPixel(g, options, 0, 20), 1 - 2 * (back - front) / pi,
                2.0 / 64);
    EXPECT_GT(hidden, 0.2);
}

}  // namespace
}  // namespace plumb
