// What follows the taps: quads, packing, bilateral passes, against published values and by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "core/error.h"
#include "core/random.h"
#include "screen_space/gbuffer.h"
#include "screen_space/sao/bilateral_blur.h"
#include "screen_space/sao/pack_ao_z.h"
#include "screen_space/sao/quad_filter.h"
#include "tests/screen_space/made_gbuffers.h"

namespace plumb {
namespace {

Image<float> Noise(int width, int height, std::uint64_t seed) {
    Image<float> noise(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            noise(x, y) = float(RandomUnit(seed, std::uint64_t(y * width + x), 0, 0));
        }
    }
    return noise;
}

// All four pixels get the mean of the quad; of multiples of 1/64 it is exact in float.
TEST(QuadFilter, GivesAFlatQuadItsMeanExactly) {
    Image<float> A(4, 2);
    A.Pixels() = {0.25f, 0.5f, 1.0f, 0.0f,  //
                  0.75f, 0.0f, 0.5f, 0.125f};
    const Image<float> z(4, 2, -3.0f);
    const Image<float> filtered = QuadFiltered(A, z, kQuadThresholdM, {0, 0, 4, 2});
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 4; ++x) {
            EXPECT_EQ(filtered(x, y), x < 2 ? 1.5f / 4 : 1.625f / 4) << x << " " << y;
        }
    }
}

// Along x the pairs are cut by a step of 0.03 m, along y they are not; and the sky stays out.
TEST(QuadFilter, StopsAtAStepAndAtTheSky) {
    Image<float> A(4, 2);
    A.Pixels() = {0.25f, 0.5f, 1.0f, 0.0f,  //
                  0.75f, 0.0f, 0.5f, 0.125f};
    Image<float> z(4, 2, -3.0f);
    z(1, 0) = z(1, 1) = -3.03f;
    z(3, 0) = z(3, 1) = GBuffer::kSkyZ;
    const Image<float> filtered = QuadFiltered(A, z, kQuadThresholdM, {0, 0, 4, 2});
    EXPECT_EQ(filtered.Pixels(), (std::vector<float>{0.5f, 0.25f, 0.75f, 0.0f,  //
                                                     0.5f, 0.25f, 0.75f, 0.125f}));
    const Image<float> wider = QuadFiltered(A, z, 0.04, {0, 0, 4, 2});
    EXPECT_EQ(wider(0, 0), 0.375f);
}

TEST(QuadFilter, LeavesPixelsWithoutAPartnerAndBeyondTheRect) {
    const Image<float> A = Noise(5, 5, 3), z(5, 5, -3.0f);
    const Image<float> filtered = QuadFiltered(A, z, kQuadThresholdM, {0, 0, 5, 5});
    EXPECT_EQ(filtered(4, 4), A(4, 4));
    EXPECT_FLOAT_EQ(filtered(4, 0), (A(4, 0) + A(4, 1)) / 2);
    EXPECT_FLOAT_EQ(filtered(1, 4), (A(0, 4) + A(1, 4)) / 2);
    const Image<float> part = QuadFiltered(A, z, kQuadThresholdM, {2, 2, 4, 4});
    EXPECT_EQ(part(0, 0), A(0, 0));
    EXPECT_NE(part(2, 2), A(2, 2));
    const Image<float> one(1, 1, 0.5f);
    EXPECT_EQ(QuadFiltered(one, Image<float>(1, 1, -1.0f), 0.02, {0, 0, 1, 1}), one);
}

// Linear data: the mean of a quad of a plane A = a x + b y + c is its value at the quad's middle.
TEST(QuadFilter, IsExactOnLinearData) {
    Image<float> A(8, 6);
    for (int y = 0; y < 6; ++y) {
        for (int x = 0; x < 8; ++x) A(x, y) = float(4 + 3 * x + 5 * y) / 128;
    }
    const Image<float> filtered =
        QuadFiltered(A, Image<float>(8, 6, -1.0f), 0.02, {0, 0, 8, 6});
    for (int y = 0; y < 6; ++y) {
        for (int x = 0; x < 8; ++x) {
            const double middle_x = x / 2 * 2 + 0.5, middle_y = y / 2 * 2 + 0.5;
            EXPECT_EQ(filtered(x, y), (4 + 3 * middle_x + 5 * middle_y) / 128);
        }
    }
}

