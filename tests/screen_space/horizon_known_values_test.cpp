// What HBAO, GTAO and the visibility bitmask tend to as samples grow, where that is known.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/screen_space/horizon_scenes.h"

namespace plumb {
namespace {

using std::numbers::pi;

constexpr int M = Pit::kMiddle;
constexpr double kRounding = 1e-5;  // Of z in float, some 3e-7 m, over a pixel of 8 mm.

class ConePit : public testing::TestWithParam<double> {};

// The same cone of sky in three measures. GTAO: cosine, the truth, Int sin 2h = sin^2 h. HBAO:
// solid angle, 1 - cos h. Uniform sectors: angle, 2h / pi; each of the two ends is rounded by
// at most half a sector of 64. 30 degrees: .25, .134, .333; 45: .5, .293, .5; 60: .75, .5,
// .667.
TEST_P(ConePit, HasItsValueInEachMeasure) {
    const Pit pit(std::tan(GetParam() * pi / 180));
    const SliceSampling s = pit.Sampling();
    const auto cosine = [](double h) { return std::pow(std::sin(h), 2); };
    ExpectOfPit(pit, GtaoOfPixel(pit.gbuffer, HardGtao(s), M, M), kRounding, cosine);
    ExpectOfPit(pit, HbaoOfPixel(pit.gbuffer, UnattenuatedHbao(s), M, M), kRounding,
                [](double h) { return 1 - std::cos(h); });
    ExpectOfPit(
        pit,
        VisibilityBitmaskOfPixel(pit.gbuffer, ThickBitmask(s, SectorMeasure::kUniform), M, M),
        1.0 / 64, [](double h) { return 2 * h / pi; });
    ExpectOfPit(
        pit,
        VisibilityBitmaskOfPixel(pit.gbuffer, ThickBitmask(s, SectorMeasure::kCosine), M, M),
        1.0 / 64, cosine);
}

INSTANTIATE_TEST_SUITE_P(Degrees, ConePit, testing::Values(30.0, 45.0, 60.0));

struct Tilt {
    double normal_x, normal_y;  ///< With n_z = 1.
    int x, y;                   ///< The receiver, of 65 x 65 pixels.
};

class OpenPlane : public testing::TestWithParam<Tilt> {};

// Expected: nothing rises above its own plane, at any tilt: 1. The mean of the open slices is
// that of a smooth periodic function over 256 slices: no error to be seen.
TEST_P(OpenPlane, IsOpen) {
    const auto [nx, ny, x, y] = GetParam();
    const Vec3 n = Vec3(nx, ny, 1).normalized();
    const GBuffer g = MadeGBuffer(MadeView(65, 65, 0.4), MadePlane(n, n.dot(Vec3(0, 0, -5))));
    ASSERT_LT(g.z_m(x, y), 0);
    for (const double radius : {0.5, 3.0}) {
        SliceSampling s = EveryPixelOfASlice(radius, 256);
        EXPECT_NEAR(HbaoOfPixel(g, UnattenuatedHbao(s), x, y), 1, kRounding);
        s.spread = SliceSpread::kLineOfSight;
        EXPECT_NEAR(HbaoOfPixel(g, UnattenuatedHbao(s), x, y), 1, kRounding);
        EXPECT_NEAR(GtaoOfPixel(g, HardGtao(s), x, y), 1, kRounding);
        for (const SectorMeasure measure : {SectorMeasure::kUniform, SectorMeasure::kCosine}) {
            EXPECT_NEAR(VisibilityBitmaskOfPixel(g, ThickBitmask(s, measure), x, y), 1, 1e-9);
        }
    }
    // With one slice the mean is 1 only on average, but normalized it is 1.
    SliceSampling one = EveryPixelOfASlice(3, 1);
    one.jitter = true;
    EXPECT_NEAR(GtaoOfPixel(g, {.sampling = one, .normalize = true}, x, y), 1, kRounding);
}

INSTANTIATE_TEST_SUITE_P(Tilts, OpenPlane,
                         testing::Values(Tilt{0, 0, 32, 32}, Tilt{0, 0, 5, 60},
                                         Tilt{0.5, 0, 32, 32}, Tilt{0, -2, 40, 20},
                                         Tilt{1.5, 1, 10, 40}, Tilt{-2.1, 0, 50, 12}));

// As published, slices are even on screen. For a plane that faces the eye's axis, seen at 0.4
// to both sides (29.5 degrees off), the mean of L (cos gamma + gamma sin gamma) over even
// angles phi of D is 0.99503, here by 100 000 midpoints: n_V, n_t of the slice through V =
// (-.4, -.4, 1) / |V|.
TEST(OpenPlanePublished, IsDarkenedBySlicesThatAreEvenOnScreen) {
    const GBuffer g = MadeGBuffer(MadeView(65, 65, 0.4), MadePlane({0, 0, 1}, -5));
    const Vec3 V = -g.view.Point(64.5, 0.5, -1).normalized();
    double mean = 0;
    constexpr int kAngles = 100000;
    for (int k = 0; k < kAngles; ++k) {
        const double phi = pi * (k + 0.5) / kAngles;
        const Vec3 D(std::cos(phi), std::sin(phi), 0);
        const double n_V = V.z(),
                     n_t = -D.dot(V) * V.z() / std::sqrt(1 - std::pow(D.dot(V), 2));
        const double gamma = std::atan2(n_t, n_V);
        mean += (n_V + gamma * n_t) / kAngles;
    }
    EXPECT_LT(mean, 0.996);
    SliceSampling s = EveryPixelOfASlice(1, 256);
    EXPECT_NEAR(GtaoOfPixel(g, HardGtao(s), 64, 0), mean, kRounding);
    s.spread = SliceSpread::kLineOfSight;
    EXPECT_NEAR(GtaoOfPixel(g, HardGtao(s), 64, 0), 1, kRounding);
}

// As published, ceil closes a sector of 32 for each side's samples, however little they rise:
// the plane keeps 30 or 31 of 32 (.94 to .97), and rounding both ends mends it.
TEST(BitmaskCeil, DarkensAnOpenPlane) {
    const Vec3 n = Vec3(0.3, 0.2, 1).normalized();
    const GBuffer g = MadeGBuffer(MadeView(33, 33, 0.4), MadePlane(n, n.dot(Vec3(0, 0, -5))));
    BitmaskOptions options{.sampling = EveryPixelOfASlice(1, 16), .thickness_m = 1};
    const double published = VisibilityBitmaskOfPixel(g, options, 16, 16);
    EXPECT_GE(published, 30.0 / 32);
    EXPECT_LT(published, 31.5 / 32);
    options.rounding = SectorRounding::kRound;
    EXPECT_DOUBLE_EQ(VisibilityBitmaskOfPixel(g, options, 16, 16), 1);
}

// Expected: the part of V that the picture shows: all but the form factor of the wall's
// rectangle within the frame, |x| < 2.5, 0 < y < 3.5 above the floor, at d = 1; summed over
// 700 x 700 pieces. Tolerance: the last pixel centres lie up to half a pixel inside the frame,
// and slices stop up to a pixel short of it: 1.5 pixels of 5/257 m seen from 2.7 m at least
// (the nearest point of the frame's edge), with dV/dh <= 1.
TEST(FloorAndWall, GtaoTendsToTheTruthOfThePicture) {
    const GBuffer g = MadeGBuffer(MadeView(257, 257), MadeFloorAndWall());
    const int x = 128, y = 192;
    ASSERT_NEAR(g.face_normal(x, y).y(), 1, 1e-6);
    const double d = 5 + g.z_m(x, y);
    ASSERT_NEAR(d, 1, 0.05);
    constexpr int kPieces = 700;
    double F = 0;
    for (int i = 0; i < kPieces; ++i) {
        for (int j = 0; j < kPieces; ++j) {
            const double across = -2.5 + (i + 0.5) * 5 / kPieces;
            const double up = (j + 0.5) * 3.5 / kPieces;
            const double r2 = across * across + up * up + d * d;
            F += up * d / (pi * r2 * r2) * (5.0 / kPieces) * (3.5 / kPieces);
        }
    }
    SliceSampling s = EveryPixelOfASlice(10, 256);
    s.spread = SliceSpread::kLineOfSight;
    const double tolerance = 1.5 * 5 / 257 / 2.7;
    EXPECT_NEAR(GtaoOfPixel(g, HardGtao(s), x, y), 1 - F, tolerance);
    EXPECT_NEAR(VisibilityBitmaskOfPixel(g, ThickBitmask(s, SectorMeasure::kCosine), x, y),
                1 - F, tolerance + pi / 2 / 64);
    EXPECT_GT(F, 10 * tolerance);
    // Within a radius that ends before the wall there is only floor.
    s.radius_m = 0.9;
    EXPECT_NEAR(GtaoOfPixel(g, HardGtao(s), x, y), 1, kRounding);
}

// Expected, at the middle of a trench of half-width w and depth D = 1: the horizon of the
// slice at azimuth phi has tan h = w / |cos phi|, so that the means over phi are
//   GTAO  w / sqrt(w^2 + D^2) = .447214,   HBAO  (2 / pi) atan(w / D) = .295167.
// As drawn, w is up to 1.5 pixels of 16 / 769 m too great, as in the pit, and up to 0.71 too
// small: so far off the slice may the pixel's centre lie, and the rim is straight. Where
// slices leave the frame before the rim, 8 m away, cos^2 h <= 1/65 for 2 x 3.6 degrees in 180.
TEST(Trench, HasItsValueInEachMeasure) {
    const GBuffer g = MadeGBuffer(MadeView(769, 769, 2), MadeTrench());
    const SliceSampling s = EveryPixelOfASlice(20, 128);
    const double widest = 0.5 + 1.5 * 16 / 769, narrowest = 0.5 - 0.71 * 16 / 769;
    const double cut = std::sqrt(1.0 / 65) * 7.2 / 180;
    const auto cosine = [](double w) { return w / std::sqrt(w * w + 1); };
    const auto uniform = [](double w) { return 2 / pi * std::atan(w); };
    const double gtao = GtaoOfPixel(g, HardGtao(s), 384, 384);
    EXPECT_GE(gtao, cosine(narrowest) - kRounding);
    EXPECT_LE(gtao, cosine(widest) + cut);
    const double hbao = HbaoOfPixel(g, UnattenuatedHbao(s), 384, 384);
    EXPECT_GE(hbao, uniform(narrowest) - kRounding);
    EXPECT_LE(hbao, uniform(widest) + cut);
}

// With a back that is nowhere, the mask's cosine sectors and GTAO's closed integral are the
// same quantity by two ways: each of the two ends of a slice of T <= pi/2 is off by half a
// sector.
TEST(BitmaskCosine, AgreesWithGtaoOnASphereAndAStep) {
    const GBuffer g =
        MadeGBuffer(MadeView(48, 48), Union(MadeSphereOverPlane(), MadeFloorAndWall()));
    SliceSampling s{.radius_m = 3, .slices = 6, .steps = 40};
    const Image<float> gtao = Gtao(g, HardGtao(s));
    const Image<float> mask = VisibilityBitmask(g, ThickBitmask(s, SectorMeasure::kCosine));
    double darkest = 1;
    for (int j = 0; j < 48; ++j) {
        for (int i = 0; i < 48; ++i) {
            EXPECT_NEAR(mask(i, j), gtao(i, j), pi / 2 / 64) << i << ' ' << j;
            darkest = std::min(darkest, double(gtao(i, j)));
        }
    }
    EXPECT_LT(darkest, 0.6);
}

// Expected from the definition: A = max(least, V^power), and an eye-facing plane, whose slices have
// L = 1, is open whatever the lift; so are far samples of a plane, which no fade can raise.
TEST(Gtao, PowerLeastAndLiftAreWhatTheySay) {
    const GBuffer tilted = MadeGBuffer(MadeView(96, 96, 0.5), MadePlane({0.6, 0, 1}, -5));
    const SliceSampling s{.radius_m = 1, .slices = 3, .steps = 4};
    const double V = GtaoOfPixel(tilted, {.sampling = s}, 40, 40);
    EXPECT_NEAR(GtaoOfPixel(tilted, {.sampling = s, .power = 2.2}, 40, 40), std::pow(V, 2.2),
                1e-12);
    EXPECT_EQ(GtaoOfPixel(tilted, {.sampling = s, .least = 1}, 40, 40), std::max(1.0, V));
    // The rounding of z, 3e-7 m, over the nearest sample's distance of 0.05 m.
    EXPECT_NEAR(GtaoOfPixel(tilted, {.sampling = s, .fade = HorizonFade::kBehind}, 40, 40), V,
                2e-5);
    const GBuffer facing = MadeGBuffer(MadeView(64, 64, 0.01), MadePlane({0, 0, 1}, -5));
    EXPECT_NEAR(GtaoOfPixel(facing, {.sampling = s, .length_lift = 1}, 32, 32), 1, 1e-3);
    // Tilted, L < 1: lifted to 1 the slices count more.
    EXPECT_GT(GtaoOfPixel(tilted, {.sampling = s, .length_lift = 1}, 40, 40), V);
}

}  // namespace
}  // namespace plumb
