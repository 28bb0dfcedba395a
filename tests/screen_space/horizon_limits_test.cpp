// What holds of HBAO, GTAO and the bitmask in every case, and what they do with bad input.
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "core/statistics.h"
#include "tests/screen_space/horizon_scenes.h"

namespace plumb {
namespace {

/// Every technique, as published and in its other forms, with one sampling.
std::vector<std::function<Image<float>(const GBuffer&, const SliceSampling&)>> Techniques(
    double thickness_m = 0.5) {
    const auto bitmask = [thickness_m](SectorMeasure measure, SectorRounding rounding) {
        return [=](const GBuffer& g, const SliceSampling& s) {
            return VisibilityBitmask(g, {.sampling = s,
                                         .thickness_m = thickness_m,
                                         .measure = measure,
                                         .rounding = rounding,
                                         .normalize = true});
        };
    };
    return {[](const GBuffer& g, const SliceSampling& s) {
                return Hbao(g, {.sampling = s, .bias_rad = 0.1});
            },
            [](const GBuffer& g, const SliceSampling& s) {
                return Gtao(g, {.sampling = s, .thickness_blend = 0.1, .normalize = true});
            },
            bitmask(SectorMeasure::kUniform, SectorRounding::kCeil),
            bitmask(SectorMeasure::kCosine, SectorRounding::kRound)};
}

GBuffer Mixed(int side, double scale = 1) {
    const MadeShape shape =
        Union(MadeSphereOverPlane(),
              MadePlane({0, 1, 0.2}, -1, [](const Vec3& P) { return P.x() < 0; }));
    return MadeGBuffer(MadeView(side, side), [=](const Vec3& w) {
        MadeHit hit = shape(w);
        if (w.y() > 0.4) hit = {};  // A strip of sky.
        hit.depth *= scale;
        return hit;
    });
}

double Sum(const Image<float>& image) {
    double sum = 0;
    for (float A : image.Pixels()) sum += A;
    return sum;
}

bool AllWithin01(const Image<float>& image) {
    for (float A : image.Pixels())
        if (!(A >= 0 && A <= 1.000001f)) return false;
    return true;
}

TEST(HorizonMethods, SameBitsOnOneThreadAndTwo) {
    const GBuffer g = Mixed(60);
    for (const auto& technique : Techniques()) {
        SetThreadCount(1);
        const Image<float> one = technique(g, {.radius_m = 3});
        SetThreadCount(2);
        const Image<float> two = technique(g, {.radius_m = 3});
        SetThreadCount(0);
        EXPECT_EQ(one, two);
        EXPECT_TRUE(AllWithin01(one));
        EXPECT_LT(Sum(one), 0.98 * 60 * 60);  // Something is hidden.
    }
}

// Whatever the width of the machine's vectors: each kind that this one has, against its best.
TEST(HorizonMethods, SameBitsOnEveryKindOfMachine) {
    const GBuffer g = Mixed(45);  // No multiple of any width.
    const auto pictures = [&] {
        std::vector<Image<float>> all;
        for (const auto& technique : Techniques()) all.push_back(technique(g, {.radius_m = 2}));
        return all;
    };
    const std::vector<Image<float>> best = pictures();
    int kinds = 0;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        EXPECT_EQ(pictures(), best) << hwy::TargetName(target);
        ++kinds;
    }
    hwy::SetSupportedTargetsForTest(0);
    EXPECT_GE(kinds, 1);
}

// A part of the picture is that part of the whole picture; elsewhere nothing is computed.
TEST(HorizonMethods, ComputeThePartAskedFor) {
    const GBuffer g = Mixed(50);
    const PixelRect where{11, 7, 40, 33};
    const SliceSampling s{.radius_m = 2};
    const BitmaskOptions fine{.sampling = s, .sectors = 64};
    const std::pair<Image<float>, Image<float>> wholes_and_parts[] = {
        {Hbao(g, {.sampling = s}), Hbao(g, {.sampling = s}, where)},
        {Gtao(g, {.sampling = s}), Gtao(g, {.sampling = s}, where)},
        {VisibilityBitmask(g, {.sampling = s}), VisibilityBitmask(g, {.sampling = s}, where)},
        {VisibilityBitmask(g, fine), VisibilityBitmask(g, fine, where)}};
    for (const auto& [whole, part] : wholes_and_parts) {
        for (int j = 0; j < 50; ++j)
            for (int i = 0; i < 50; ++i)
                EXPECT_EQ(part(i, j), where.Contains(i, j) ? whole(i, j) : 1) << i << ' ' << j;
    }
}

TEST(HorizonMethods, SkyIsOne) {
    const GBuffer g = Mixed(40);
    for (const auto& technique : Techniques()) {
        const Image<float> A = technique(g, {});
        for (int i = 0; i < 40; ++i) {
            ASSERT_FALSE(std::isfinite(g.z_m(i, 0)));
            EXPECT_EQ(A(i, 0), 1);
        }
    }
}

// No length is built in: a scene in centimetres, lengths of the options too, gives the same
// picture. Tolerance: z in float rounds otherwise by up to 2^-24 of 5 m, over a pixel of 0.1
// m, which turns angles by 3e-6; and a sample may change sides of the radius, or of a sector.
TEST(HorizonMethods, DoNotKnowTheUnit) {
    const GBuffer metres = Mixed(50), centimetres = Mixed(50, 128);
    for (int k = 0; k < 4; ++k) {
        const Image<float> a = Techniques()[k](metres, {.radius_m = 1.3});
        const Image<float> b = Techniques(0.5 * 128)[k](centimetres, {.radius_m = 1.3 * 128});
        EXPECT_EQ(a, b);  // 128 = 2^7: exact in binary.
    }
}

TEST(HorizonMethods, RadiusEndsWhatIsSeen) {
    const GBuffer g = MadeGBuffer(MadeView(60, 60), MadeSphereOverPlane());
    // At the corners the nearest of the sphere is more than 2 m away.
    for (const auto& technique : Techniques()) {
        const Image<float> near = technique(g, {.radius_m = 1}),
                           far = technique(g, {.radius_m = 5});
        EXPECT_LT(Sum(far), Sum(near));
        EXPECT_GT(near(1, 1), 0.93f);  // As open as ceil lets a plane be.
    }
}

// The picture, in float and many pixels at once, against the reference, in double and one by
// one. Expected: equal but where a sample's place or a sector's end comes within rounding of
// the next: of some 40 samples a pixel a share of the order of 1e-5 each, so one pixel in 100
// at most. Elsewhere angles are off by the float's rounding of cosines near 1, sqrt(2 2^-24) =
// 3.5e-4, of few samples: taken as 1e-3.
void ExpectAgrees(const GBuffer& g, const Image<float>& picture,
                  const std::function<double(int, int)>& reference, double share) {
    int apart = 0, pixels = 0;
    double sum = 0;
    for (int j = 0; j < picture.Height(); ++j) {
        for (int i = 0; i < picture.Width(); ++i) {
            if (!std::isfinite(g.z_m(i, j))) continue;
            const double off = picture(i, j) - reference(i, j);
            ++pixels;
            apart += std::abs(off) > 1e-3;
            sum += off;
        }
    }
    EXPECT_LE(apart, share * pixels);
    EXPECT_NEAR(sum / pixels, 0, 1e-3);
}

TEST(PeersPicture, AgreesWithTheReference) {
    const GBuffer g = Mixed(53);
    for (const SliceSpread spread : {SliceSpread::kScreen, SliceSpread::kLineOfSight}) {
        for (const double power : {1.0, 2.0, 1.5}) {
            const SliceSampling s{
                .radius_m = 2, .slices = 3, .steps = 7, .step_power = power, .spread = spread};
            const HbaoOptions hbao{.sampling = s, .bias_rad = 0.1};
            const auto of_hbao = [&](int i, int j) { return HbaoOfPixel(g, hbao, i, j); };
            ExpectAgrees(g, Hbao(g, hbao), of_hbao, 0.01);
            for (const bool normalize : {false, true}) {
                const GtaoOptions gtao{
                    .sampling = s, .thickness_blend = 0.2 * normalize, .normalize = normalize};
                ExpectAgrees(
                    g, Gtao(g, gtao), [&](int i, int j) { return GtaoOfPixel(g, gtao, i, j); },
                    0.01);
                const GtaoOptions other{.sampling = s,
                                        .fade = HorizonFade::kBehind,
                                        .length_lift = 0.05,
                                        .power = 2.2,
                                        .least = 0.03,
                                        .normalize = normalize};
                ExpectAgrees(
                    g, Gtao(g, other),
                    [&](int i, int j) { return GtaoOfPixel(g, other, i, j); }, 0.01);
                const BitmaskOptions mask{
                    .sampling = s,
                    .measure = normalize ? SectorMeasure::kCosine : SectorMeasure::kUniform,
                    .rounding = SectorRounding::kRound,
                    .normalize = normalize};
                const auto of_mask = [&](int i, int j) {
                    return VisibilityBitmaskOfPixel(g, mask, i, j);
                };
                ExpectAgrees(g, VisibilityBitmask(g, mask), of_mask, 0.01);
            }
        }
    }
}

// Jitter turns slices so that the published mean of an open, tilted plane is 1 over many
// pixels.
TEST(Gtao, OneSliceIsUnbiasedOverItsTurns) {
    const Vec3 n = Vec3(1, 0.4, 1).normalized();
    const GBuffer g = MadeGBuffer(MadeView(80, 80, 0.05), MadePlane(n, n.dot(Vec3(0, 0, -5))));
    const Image<float> A = Gtao(g, {.sampling = {.radius_m = 0.1, .slices = 1, .steps = 2}});
    Moments moments;
    for (float a : A.Pixels()) moments.Add(a);
    EXPECT_NEAR(moments.Mean(), 1, 4 * moments.StandardError());
    EXPECT_GT(moments.Variance(), 0.01);
}

TEST(HorizonMethods, NeverGiveNanWhateverTheDepths) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    GBuffer g =
        Mixed(33);  // Odd: the rays of the middle column have x = 0, and 0 times infinity.
    int k = 0;
    for (const float z : {kNan, 0.0f, 1.0f, -1e-30f, -3e38f,
                          std::numeric_limits<float>::infinity(), GBuffer::kSkyZ})
        g.z_m(5 + 3 * k++, 16) = z;
    g.face_normal(20, 20) = Vec3f(kNan, 0, 1);
    g.face_normal(22, 20) = Vec3f(0, 0, 0);
    g.face_normal(24, 20) = Vec3f(1, 0, -0.1f);  // Away from the eye.
    for (const auto& technique : Techniques()) {
        for (const double radius : {1e-4, 1.0, 1e6}) {
            EXPECT_TRUE(AllWithin01(technique(g, {.radius_m = radius}))) << radius;
        }
    }
}