TEST(PackAoZ, KnownBytes) {
    EXPECT_EQ(PackAoZ(1.0, 0.5), (PackedAoZ{255, 128, 0}));
    EXPECT_EQ(PackAoZ(0.5, 0.75), (PackedAoZ{128, 191, 0}));
    EXPECT_EQ(PackAoZ(0.0, 1.0), (PackedAoZ{0, 255, 0}));
    EXPECT_EQ(PackAoZ(0.0, 0.0), (PackedAoZ{0, 0, 0}));
    EXPECT_NEAR(UnpackKey<double>(PackAoZ(0.0, 0.5)), 0.5000076, 5e-8);
    EXPECT_NEAR(UnpackKey<double>(PackAoZ(0.0, 0.75)), 0.7461051, 5e-8);
    EXPECT_DOUBLE_EQ(UnpackA<double>(PackAoZ(0.2, 0.0)), 51 / 255.0);
}

TEST(PackAoZ, TheSkyIsNotRecognizedAgain) {
    EXPECT_EQ(DepthKey(GBuffer::kSkyZ, -300), 1);
    EXPECT_NEAR(UnpackKey<double>(PackAoZ(1.0, 1.0)), 0.9961089, 5e-8);
}

// The one seam: at k = 129/256 = 0.50390625 the key falls from 0.50390 to 0.50001. Steps of 2^-20,
// 16 times as fine as two bytes can tell apart.
TEST(PackAoZ, HasExactlyOneSeam) {
    int falls = 0;
    double before = 0;
    for (int i = 0; i < 1 << 20; ++i) {
        const double key = UnpackKey<double>(PackAoZ(0.0, std::ldexp(i, -20)));
        if (key < before - 1e-9) {
            ++falls;
            EXPECT_EQ(i, 129 << 12);
            EXPECT_NEAR(before, 0.50390, 5e-6);
            EXPECT_NEAR(key, 0.50001, 5e-6);
        }
        before = key;
    }
    EXPECT_EQ(falls, 1);
}

// float and double may store neighbouring bytes only where 255 fract(256 k) + 1/2 is whole to
// within float's rounding: |difference| <= 1/255/257 then.
TEST(PackAoZ, FloatFollowsDouble) {
    for (int i = 0; i < 10000; ++i) {
        const double key = RandomUnit(1, std::uint64_t(i), 0, 0);
        const double in_float = double(UnpackKey<float>(PackAoZ(0.0f, float(key))));
        EXPECT_NEAR(in_float, UnpackKey<double>(PackAoZ(0.0, double(float(key)))),
                    1.01 / 255 / 257);
    }
}

BlurGuide FlatGuide(int width, int height, float key = 0.25f) {
    return {.key = Image<float>(width, height, key),
            .view = MadeView(width, height),
            .z_min_m = -300};
}

// A constant does not stay constant: 1e-4 is added to the weights' sum. Known to 10 digits, cut off.
TEST(BilateralBlur, AConstantAfterOneAndBothAxes) {
    struct Row {
        BlurKernel kernel;
        int R;
        double one_axis, both;
    };
    const Image<float> ones(64, 64, 1.0f);
    const BlurGuide guide = FlatGuide(64, 64);
    for (const Row& row : {Row{kBlurStddev2, 4, 0.9999705890, 0.9999411790},
                           Row{kBlurR3, 3, 0.9999642870, 0.9999285753},
                           Row{kBlurStddev3, 6, 0.9999782613, 0.9999565231}}) {
        const BlurOptions options{.kernel = row.kernel, .taps_each_side = row.R};
        EXPECT_NEAR(BlurredPixel(BlurAxis::kX, ones, guide, options, 32, 32), row.one_axis,
                    1.01e-10);
        const Image<float> x = BlurredAlong(BlurAxis::kX, ones, guide, options, {0, 0, 64, 64});
        const Image<float> xy = BlurredAlong(BlurAxis::kY, x, guide, options, {0, 0, 64, 64});
        // In float: two passes of 13 taps, each with a rounding of 6e-8.
        EXPECT_NEAR(xy(32, 32), row.both, 2 * 13 * 6e-8);
    }
}

