// The metrics of adaptive supersampling: by hand, at their limits, and where the print fails.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/parallel.h"
#include "screen_space/antialiasing/sample_count.h"
#include "screen_space/gbuffer.h"
#include "tests/antialiasing/made_pictures.h"

namespace plumb {
namespace {

double Variance(MetricForm form, const std::vector<float>& d) {
    return WindowVariance(form, d);
}

// One of nine: 1/9 - 1/81 = 8/81.
TEST(WindowVariance, ByHand) {
    for (const MetricForm form : {MetricForm::kPrinted, MetricForm::kStable}) {
        EXPECT_EQ(Variance(form, {0, 0, 1, 1}), 0.25);
        EXPECT_EQ(Variance(form, {1, 1, 1, 2}), 0.1875);
        EXPECT_NEAR(Variance(form, {0, 0, 0, 0, 1, 0, 0, 0, 0}), 8.0 / 81, 1e-8);
        EXPECT_EQ(Variance(form, {0.3f}), 0);
    }
}

// Four depths 1 mm apart, 1 km away: 1.25e-6 (floats there are 6.1e-5 apart: each off by 3.05e-5 at
// most, so the variance by 2 * 3.05e-5 * 1.12e-3). Squares of 1000 in 32 bits are 1/16 apart, so as
// printed the answer is a multiple of that: here one of them, 50 000 times too much.
TEST(WindowVariance, CancelsAsPrintedAndNotInTheStableForm) {
    const std::vector<float> d{1000.000f, 1000.001f, 1000.002f, 1000.003f};
    EXPECT_NEAR(Variance(MetricForm::kStable, d), 1.25e-6, 7e-8);
    EXPECT_EQ(Variance(MetricForm::kPrinted, d), 0.0625);
}

TEST(EncodedDepth, ByHand) {
    DepthMetric metric{.near_m = 1, .far_m = 101};
    EXPECT_NEAR(EncodedDepth(metric, -2), 101.0 * 1 / (2 * 100), 1e-7);
    metric.encoding = DepthEncoding::kLinear;
    EXPECT_NEAR(EncodedDepth(metric, -2), 0.01, 1e-9);
    EXPECT_EQ(EncodedDepth(metric, -0.5f), 0);
    metric.bits = 8;  // 0.01 * 255 = 2.55
    EXPECT_NEAR(EncodedDepth(metric, -2), 3.0 / 255, 1e-9);
    metric = {.encoding = DepthEncoding::kMetres, .near_m = 1, .far_m = 101};
    EXPECT_EQ(EncodedDepth(metric, -2.5f), 2.5f);
    EXPECT_EQ(EncodedDepth(metric, GBuffer::kSkyZ), 101);
    EXPECT_EQ(EncodedDepth(metric, std::nanf("")), 101);
    metric.encoding = DepthEncoding::kDevice;
    EXPECT_EQ(EncodedDepth(metric, GBuffer::kSkyZ), 1);
}

// Two windows of m = 2: depths 1, 1, 2, 2 m (variance 1/4) and 3, 3, 3, 3.
TEST(DepthSamples, AreTheVarianceOfEachWindow) {
    Image<float> z(4, 2);
    z.Pixels() = {-1, -2, -3, -3,  //
                  -2, -1, -3, -3};
    const Image<float> k = DepthSamples(z, 2, {.c = 8, .encoding = DepthEncoding::kMetres});
    EXPECT_EQ(k.Pixels(), (std::vector<float>{2, 0}));
    z(0, 0) = z(1, 0) = z(0, 1) = z(1, 1) = GBuffer::kSkyZ;
    EXPECT_EQ(DepthSamples(z, 2, {}).Pixels(), (std::vector<float>{0, 0}));
}

const Vec3f kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1), kNone(0, 0, 0);

double Spread(const std::vector<Vec3f>& normals, MeanNormal mean,
              MetricForm form = MetricForm::kStable) {
    return NormalSpread(normals, mean, form);
}

// Two and two at right angles: n_mean = (1/2, 1/2, 0), <n_mean, n> = 1/2 or 1/sqrt(2).
// Three and one: n_mean = (3/4, 1/4, 0), the least is 1/4 or 1/sqrt(10).
TEST(NormalSpread, ByHand) {
    for (const MetricForm form : {MetricForm::kPrinted, MetricForm::kStable}) {
        EXPECT_NEAR(Spread({kX, kX, kY, kY}, MeanNormal::kRaw, form), std::sqrt(0.5), 1e-6);
        EXPECT_NEAR(Spread({kX, kX, kY, kY}, MeanNormal::kUnit, form),
                    std::sqrt(1 - std::sqrt(0.5)), 1e-6);
        EXPECT_NEAR(Spread({kX, kX, kX, kY}, MeanNormal::kRaw, form), std::sqrt(0.75), 1e-6);
        EXPECT_NEAR(Spread({kX, kX, kX, kY}, MeanNormal::kUnit, form),
                    std::sqrt(1 - 1 / std::sqrt(10.0)), 1e-6);
    }
}

// Opposite normals: the raw mean of two pairs is 0, so the spread is 1; its unit vector does not
// exist, and counts as no direction at all. Three against one: raw mean 1/2, so sqrt(1/2); unit mean
// nothing: |<n_mean, n>| = 1 for all.
TEST(NormalSpread, OppositeNormals) {
    const Vec3f back = -kZ;
    EXPECT_EQ(Spread({kZ, kZ, back, back}, MeanNormal::kRaw), 1);
    EXPECT_EQ(Spread({kZ, kZ, back, back}, MeanNormal::kUnit), 1);
    EXPECT_NEAR(Spread({kZ, kZ, kZ, back}, MeanNormal::kRaw), std::sqrt(0.5), 1e-9);
    EXPECT_EQ(Spread({kZ, kZ, kZ, back}, MeanNormal::kUnit), 0);
}

TEST(NormalSpread, SkyBesideASurfaceAndAlone) {
    for (const MeanNormal mean : {MeanNormal::kRaw, MeanNormal::kUnit}) {
        EXPECT_EQ(Spread({kNone, kNone, kNone, kNone}, mean), 0);
        EXPECT_EQ(Spread({kZ, kZ, kZ, kNone}, mean), 1);
    }
}

// (0.6, 0.64, 0.48) is a unit vector, but not in 8 bits a component: (203, 209, 189) of 255 are
// 0.5922, 0.6392, 0.4824, whose squared length is 0.99203. As printed four equal ones ask for
// sqrt(1 - 0.99203) c = 0.089 c; the stable form knows that they are equal.
TEST(NormalSpread, EqualNormalsOfEightBits) {
    const auto byte = [](double v) { return float(2 * v / 255 - 1); };
    const Vec3f n(byte(203), byte(209), byte(189));
    EXPECT_NEAR(Spread({n, n, n, n}, MeanNormal::kRaw, MetricForm::kPrinted),
                std::sqrt(1 - n.cast<double>().squaredNorm()), 1e-5);
    EXPECT_GT(Spread({n, n, n, n}, MeanNormal::kRaw, MetricForm::kPrinted), 0.08);
    EXPECT_EQ(Spread({n, n, n, n}, MeanNormal::kRaw, MetricForm::kStable), 0);
}

// The centre's neighbours are 0.9 above, the rest 0.1: r = 0.8, k = 16 * 0.8.
TEST(ShadingSamples, ByHand) {
    const Image<Rgb> S =
        GreyPicture(5, 5, [](int x, int y) { return x == 2 && y == 1 ? 0.9 : 0.1; });
    const Image<float> k = ShadingSamples(S, {});
    EXPECT_NEAR(k(2, 2), 12.8, 1e-5);
    EXPECT_NEAR(k(1, 1), 12.8, 1e-5);
    EXPECT_EQ(k(2, 1), 0);  // Its own four neighbours are equal.
    EXPECT_EQ(k(1, 2), 0);  // A corner's neighbour is none.
    const Image<float> with_centre =
        ShadingSamples(S, {.neighbours = ShadingNeighbours::kFourAndCentre});
    EXPECT_NEAR(with_centre(2, 1), 12.8, 1e-5);
}

// Luminance 0.25 beside 0.5: r = 0.25, below 0.5 t_edge only if t_edge > 1/2.
TEST(ShadingSamples, BothThresholds) {
    const Image<Rgb> S = GreyPicture(4, 1, [](int x, int) { return x < 2 ? 0.25 : 0.5; });
    ShadingMetric metric{.c = 4, .min_threshold = 0, .edge_threshold = 0.501};
    EXPECT_EQ(ShadingSamples(S, metric)(1, 0), 0);
    metric.edge_threshold = 0.499;
    EXPECT_NEAR(ShadingSamples(S, metric)(1, 0), 1, 1e-6);
    metric.min_threshold = 0.251;
    EXPECT_EQ(ShadingSamples(S, metric)(1, 0), 0);
}

// Green 0.5 and red 0.5 * 0.587/0.299 have one Rec. 601 luminance, not one of Rec. 709. sRGB of
// linear 0.5 is 0.7354 (IEC 61966-2-1: 1.055 * 0.5^(1/2.4) - 0.055).
TEST(ShadingSamples, WeightsAndEncoding) {
    Image<Rgb> S(2, 1, Rgb{0, 0.25f, 0});
    S(1, 0) = {0.25f * 0.587f / 0.299f, 0, 0};
    ShadingMetric metric{.min_threshold = 0.01, .weights = LumaWeights::kRec601};
    EXPECT_EQ(ShadingSamples(S, metric)(0, 0), 0);
    metric.weights = LumaWeights::kRec709;
    EXPECT_GT(ShadingSamples(S, metric)(0, 0), 0);
    const Image<Rgb> grey = GreyPicture(2, 1, [](int x, int) { return 0.5 * x; });
    EXPECT_NEAR(ShadingSamples(grey, {.encoding = LuminanceEncoding::kSrgb})(0, 0),
                16 * 0.735357, 1e-4);
}

TEST(WholeSamples, RoundsAndCounts) {
    using enum CountRounding;
    const auto whole = [](double k, CountRounding r,
                          FirstSample first = FirstSample::kIncluded) {
        return WholeSamples(k, 16, r, first);
    };
    EXPECT_EQ(whole(3.7, kDown), 3);
    EXPECT_EQ(whole(3.2, kUp), 4);
    EXPECT_EQ(whole(3.5, kNearest), 4);
    EXPECT_EQ(whole(3.49, kNearest), 3);
    EXPECT_EQ(whole(0, kNearest), 1);
    EXPECT_EQ(whole(0, kNearest, FirstSample::kBeside), 1);
    EXPECT_EQ(whole(3, kNearest, FirstSample::kBeside), 4);
    EXPECT_EQ(whole(15.9, kDown, FirstSample::kBeside), 16);
    EXPECT_EQ(whole(400, kDown), 16);
    EXPECT_EQ(whole(std::numeric_limits<double>::infinity(), kDown), 16);
    EXPECT_EQ(whole(std::nan(""), kUp), 16);
}

/// One pixel each where depth, normals, shading alone ask for samples; m = 2.
struct ThreePixels {
    Image<float> z{14, 2, -1.f};
    Image<Vec3f> normals{14, 2, kZ};
    Image<Rgb> S = GreyPicture(7, 1, [](int x, int) { return x == 5 ? 0.25 : 0.0; });

