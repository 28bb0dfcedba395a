#include "score/flip.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/parallel.h"
#include "score/flip_colour.h"
#include "score/flip_filters.h"
#include "score/flip_hdr.h"
#include "tests/score/flip_answers.h"
#include "tests/score/slow_flip.h"

namespace plumb {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

double MeanOf(const Image<float>& map) {
    return MeanOverTiles(map).value;
}

double MaxOf(const Image<float>& map) {
    return *std::max_element(map.Pixels().begin(), map.Pixels().end());
}

Image<Rgb> Noise(int width, int height, std::uint64_t seed) {
    return MadeImage<Rgb>(width, height, [&](int i, int j) {
        const auto unit = [&](std::uint64_t c) {
            return float(RandomUnit(seed, std::uint64_t(j) * 1000 + i, c, 0));
        };
        return Rgb{unit(0), unit(1), unit(2)};
    });
}

// Means, maxima and middles that the published program gives, computed from its header with sums
// in double. It promises six decimals of the mean and not every pixel (its pixels are float): means
// are held to 5e-6, pixels to 1e-4.
//
// Where features are equal in both pictures, as in any two flat ones, the exponent's f is 0. The
// program's floats leave about 1e-8 to 4e-6 of a difference, and f is its square root: E^(1 - f)
// then lies f E ln(1/E) too high. The same equations in float give 0.967390, 0.029871 and 0.149013
// for the three greys, in double what ClosedFormOfFlatPictures expects.
TEST(Flip, KnownAnswers) {
    for (const FlipAnswer& answer : FlipAnswers()) {
        const Image<float> map = answer.hdr ? HdrFlipMap(answer.candidate, answer.reference).map
                                            : FlipMap(answer.candidate, answer.reference);
        EXPECT_NEAR(MeanOf(map), answer.mean, 5e-6 + answer.rounding) << answer.name;
        EXPECT_LE(MeanOf(map), answer.mean + 5e-6) << answer.name;
        if (answer.max < 0) continue;
        EXPECT_NEAR(MaxOf(map), answer.max, 1e-4) << answer.name;
        EXPECT_NEAR(map(map.Width() / 2, map.Height() / 2), answer.middle, 1e-4) << answer.name;
    }
}

// Greys have a = b = 0, and no features: d = |L1 - L2|^0.7. Tolerance: float pixels; white is
// white to the nine digits of the matrices.
TEST(Flip, ClosedFormOfFlatPictures) {
    const double d_max = 41.276096, c = 0.4 * d_max;
    EXPECT_NEAR(GreatestColourDifference(), d_max, 4e-6);  // As known: rounded to float.
    const auto flip = [](double a, double b) {
        return double(
            FlipMap(Image<Rgb>(3, 2, Grey(float(a))), Image<Rgb>(3, 2, Grey(float(b))))(1, 1));
    };
    const auto L = [](double y) { return 116 * std::cbrt(y) - 16; };
    const double white = 0.95 + 0.05 * (std::pow(100, 0.7) - c) / (d_max - c);
    EXPECT_NEAR(flip(0, 1), white, 1e-6);
    EXPECT_NEAR(white, 0.9673798, 1e-7);
    EXPECT_NEAR(flip(0.25, 0.5), 0.95 * std::pow(L(0.5) - L(0.25), 0.7) / c, 1e-6);
    EXPECT_NEAR(flip(0.25, 0.26), 0.95 * std::pow(L(0.26) - L(0.25), 0.7) / c, 1e-6);
}

// Whole two-dimensional filters against lines; taller than the rows that one thread takes.
TEST(Flip, EqualsItsDefinitionPixelByPixel) {
    for (const double ppd : {20.0, kFlipPixelsPerDegree}) {
        const Image<Rgb> a = Noise(9, 70, 1), b = Noise(9, 70, 2);
        const Image<float> map = FlipMap(a, b, {.pixels_per_degree = ppd});
        const SlowFlip slow(ppd);
        for (const auto& [i, j] : {std::pair{0, 0}, {8, 69}, {4, 30}, {3, 63}, {5, 64}}) {
            EXPECT_NEAR(map(i, j), slow.At(a, b, i, j), 1e-6) << i << ", " << j;
        }
    }
}

TEST(Flip, Laws) {
    const Image<Rgb> a = Noise(20, 30, 3), b = Noise(20, 30, 4);
    EXPECT_EQ(MaxOf(FlipMap(a, a)), 0);
    const Image<float> map = FlipMap(a, b);
    EXPECT_EQ(map, FlipMap(b, a));
    EXPECT_GT(MeanOf(map), 0);
    EXPECT_LE(MaxOf(map), 1);
    EXPECT_EQ(MaxOf(FlipMap(Image<Rgb>(4, 4, Rgb{0, 1, 0}), Image<Rgb>(4, 4, Rgb{0, 0, 1}))),
              1);
    // What no screen shows is no difference.
    EXPECT_EQ(MaxOf(FlipMap(Image<Rgb>(4, 4, Grey(1)), Image<Rgb>(4, 4, Grey(50)))), 0);
    EXPECT_EQ(MaxOf(FlipMap(Image<Rgb>(4, 4, Grey(0)), Image<Rgb>(4, 4, Grey(-2)))), 0);
}

TEST(Flip, TheSameBitsOnOneThreadAndOnFour) {
    const Image<Rgb> a = Noise(33, 200, 5), b = Noise(33, 200, 6);
    const int before = ThreadCount();
    SetThreadCount(1);
    const Image<float> one = FlipMap(a, b);
    SetThreadCount(4);
    EXPECT_EQ(one, FlipMap(a, b));
    SetThreadCount(before);
}

// Nothing beyond it but itself: flat, whatever its size.
TEST(Flip, OfOnePixelIsThatOfAFlatPicture) {
    const Image<Rgb> a(1, 1, Rgb{0.2F, 0.4F, 0.1F}), b(1, 1, Rgb{0.5F, 0.1F, 0.3F});
    const Image<Rgb> wide_a(30, 30, a(0, 0)), wide_b(30, 30, b(0, 0));
    EXPECT_FLOAT_EQ(FlipMap(a, b)(0, 0), FlipMap(wide_a, wide_b)(15, 15));
}

TEST(Flip, RefusesWhatItCannotCompare) {
    const Image<Rgb> two(2, 1, Grey(0.5F));
    const auto flip = [](Image<Rgb> a, Image<Rgb> b) { return [=] { FlipMap(a, b); }; };
    EXPECT_THAT(flip(Image<Rgb>(3, 1), two),
                ThrowsMessage<Error>(HasSubstr("candidate: width = 3, must be that of the "
                                               "reference, 2")));
    EXPECT_THAT(flip(Image<Rgb>(2, 2), two), ThrowsMessage<Error>(HasSubstr("height = 2")));
    EXPECT_THAT(flip({}, {}), ThrowsMessage<Error>(HasSubstr("pixels = 0")));
    Image<Rgb> bad = two;
    bad(1, 0)[2] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(flip(bad, two), ThrowsMessage<Error>(HasSubstr("candidate[1, 0] = nan")));
    EXPECT_THAT(flip(two, bad), ThrowsMessage<Error>(HasSubstr("reference[1, 0] = nan")));
    EXPECT_THAT([&] { FlipMap(two, two, {.pixels_per_degree = 0}); },
                ThrowsMessage<Error>(HasSubstr("pixels a degree = 0, must be in [1, 1000]")));
}

// Radii of the facts: 10 and 9 at 67 pixels a degree. Sums by definition.
TEST(FlipFilters, AreNormalized) {
    const FlipFilters f = MakeFlipFilters(kFlipPixelsPerDegree);
    EXPECT_EQ(f.Cz_wide.Reach(), 10);
    EXPECT_EQ(f.G.Reach(), 9);
    EXPECT_EQ(f.reach_px, 10);
    const auto sum = [](const LineFilter& filter, bool positive) {
        double total = 0;
        for (int k = -filter.Reach(); k <= filter.Reach(); ++k) {
            const double w =
                (k < 0 && filter.odd ? -1 : 1) * filter.w[std::size_t(std::abs(k))];
            if (positive == (w > 0)) total += w;
        }
        return total;
    };
    EXPECT_NEAR(sum(f.Y, true), 1, 1e-11);
    EXPECT_NEAR(sum(f.Cx, true), 1, 1e-11);
    EXPECT_NEAR(std::pow(sum(f.Cz_wide, true), 2) + std::pow(sum(f.Cz_narrow, true), 2), 1,
                1e-11);
    EXPECT_NEAR(sum(f.G, true), 1, 1e-14);
    EXPECT_NEAR(sum(f.edge, true), 1, 1e-14);
    EXPECT_NEAR(sum(f.edge, false), -1, 1e-14);
    EXPECT_NEAR(sum(f.point, true), 1, 1e-14);
    EXPECT_NEAR(sum(f.point, false), -1, 1e-14);
}

// (6/29)^3 joins both parts of CIELAB's curve; there and back is the same colour, to
// the nine decimals of the matrix.
TEST(FlipColour, ByHand) {
    const Triple lab = HuntLabOfRgb({0.5, 0.5, 0.5});
    EXPECT_NEAR(lab[0], 116 * std::cbrt(0.5) - 16, 1e-12);
    EXPECT_NEAR(lab[1], 0, 1e-7);
    EXPECT_NEAR(HuntLabOfRgb({0.001, 0.001, 0.001})[0], 0.001 * 24389 / 27, 1e-12);
    const Triple rgb = RgbOfYCxCz(YCxCzOfRgb({0.2, 0.7, 0.4}));
    EXPECT_NEAR(rgb[0], 0.2, 1e-7);
    EXPECT_NEAR(rgb[1], 0.7, 1e-7);
    EXPECT_NEAR(rgb[2], 0.4, 1e-7);
    EXPECT_DOUBLE_EQ(HyAb({3, 0, 0}, {1, 3, 4}), 7);
}

TEST(FlipColour, CubeRootIsThatOfTheLibrary) {
    double worst = 0;  // At most 2/3 (2/3 0.04^3)^3 = 5e-14.
    for (double x = 0.001; x < 10; x *= 1.0007)
        worst = std::max(worst, std::abs(CubeRoot(x) / std::cbrt(x) - 1));
    EXPECT_LT(worst, 1e-13);
}

// Roots of the published curves at 0.85, to six decimals.
TEST(ToneCurve, BrightestShown) {
    EXPECT_NEAR(BrightestShown(ToneCurve::kAces), 2.118872, 5e-7);
    EXPECT_NEAR(BrightestShown(ToneCurve::kHable), 3.127749, 5e-7);
    EXPECT_NEAR(BrightestShown(ToneCurve::kReinhard), 5.666667, 5e-7);
    for (const ToneCurve curve : {ToneCurve::kAces, ToneCurve::kHable, ToneCurve::kReinhard}) {
        EXPECT_NEAR(Shown(curve, Grey(float(BrightestShown(curve))))[1], 0.85, 1e-6);
        EXPECT_EQ(Shown(curve, Grey(0))[0], 0);
    }
    // By its luminance, not by channel: Y = 0.2126 * 3, so 3 / 1.6378.
    EXPECT_NEAR(Shown(ToneCurve::kReinhard, {3, 0, 0})[0], 1.831726, 1e-6);
}

TEST(ToneExposures, KnownAnswer) {
    const ToneExposures e = ExposuresOf(ToneCurve::kAces, Stops());
    EXPECT_NEAR(e.start_stops, -1.9875, 5e-5);
    EXPECT_NEAR(e.stop_stops, 0.5635, 5e-5);
    EXPECT_EQ(e.count, 3);
    EXPECT_FALSE(e.median_of_positive);
    EXPECT_DOUBLE_EQ(e.At(0), e.start_stops);
    EXPECT_DOUBLE_EQ(e.At(2), e.stop_stops);
}

// All alike: both ends are one exposure, taken twice.
TEST(ToneExposures, OfAFlatPictureAreTwo) {
    const ToneExposures e = ExposuresOf(ToneCurve::kAces, Image<Rgb>(2, 2, Grey(1)));
    EXPECT_EQ(e.count, 2);
    EXPECT_DOUBLE_EQ(e.start_stops, e.stop_stops);
}

// The published program does not end on a median of 0.
TEST(ToneExposures, OfAMostlyBlackPictureAreThoseOfItsLight) {
    Image<Rgb> lamp(4, 4, Grey(0));
    lamp(1, 1) = Grey(8);
    lamp(2, 2) = Grey(0.25F);
    lamp(3, 3) = Grey(2);
    const ToneExposures e = ExposuresOf(ToneCurve::kAces, lamp);
    EXPECT_TRUE(e.median_of_positive);
    EXPECT_NEAR(e.stop_stops, std::log2(2.118872 / 2), 1e-6);
    EXPECT_NEAR(e.start_stops, std::log2(2.118872 / 8), 1e-6);
    EXPECT_EQ(e.count, 2);
    EXPECT_EQ(MaxOf(HdrFlipMap(lamp, lamp).map), 0);
}

TEST(ToneExposures, OfABlackPictureAreRefused) {
    EXPECT_THAT([] { ExposuresOf(ToneCurve::kAces, Image<Rgb>(2, 2, Grey(0))); },
                ThrowsMessage<Error>(HasSubstr("greatest luminance = 0, must be > 0")));
}

TEST(HdrFlip, NegativeNumbersCountAsNothing) {
    Image<Rgb> reference = Stops(), candidate = Stops();
    reference(3, 3) = {0, 0, 0.5F};
    candidate(3, 3) = {-30, -30, 0.5F};
    EXPECT_EQ(MaxOf(HdrFlipMap(candidate, reference).map), 0);
}

// The greatest of single exposures.
TEST(HdrFlip, IsTheWorstExposure) {
    const Image<Rgb> c = ShiftedRight(Stops()), t = Stops();
    HdrFlipOptions options{.curve = ToneCurve::kHable};
    const HdrFlip whole = HdrFlipMap(c, t, {}, options);
    std::vector<double> worst(t.Pixels().size(), 0);
    for (int k = 0; k < whole.exposures.count; ++k) {
        const double stops = whole.exposures.At(k);
        options.exposures =
            ToneExposures{.start_stops = stops, .stop_stops = stops, .count = 2};
        const HdrFlip one = HdrFlipMap(c, t, {}, options);
        for (std::size_t p = 0; p < worst.size(); ++p) {
            EXPECT_LE(one.map.Pixels()[p], whole.map.Pixels()[p]);
            worst[p] = std::max(worst[p], double(one.map.Pixels()[p]));
        }
    }
    for (std::size_t p = 0; p < worst.size(); ++p) EXPECT_EQ(worst[p], whole.map.Pixels()[p]);
}

}  // namespace
}  // namespace plumb