// R = 4: of a lone 1 the centre keeps 0.153170 / 3.4001 = 4.5 %, the next taps get 13.1 %.
TEST(BilateralBlur, ShippedWeightsAreNoGaussian) {
    Image<float> A(64, 64, 0.0f);
    A(32, 32) = 1;
    const BlurGuide guide = FlatGuide(64, 64);
    const BlurOptions options;
    const double W =
        0.153170 + 2 * (4 * 0.3 + 0.144893 + 0.122649 + 0.092902 + 0.062970) + 1e-4;
    for (const BlurAxis axis : {BlurAxis::kX, BlurAxis::kY}) {
        const auto at = [&](int along) {
            return axis == BlurAxis::kX ? BlurredPixel(axis, A, guide, options, 32 + along, 32)
                                        : BlurredPixel(axis, A, guide, options, 32, 32 + along);
        };
        EXPECT_NEAR(at(0), 0.153170 / W, 1e-12);
        EXPECT_NEAR(at(0), 0.045, 5e-4);
        EXPECT_NEAR(at(2), 0.444893 / W, 1e-12);
        EXPECT_NEAR(at(-2), 0.131, 5e-4);
        EXPECT_NEAR(at(8), 0.362970 / W, 1e-12);
        EXPECT_EQ(at(1), 0);
        EXPECT_EQ(at(10), 0);
    }
}

// The paper's: a Gaussian of 7 taps 3 px apart, nothing added.
TEST(BilateralBlur, PaperWeightsAreTheGaussian) {
    Image<float> A(64, 64, 0.0f);
    A(32, 32) = 1;
    const BlurOptions options{.kernel = kBlurR3,
                              .taps_each_side = 3,
                              .stride_px = 3,
                              .lift = 0,
                              .edge_sharpness = 2048,
                              .tiny = 0};
    const double W = 0.356642 + 2 * (0.239400 + 0.072410 + 0.009869);
    const BlurGuide guide = FlatGuide(64, 64);
    EXPECT_NEAR(BlurredPixel(BlurAxis::kX, A, guide, options, 32, 32), 0.356642 / W, 1e-12);
    EXPECT_NEAR(BlurredPixel(BlurAxis::kX, A, guide, options, 26, 32), 0.072410 / W, 1e-12);
    EXPECT_NEAR(BlurredPixel(BlurAxis::kX, A, guide, options, 41, 32), 0.009869 / W, 1e-12);
}

/// A step of depth at x = 16; A = 0 to the left, 1 to the right. A at x = 15 after the filter.
double AcrossAStep(double step_m, double z_min_m, double sharpness) {
    Image<float> A(32, 1, 0.0f);
    BlurGuide guide = FlatGuide(32, 1);
    guide.z_min_m = z_min_m;
    for (int x = 0; x < 32; ++x) {
        if (x >= 16) A(x, 0) = 1;
        guide.key(x, 0) = float(DepthKey(x < 16 ? -10 : -10 - step_m, z_min_m));
    }
    const BlurOptions options{.edge_sharpness = sharpness};
    return BlurredPixel(BlurAxis::kX, A, guide, options, 14, 0);
}

// Shipped: 300 / 2000 = 0.15 m. Paper: 200 / 2^11 = 0.0977 m.
TEST(BilateralBlur, CutsOffAtItsDepthDifference) {
    EXPECT_GT(AcrossAStep(0.149, -300, 2000), 0);
    EXPECT_EQ(AcrossAStep(0.151, -300, 2000), 0);
    EXPECT_GT(AcrossAStep(0.097, -200, 2048), 0);
    EXPECT_EQ(AcrossAStep(0.098, -200, 2048), 0);
    // Half the cut-off: half the weight for the taps beyond the step, 2, 4, 6 and 8 px away.
    const double far_side = 0.5 * (4 * 0.3 + 0.144893 + 0.122649 + 0.092902 + 0.062970);
    const double near_side = 0.153170 + 2 * far_side;
    EXPECT_NEAR(AcrossAStep(0.075, -300, 2000), far_side / (far_side + near_side + 1e-4),
                1e-4);  // keys are floats: 2000 x 3e-8 of 1/2
}