TEST(HorizonMethods, OnePixelAndAWallAtTheEye) {
    const GBuffer pixel = MadeGBuffer(MadeView(1, 1), MadePlane({0.5, 0, 1}, -2));
    const GBuffer at_eye = MadeGBuffer(MadeView(16, 16), MadePlane({0.5, 0, 1}, -1e-4));
    for (const auto& technique : Techniques()) {
        EXPECT_NEAR(technique(pixel, {})(0, 0), 1, 1e-6);
        EXPECT_TRUE(AllWithin01(technique(at_eye, {})));
    }
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

TEST(HorizonMethods, ValidateTheirOptions) {
    const GBuffer g = Mixed(4);
    EXPECT_EQ(MessageOf([&] { Hbao(g, {.sampling = {.radius_m = 0}}); }),
              "HbaoOptions::radius_m = 0, must be in [1e-4, 1e7]");
    EXPECT_EQ(MessageOf([&] { Gtao(g, {.sampling = {.radius_m = -1}}); }),
              "GtaoOptions::radius_m = -1, must be in [1e-4, 1e7]");
    EXPECT_EQ(MessageOf([&] { Gtao(g, {.sampling = {.slices = 0}}); }),
              "GtaoOptions::slices = 0, must be in [1, 4096]");
    EXPECT_EQ(MessageOf([&] { VisibilityBitmask(g, {.sampling = {.steps = 0}}); }),
              "BitmaskOptions::steps = 0, must be in [1, 65536]");
    EXPECT_EQ(MessageOf([&] { Hbao(g, {.sampling = {.step_power = 0}}); }),
              "HbaoOptions::step_power = 0, must be in [0.25, 8]");
    EXPECT_EQ(MessageOf([&] { Hbao(g, {.bias_rad = 2}); }),
              "HbaoOptions::bias_rad = 2, must be in [0, pi/2)");
    EXPECT_EQ(MessageOf([&] { Hbao(g, {.strength = -1}); }),
              "HbaoOptions::strength = -1, must be in [0, 100]");
    EXPECT_EQ(MessageOf([&] { Gtao(g, {.falloff_start = 2}); }),
              "GtaoOptions::falloff_start = 2, must be in [0, 1]");
    EXPECT_EQ(MessageOf([&] { Gtao(g, {.thickness_blend = 1}); }),
              "GtaoOptions::thickness_blend = 1, must be in [0, 1)");
    EXPECT_EQ(MessageOf([&] { Gtao(g, {.length_lift = -1}); }),
              "GtaoOptions::length_lift = -1, must be in [0, 1]");
    EXPECT_EQ(MessageOf([&] { Gtao(g, {.power = 0}); }),
              "GtaoOptions::power = 0, must be in [0.1, 10]");
    EXPECT_EQ(MessageOf([&] { Gtao(g, {.least = 2}); }),
              "GtaoOptions::least = 2, must be in [0, 1]");
    EXPECT_EQ(MessageOf([&] { VisibilityBitmask(g, {.thickness_m = 0}); }),
              "BitmaskOptions::thickness_m = 0, must be > 0");
    EXPECT_EQ(MessageOf([&] { VisibilityBitmask(g, {.sectors = 65}); }),
              "BitmaskOptions::sectors = 65, must be in [1, 64]");
}

}  // namespace
}  // namespace plumb
