// SAO as a whole: laws that hold for every configuration, and bad input.
#include "screen_space/sao/sao_passes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"
#include "screen_space/sao/sao_presets.h"
#include "tests/screen_space/made_gbuffers.h"
#include "tests/screen_space/sao_pictures.h"

namespace plumb {
namespace {

class Sao : public testing::Test {
  protected:
    ~Sao() override { SetThreadCount(0); }
};

/// A floor and a wall, a sphere before them, and sky above.
MadeShape Corner() {
    const auto low = [](const Vec3& P) { return P.y() < 1.2; };
    return Union(Union(MadePlane({0, 1, 0}, -1), MadePlane({0, 0.1, 1}, -5, low)),
                 MadeSphere({0.4, -0.3, -4}, 0.5));
}

void ExpectSoundPicture(const Image<float>& A, const GBuffer& g, const std::string& what) {
    ASSERT_EQ(A.Width(), g.z_m.Width()) << what;
    ASSERT_EQ(A.Height(), g.z_m.Height()) << what;
    for (int y = 0; y < A.Height(); ++y) {
        for (int x = 0; x < A.Width(); ++x) {
            ASSERT_TRUE(A(x, y) >= 0 && A(x, y) <= 1) << what << " " << x << " " << y;
            if (g.z_m(x, y) == GBuffer::kSkyZ) {
                ASSERT_EQ(A(x, y), 1) << what << " sky " << x << " " << y;
            }
        }
    }
}

void ExpectSound(const SaoPictures& passes, const GBuffer& g, const std::string& what) {
    ExpectSoundPicture(passes.raw, g, what + " raw");
    ExpectSoundPicture(passes.quad, g, what + " quad");
    ExpectSoundPicture(passes.packed, g, what + " packed");
    ExpectSoundPicture(passes.blur_x, g, what + " blur x");
    ExpectSoundPicture(passes.blur_y, g, what + " blur y");
}

std::vector<SaoPreset> EveryFalloff() {
    std::vector<SaoPreset> all = SaoPresets();
    for (const auto& [name, falloff] : {std::pair{"A", SaoFalloffKind::kHpg12},
                                        {"C", SaoFalloffKind::kNoDivision},
                                        {"D", SaoFalloffKind::kLowContrast}}) {
        all.push_back({name, SaoSupplement2012()});
        all.back().options.sampling.sao.falloff = falloff;
    }
    return all;
}

TEST_F(Sao, EveryPassIsSoundAndDarkensACorner) {
    const GBuffer g = MadeGBuffer(MadeView(96, 64, 0.5, 16), Corner());
    for (const SaoPreset& preset : EveryFalloff()) {
        const SaoPictures passes = PicturesOf(g, preset.options);
        ExpectSound(passes, g, preset.name);
        double mean = 0;
        for (int y = 16; y < 80; ++y) {
            for (int x = 16; x < 112; ++x) mean += passes.blur_y(x, y) / (96 * 64.0);
        }
        EXPECT_LT(mean, 0.99) << preset.name;
        EXPECT_GT(mean, 0.5) << preset.name;
        EXPECT_EQ(SaoObscurance(g, preset.options), passes.blur_y) << preset.name;
    }
}

// Memory of another picture, of another size or of other options, leaves no trace.
TEST_F(Sao, ScratchLeavesNoTrace) {
    SaoScratch scratch;
    for (const View& view :
         {MadeView(96, 64, 0.5, 16), MadeView(50, 70), MadeView(50, 70, 0.7)}) {
        const GBuffer g = MadeGBuffer(view, Corner());
        for (const SaoPreset& preset : EveryFalloff()) {
            EXPECT_EQ(RunSao(g, preset.options, scratch), PicturesOf(g, preset.options).blur_y)
                << preset.name;
        }
    }
}

// All points of a plane lie in its tangent plane: v.n is 0 but for the rounding of z, some 1e-6 m,
// far under the bias. Facing the eye, z is one number and that holds through every pyramid too.
TEST_F(Sao, AFlatPlaneIsOpenExactly) {
    const View view = MadeView(96, 64, 0.5, 16);
    for (const SaoPreset& preset : EveryFalloff()) {
        SaoOptions options = preset.options;
        options.blur.tiny = 0;  // which alone darkens a constant
        for (const ZFilter filter :
             {ZFilter::kRotatedGrid, ZFilter::kRotatedGridG3d10, ZFilter::kMean,
              ZFilter::kHarmonicMean, ZFilter::kMin, ZFilter::kMax}) {
            options.sampling.taps.filter = filter;
            const GBuffer facing = MadeGBuffer(view, MadePlane({0, 0, 1}, -3));
            const SaoPictures passes = PicturesOf(facing, options);
            EXPECT_EQ(passes.raw, Image<float>(128, 96, 1.0f)) << preset.name;
            EXPECT_EQ(passes.packed, passes.raw) << preset.name;
        }
        options.sampling.taps.coarsest_level = 0;
        options.sampling.steepest_area = 0;
        for (const NormalSource normals : {NormalSource::kDepth, NormalSource::kFace}) {
            options.sampling.normals = normals;
            options.sampling.taps.outside = TapOutside::kBorderPoint;
            const GBuffer tilted = MadeGBuffer(view, MadePlane({0.3, -0.7, 1}, -3));
            EXPECT_EQ(PicturesOf(tilted, options).raw, Image<float>(128, 96, 1.0f))
                << preset.name;
        }
    }
}

// Options and lengths of the scene times 2^7: every float scales exactly, so every bit of A stays.
TEST_F(Sao, IsTheSameInEveryUnit) {
    const double scale = 128;
    const GBuffer g = MadeGBuffer(MadeView(96, 64, 0.5, 8), Corner());
    GBuffer large = g;
    for (float& z : large.z_m.Pixels()) z *= float(scale);
    for (const SaoPreset& preset : EveryFalloff()) {
        const SaoPictures a = PicturesOf(g, preset.options);
        const SaoPictures b = PicturesOf(large, InOtherUnit(preset.options, scale));
        EXPECT_EQ(a.raw, b.raw) << preset.name;
        EXPECT_EQ(a.quad, b.quad) << preset.name;
        EXPECT_EQ(a.packed, b.packed) << preset.name;
        EXPECT_EQ(a.blur_y, b.blur_y) << preset.name;
        EXPECT_NE(a.raw, PicturesOf(large, preset.options).raw) << preset.name;
    }
}

TEST_F(Sao, HasTheSameBitsOnOneAndTwoThreads) {
    const GBuffer g = MadeGBuffer(MadeView(301, 203, 0.5, 7), Corner());
    for (const SaoPreset& preset : SaoPresets()) {
        SetThreadCount(1);
        const SaoPictures one = PicturesOf(g, preset.options);
        SetThreadCount(2);
        const SaoPictures two = PicturesOf(g, preset.options);
        EXPECT_EQ(one.raw, two.raw);
        EXPECT_EQ(one.quad, two.quad);
        EXPECT_EQ(one.packed, two.packed);
        EXPECT_EQ(one.blur_x, two.blur_x);
        EXPECT_EQ(one.blur_y, two.blur_y);
    }
}

TEST_F(Sao, APassThatIsOffHandsOnWhatItGot) {
    const GBuffer g = MadeGBuffer(MadeView(96, 64), Corner());
    SaoOptions options = SaoSupplement2012();
    const SaoPictures all = PicturesOf(g, options);
    EXPECT_NE(all.quad, all.raw);
    EXPECT_NE(all.packed, all.quad);
    EXPECT_NE(all.blur_x, all.packed);
    EXPECT_NE(all.blur_y, all.blur_x);
    options.quad_filter = false;
    SaoPictures some = PicturesOf(g, options);
    EXPECT_EQ(some.raw, all.raw);
    EXPECT_EQ(some.quad, some.raw);
    options.pack_rgb8 = false;
    some = PicturesOf(g, options);
    EXPECT_EQ(some.packed, some.quad);
    options.blur_x = false;
    some = PicturesOf(g, options);
    EXPECT_EQ(some.blur_x, some.packed);
    EXPECT_NE(some.blur_y, some.blur_x);
    options.blur_y = false;
    EXPECT_EQ(PicturesOf(g, options).blur_y, some.raw);
}

// Each pass that is on is told once, in the order of the text above sao_passes.h.
TEST_F(Sao, PassesThatAreOnAreTold) {
    const GBuffer g = MadeGBuffer(MadeView(32, 16), Corner());
    const std::vector<std::string> all{"z pyramid", "sample", "quads",
                                       "pack",      "blur x", "blur y"};
    EXPECT_EQ(PicturesOf(g, SaoSupplement2012()).told, all);
    SaoOptions options = SaoG3d10();
    options.blur_x = false;
    const std::vector<std::string> some{"z pyramid", "sample", "key", "blur y"};
    EXPECT_EQ(PicturesOf(g, options).told, some);
}

// A pixel of the shown picture depends on what the filters reach and the taps meet, and nothing of
// that is cut off by computing only where it is shown: 8 px more of border change nothing shown.
TEST_F(Sao, ComputesWhatTheFiltersOfTheShownPictureReach) {
    const SaoOptions options = SaoSupplement2012();
    const View view = MadeView(64, 48, 0.5, 40);
    const PixelRect where = ComputedRect(view, options);
    EXPECT_EQ(where, (PixelRect{32, 32, 112, 96}));
    EXPECT_EQ(ComputedRect(MadeView(64, 48), options), (PixelRect{0, 0, 64, 48}));
    EXPECT_EQ(ComputedRect(MadeView(63, 47), options), (PixelRect{0, 0, 63, 47}));
    const GBuffer g = MadeGBuffer(view, Corner());
    const ZPyramid pyramid = BuildZPyramid(g, options);
    const Image<float> part = SamplePass(g, pyramid, options);
    const Image<float> whole = SampleObscurance(g, pyramid, options.sampling, {0, 0, 144, 128});
    for (int y = 0; y < 128; ++y) {
        for (int x = 0; x < 144; ++x) {
            ASSERT_EQ(part(x, y), where.Contains(x, y) ? whole(x, y) : 1) << x << " " << y;
        }
    }
}

// A grows towards 1 as the radius leaves fewer pixels to look at; below the least it is 1.
TEST_F(Sao, FadesOutAtTheLeastRadius) {
    SaoOptions options = SaoG3d10();
    options.sampling.sao.bias_m = 0;
    const GBuffer g = MadeGBuffer(MadeView(64, 48), Corner());
    const ZPyramid pyramid = BuildZPyramid(g, options);
    int y = 20;  // the last row of the wall, beside the floor
    while (g.face_normal(5, y + 1).y() < 0.9f) ++y;
    const double z = g.z_m(5, y), per_metre = g.view.PixelsPerMetre();
    const auto at_radius = [&](double px, double min_px) {
        options.sampling.sao.radius_m = px * -z / per_metre;
        options.sampling.taps.min_radius_px = min_px;
        return ObscuranceOfPixel(g, pyramid, options.sampling, 5, y);
    };
    EXPECT_EQ(at_radius(3.99, 4), 1);
    const double faded = at_radius(4.25, 4), plain = at_radius(4.25, 0);
    EXPECT_LT(plain, 0.9);
    EXPECT_NEAR(faded, 1 + 0.25 * (plain - 1), 1e-12);
    EXPECT_EQ(at_radius(5.5, 4), at_radius(5.5, 0));
}

TEST_F(Sao, ExtremeOptionsHaveDefinedResults) {
    const GBuffer g = MadeGBuffer(MadeView(40, 30, 0.5, 4), Corner());
    for (const SaoPreset& preset : EveryFalloff()) {
        for (const double radius_m : {1e-4, 1e-2, 1e6, 1e7}) {
            SaoOptions options = preset.options;
            options.sampling.sao.radius_m = radius_m;
            ExpectSound(PicturesOf(g, options), g,
                        preset.name + " r " + std::to_string(radius_m));
        }
        for (const int samples : {1, 1000, 4096}) {
            SaoOptions options = preset.options;
            options.sampling.taps.samples = samples;
            options.sampling.taps.turns = 0;
            ExpectSound(PicturesOf(g, options), g,
                        preset.name + " s " + std::to_string(samples));
        }
        SaoOptions options = preset.options;
        options.sampling.taps.coarsest_level = 14;
        options.sampling.taps.log2_switch_px = 0;
        ExpectSound(PicturesOf(g, options), g, preset.name + " 15 levels");
        options.sampling.sao.intensity = 1e30;
        ExpectSound(PicturesOf(g, options), g, preset.name + " intensity");
    }
}

TEST_F(Sao, ExtremeDepthsHaveDefinedResults) {
    GBuffer g = MadeGBuffer(MadeView(33, 17), Corner());
    const float extremes[] = {-1e-18f, -1e-3f, -1e-9f, -1e18f, -1e9f, GBuffer::kSkyZ};
    for (std::size_t i = 0; i < g.z_m.Pixels().size(); i += 3) {
        g.z_m.Pixels()[i] = extremes[i / 3 % 6];
    }
    for (const SaoPreset& preset : EveryFalloff()) {
        ExpectSound(PicturesOf(g, preset.options), g, preset.name);
        SaoOptions options = preset.options;
        options.sampling.normals = NormalSource::kDepth;
        ExpectSound(PicturesOf(g, options), g, preset.name + " normals from depth");
        const GBuffer sky = MadeGBuffer(MadeView(9, 5), MadePlane({0, 0, 1}, 5));
        EXPECT_EQ(PicturesOf(sky, options).blur_y, Image<float>(9, 5, 1.0f));
        const GBuffer one = MadeGBuffer(MadeView(1, 1), MadePlane({0, 0, 1}, -2));
        ExpectSound(PicturesOf(one, options), one, preset.name + " 1 x 1");
        EXPECT_EQ(PicturesOf(one, options).raw(0, 0), 1);
    }
}

// Normals are the caller's; what is no normal must not spread.
TEST_F(Sao, NormalsThatAreNoneHaveDefinedResults) {
    GBuffer g = MadeGBuffer(MadeView(47, 31), Corner());
    const float nan = std::numeric_limits<float>::quiet_NaN(), huge = 3e38f;
    const Vec3f bad[] = {{nan, 0, 1}, {0, 0, nan}, {0, 0, huge}, {huge, -huge, 0}, {0, 0, 0}};
    for (std::size_t i = 0; i < g.z_m.Pixels().size(); i += 2) {
        g.shading_normal.Pixels()[i] = g.face_normal.Pixels()[i] = bad[i / 2 % 5];
    }
    for (const SaoPreset& preset : EveryFalloff()) {
        for (const NormalSource normals : {NormalSource::kFace, NormalSource::kShading}) {
            SaoOptions options = preset.options;
            options.sampling.normals = normals;
            options.blur.normal_weight = true;
            for (const bool plane_weight : {false, true}) {
                options.blur.plane_weight = plane_weight;
                ExpectSound(PicturesOf(g, options), g, preset.name);
            }
            const ZPyramid pyramid = BuildZPyramid(g, options);
            const double A = ObscuranceOfPixel(g, pyramid, options.sampling, 16, 16);
            EXPECT_TRUE(A >= 0 && A <= 1);
        }
    }
}

std::string MessageOf(const GBuffer& g, const SaoOptions& options) {
    try {
        PicturesOf(g, options);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST_F(Sao, BadInputIsNamed) {
    GBuffer g = MadeGBuffer(MadeView(8, 6), Corner());
    EXPECT_EQ(MessageOf(g, SaoPaper()), "");
    SaoOptions options;
    options.sampling.sao.radius_m = 0;
    EXPECT_EQ(MessageOf(g, options), "SaoParams::radius_m = 0, must be in [1e-4, 1e7]");
    options = {};
    options.sampling.taps.samples = 0;
    EXPECT_EQ(MessageOf(g, options), "TapOptions::samples = 0, must be in [1, 4096]");
    options = {};
    options.z_min_m = 300;
    EXPECT_EQ(MessageOf(g, options), "SaoOptions::z_min_m = 300, must be in [-1e9, -1e-3]");
    options = {};
    options.quad_threshold_m = -1;
    EXPECT_EQ(MessageOf(g, options), "SaoOptions::quad_threshold_m = -1, must be in (0, 1e7]");
    g.z_m(5, 4) = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(MessageOf(g, {}),
              "GBuffer::z_m(5, 4) = nan, must be in [-1e18, -1e-18] or the sky's -inf");
    g.z_m = Image<float>(8, 5, -1.0f);
    EXPECT_EQ(MessageOf(g, {}), "GBuffer::z_m has 8 x 5 pixels, must have the view's 8 x 6");
    g.z_m = Image<float>(8, 6, -1.0f);
    g.shading_normal = {};
    EXPECT_EQ(MessageOf(g, SaoG3d10()),
              "GBuffer::normal has 0 x 0 pixels, must have the view's 8 x 6");
    EXPECT_EQ(MessageOf(g, SaoPaper()), "");
    g.view.tan_half_width = 0;
    EXPECT_NE(MessageOf(g, {}), "");
}

TEST(SaoPresets, AreFoundByName) {
    EXPECT_EQ(SaoPresetNamed("g3d10").sampling.taps.samples, 19);
    EXPECT_EQ(SaoPresetNamed("paper").sampling.taps.turns, 7);
    try {
        SaoPresetNamed("hbao");
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "preset \"hbao\", must be one of paper, supplement2012, g3d10, alchemy");
    }
}

}  // namespace
}  // namespace plumb