// A rounded key of the packed picture falls at z = -151.2 m of -300: a filter stops there.
TEST(BilateralBlur, SeesAnEdgeAtTheSeamOfThePackedKey) {
    Image<float> A(32, 1, 0.0f);
    BlurGuide packed = FlatGuide(32, 1), plain = packed;
    for (int x = 0; x < 32; ++x) {
        if (x >= 16) A(x, 0) = 1;
        const double key = DepthKey(-300 * (129 / 256.0) - 1e-4 * (x - 15.5), -300);
        plain.key(x, 0) = float(key);
        packed.key(x, 0) = float(UnpackKey<double>(PackAoZ(0.0, key)));
    }
    EXPECT_GT(BlurredPixel(BlurAxis::kX, A, plain, {}, 14, 0), 0.4);
    EXPECT_EQ(BlurredPixel(BlurAxis::kX, A, packed, {}, 14, 0), 0);
}

// Keys that go away by a step and come back: plainly the far side has its weight again, of monotonic
// weights nothing beyond the step counts.
TEST(BilateralBlur, MonotonicWeightsDoNotComeBack) {
    Image<float> A(32, 1, 0.0f);
    A(20, 0) = 1;
    BlurGuide guide = FlatGuide(32, 1);
    guide.key(18, 0) = 0.3f;
    BlurOptions options{.tiny = 0};
    const double W = 0.153170 + 2 * (4 * 0.3 + 0.144893 + 0.122649 + 0.092902 + 0.062970);
    const double step = 0.3 + 0.144893, far = 0.3 + 0.122649;
    EXPECT_NEAR(BlurredPixel(BlurAxis::kX, A, guide, options, 16, 0), far / (W - step), 1e-12);
    options.monotonic = true;
    EXPECT_EQ(BlurredPixel(BlurAxis::kX, A, guide, options, 16, 0), 0);
    EXPECT_GT(BlurredPixel(BlurAxis::kX, A, guide, options, 26, 0), 0);
}

TEST(BilateralBlur, LeavesTheSkyAndReadsNothingBeyondThePicture) {
    const Image<float> A = Noise(9, 9, 5);
    BlurGuide guide = FlatGuide(9, 9, 1.0f);
    EXPECT_EQ(BlurredPixel(BlurAxis::kX, A, guide, {}, 4, 4), double(A(4, 4)));
    guide = FlatGuide(9, 9);
    const BlurOptions options{.tiny = 0};
    const double g[5] = {0.153170, 0.444893, 0.422649, 0.392902, 0.362970};
    double sum = 0, W = 0;
    for (int k = 0; k < 5; ++k) {
        sum += g[k] * A(2 * k, 3);
        W += g[k];
    }
    EXPECT_NEAR(BlurredPixel(BlurAxis::kX, A, guide, options, 0, 3), sum / W, 1e-12);
    const Image<float> one(1, 1, 0.5f);
    EXPECT_EQ(BlurredPixel(BlurAxis::kY, one, FlatGuide(1, 1), options, 0, 0), 0.5);
}