    ThreePixels() {
        z(0, 0) = z(0, 1) = -2;              // Variance 1/4.
        normals(4, 0) = normals(4, 1) = kX;  // Spread sqrt(1/2).
    }
    MetricInput Input() const { return {z, normals, S}; }
};

SampleMetrics ByHand() {
    SampleMetrics metrics;
    metrics.depth = {.c = 8, .encoding = DepthEncoding::kMetres};
    metrics.normals.c = 4 * std::sqrt(2);
    metrics.shading = {.c = 12};
    return metrics;
}

// k_d = 8/4 = 2, k_n = 4, k_s = 12/4 = 3 at both neighbours of the bright pixel, and at itself: in a
// picture of one row it is its own neighbour above and below.
TEST(SampleCounts, AreTheLargestOfTheMetrics) {
    using Counts = std::vector<std::uint8_t>;
    const ThreePixels made;
    SampleMetrics metrics = ByHand();
    EXPECT_EQ(SampleCounts(made.Input(), 2, metrics).Pixels(), (Counts{2, 1, 4, 1, 3, 3, 3}));
    metrics.use_normals = metrics.use_shading = false;
    EXPECT_EQ(SampleCounts(made.Input(), 2, metrics).Pixels(), (Counts{2, 1, 1, 1, 1, 1, 1}));
    metrics = ByHand();
    metrics.use_depth = metrics.use_shading = false;
    EXPECT_EQ(SampleCounts(made.Input(), 2, metrics).Pixels(), (Counts{1, 1, 4, 1, 1, 1, 1}));
    metrics = ByHand();
    metrics.use_depth = metrics.use_normals = false;
    EXPECT_EQ(SampleCounts(made.Input(), 2, metrics).Pixels(), (Counts{1, 1, 1, 1, 3, 3, 3}));
    metrics = ByHand();
    metrics.constants = MetricConstants::kShared;
    metrics.shared_c = 12;  // 3, 8.5, 3.
    EXPECT_EQ(SampleCounts(made.Input(), 2, metrics).Pixels(), (Counts{3, 1, 4, 1, 3, 3, 3}));
    EXPECT_EQ(SamplesUsed(SampleCounts(made.Input(), 2, ByHand()), 2), 17.0 / 28);
}

// However k is rounded: what does not vary asks for exactly nothing, and so does c = 0.
TEST(SampleCounts, ConstantInputAndZeroConstantsAskForOne) {
    const ThreePixels made;
    const Image<float> z(14, 2, -3.f);
    const Image<Vec3f> normals(14, 2, Vec3f(0.6f, 0, 0.8f));
    const Image<Rgb> S(7, 1, Rgb{0.4f, 0.5f, 0.6f});
    for (const CountRounding rounding :
         {CountRounding::kDown, CountRounding::kNearest, CountRounding::kUp}) {
        SampleMetrics metrics;
        metrics.rounding = rounding;
        EXPECT_EQ(SamplesUsed(SampleCounts({z, normals, S}, 2, metrics), 2), 0.25);
        metrics.constants = MetricConstants::kShared;
        metrics.shared_c = 0;
        EXPECT_EQ(SamplesUsed(SampleCounts(made.Input(), 2, metrics), 2), 0.25);
    }
}

TEST(SampleCounts, AreTheSameOnAnyNumberOfThreads) {
    const int m = 4, W = 31, H = 23;
    Image<float> z(W * m, H * m);
    Image<Vec3f> normals(W * m, H * m, kZ);
    const Image<Rgb> noise = NoisePicture(W * m, H * m, 1);
    for (std::size_t i = 0; i < z.Pixels().size(); ++i) {
        z.Pixels()[i] = -1 - 10 * noise.Pixels()[i][0];
        normals.Pixels()[i] = Vec3f(noise.Pixels()[i][1], noise.Pixels()[i][2], 2).normalized();
    }
    const Image<Rgb> S = NoisePicture(W, H, 2);
    SetThreadCount(1);
    const Image<std::uint8_t> one = SampleCounts({z, normals, S}, m, {});
    SetThreadCount(4);
    EXPECT_EQ(SampleCounts({z, normals, S}, m, {}), one);
    SetThreadCount(0);
}

TEST(SampleCounts, OfEmptyPicturesAreEmpty) {
    EXPECT_TRUE(SampleCounts({Image<float>(), Image<Vec3f>(), Image<Rgb>()}, 4, {}).Empty());
    EXPECT_TRUE(std::isnan(SamplesUsed(Image<std::uint8_t>(), 4)));
}

template <class Call>
std::string Complaint(const Call& call) {
    try {
        call();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(SampleMetrics, AreChecked) {
    const ThreePixels made;
    const auto with = [&](auto change) {
        SampleMetrics metrics;
        change(metrics);
        return Complaint([&] { Validate(metrics); });
    };
    EXPECT_EQ(with([](SampleMetrics&) {}), "");
    EXPECT_EQ(with([](SampleMetrics& m) { m.depth.c = -1; }),
              "DepthMetric::c = -1, must be finite and not negative");
    EXPECT_EQ(with([](SampleMetrics& m) { m.depth.far_m = 0.05; }),
              "DepthMetric::far_m = 0.05, must be finite and > near_m");
    EXPECT_EQ(with([](SampleMetrics& m) { m.depth.near_m = 0; }),
              "DepthMetric::near_m = 0, must be finite and > 0");
    EXPECT_EQ(with([](SampleMetrics& m) { m.depth.bits = 25; }),
              "DepthMetric::bits = 25, must be in [0, 24], and 0 for depths in metres");
    EXPECT_EQ(with([](SampleMetrics& m) { m.normals.c = std::nan(""); }),
              "NormalMetric::c = nan, must be finite and not negative");
    EXPECT_EQ(with([](SampleMetrics& m) { m.shading.c = HUGE_VAL; }),
              "ShadingMetric::c = inf, must be finite and not negative");
    EXPECT_EQ(with([](SampleMetrics& m) { m.shading.min_threshold = -1; }),
              "ShadingMetric::min_threshold = -1, must be finite and not negative");
    EXPECT_EQ(with([](SampleMetrics& m) { m.shared_c = -2; }),
              "SampleMetrics::shared_c = -2, must be finite and not negative");
    EXPECT_EQ(Complaint([&] { SampleCounts(made.Input(), 0, {}); }),
              "enlargement m = 0, must be in [1, 8]");
    EXPECT_EQ(Complaint([&] { SampleCounts(made.Input(), 9, {}); }),
              "enlargement m = 9, must be in [1, 8]");
    EXPECT_EQ(Complaint([&] { SampleCounts(made.Input(), 4, {}); }),
              "size of the enlarged depths = 14 x 2, must be a multiple of m = 4");
    EXPECT_EQ(Complaint([&] { SampleCounts(made.Input(), 1, {}); }),
              "size of the enlarged depths = 14 x 2, must be m = 1 times that of the picture, "
              "7 x 1");
}

}  // namespace
}  // namespace plumb