// Two normals 60 degrees apart weigh 1/2. Points 8 m apart and off the plane by 1/4 of the
// distance: (1 - 2 / 4)^2.
TEST(BilateralBlur, NormalAndPlaneWeights) {
    const int size = 3;
    Image<float> A(size, 1, 0.0f);
    A(2, 0) = 1;
    BlurGuide guide = FlatGuide(size, 1, 0.01f);
    Image<Vec3f> normal(size, 1, Vec3f(0, 0, 1));
    guide.normal = &normal;
    normal(2, 0) = Vec3f(std::sqrt(0.75f), 0, 0.5f);
    BlurOptions options{.taps_each_side = 1, .tiny = 0, .normal_weight = true};
    const double g0 = options.kernel[0], g1 = 0.3 + options.kernel[1];
    EXPECT_NEAR(BlurredPixel(BlurAxis::kX, A, guide, options, 0, 0), 0.5 * g1 / (g0 + 0.5 * g1),
                1e-6);

    options = {.taps_each_side = 1, .edge_sharpness = 0, .tiny = 0, .plane_weight = true};
    normal(2, 0) = Vec3f(0, 0, 1);
    // Both at z = -3: in the plane, full weight.
    EXPECT_NEAR(BlurredPixel(BlurAxis::kX, A, guide, options, 0, 0), g1 / (g0 + g1), 1e-6);
    // Tilted about y so that the plane is missed by 1/4 of the distance along x.
    normal(0, 0) = normal(2, 0) = Vec3f(0.25f, 0, std::sqrt(1 - 0.0625f));
    EXPECT_NEAR(BlurredPixel(BlurAxis::kX, A, guide, options, 0, 0),
                0.25 * g1 / (g0 + 0.25 * g1), 1e-6);
    options.near_m2 = 1e9;  // too near to tell
    EXPECT_NEAR(BlurredPixel(BlurAxis::kX, A, guide, options, 0, 0), g1 / (g0 + g1), 1e-6);
}

// The picture in float against the pixel in double. Tolerance: a weight of up to 1.3 carries the
// rounding of 1 - e |key - key'|, 6e-8 each; the plane's weight that of points, 1e-6 of a distance
// that is at least 0.03 m: 2 x 2 x 1e-6 / 0.03.
TEST(BlurredAlong, IsTheReferenceForEveryOption) {
    const int width = 77, height = 45;
    const View view = MadeView(width, height);
    const GBuffer g = MadeGBuffer(
        view, Union(MadePlane({0.1, 1, 0.2}, -1), MadeSphere({0.4, -0.3, -4}, 0.5)));
    const Image<float> A = Noise(width, height, 9);
    BlurGuide guide{.key = Image<float>(width, height),
                    .normal = &g.face_normal,
                    .view = view,
                    .z_min_m = -20};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            guide.key(x, y) = float(DepthKey(g.z_m(x, y), guide.z_min_m));
        }
    }
    for (const auto& [R, stride, sharpness] :
         {std::tuple{4, 2, 100.0}, {3, 3, 20.0}, {6, 1, 0.0}, {1, 64, 0.0}, {6, 7, 5.0}}) {
        for (const int weights : {0, 1, 2, 3}) {
            const BlurOptions options{.kernel = kBlurStddev3,
                                      .taps_each_side = R,
                                      .stride_px = stride,
                                      .edge_sharpness = sharpness,
                                      .normal_weight = (weights & 1) != 0,
                                      .plane_weight = (weights & 2) != 0,
                                      .monotonic = R % 2 == 0};
            for (const BlurAxis axis : {BlurAxis::kX, BlurAxis::kY}) {
                const PixelRect where{2, 4, width - 3, height};
                const Image<float> blurred = BlurredAlong(axis, A, guide, options, where);
                double change = 0;
                for (int y = 0; y < height; ++y) {
                    for (int x = 0; x < width; ++x) {
                        const double expected =
                            where.Contains(x, y) ? BlurredPixel(axis, A, guide, options, x, y)
                                                 : A(x, y);
                        ASSERT_NEAR(blurred(x, y), expected, weights < 2 ? 2e-6 : 2e-4)
                            << R << " " << x << " " << y;
                        change = std::max(change, std::abs(expected - A(x, y)));
                    }
                }
                EXPECT_GT(change, R == 1 ? 0.0 : 0.1);
            }
        }
    }
}

TEST(BlurOptions, BadValuesAreNamed) {
    try {
        Validate(BlurOptions{.stride_px = 0});
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "BlurOptions::stride_px = 0, must be in [1, 64]");
    }
    EXPECT_THROW(Validate(BlurOptions{.taps_each_side = 7}), Error);
    EXPECT_THROW(Validate(BlurOptions{.edge_sharpness = std::nan("")}), Error);
}

}  // namespace
}  // namespace plumb
