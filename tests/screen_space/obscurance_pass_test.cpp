// The fast sampling pass against the reference in double, pixel by pixel.
#include "screen_space/sao/obscurance_pass.h"

#include <gtest/gtest.h>

#include <cmath>

#include "screen_space/sao/sao_presets.h"
#include "tests/screen_space/made_gbuffers.h"

namespace plumb {
namespace {

MadeShape Room() {
    const auto low = [](const Vec3& P) { return P.y() < 1.2; };
    return Union(Union(MadePlane({0.1, 1, 0}, -1), MadePlane({0.3, 0.1, 1}, -5, low)),
                 MadeSphere({0.4, -0.3, -4}, 0.5));
}

/// Whether rounding can move a tap of pixel (x, y) to another texel: h u within `slack` of its own
/// size from a whole number, or h from a power of two. Slack is what float loses of h u: the
/// angle's error (6e-8 of the polynomial, 1e-7 of a turn, as much of the table) and three products.
bool IsNearARounding(const GBuffer& g, const ObscuranceOptions& options, int x, int y) {
    const double slack = 2e-6, z = g.z_m(x, y);
    if (!std::isfinite(z)) return false;
    const double disc = DiscRadiusPx(g.view, options.sao.radius_m, z);
    const int shift = options.taps.hash_shift_px;
    const std::int64_t hash = RotationHash(x + shift, y + shift, options.taps.hash);
    for (int i = 0; i < options.taps.samples; ++i) {
        const UnitTap tap = TapOf(options.taps, i);
        const double h = std::max(tap.alpha * disc, options.taps.min_tap_px);
        const double theta = TurnedAngle(tap.angle_rad, hash, options.taps.phi);
        const double off = slack * (h + x + y);
        for (const double part : {h * std::cos(theta), h * std::sin(theta)}) {
            if (std::abs(part - std::round(part)) < off) return true;
        }
        if (std::abs(h - std::exp2(std::round(std::log2(std::max(h, 1e-9))))) < off)
            return true;
    }
    return false;
}

// Of pixels that no rounding can move the float picture differs by what floats lose: z has 6e-8 |z|
// of error only as given to both; v has 4 roundings of a few m, some 1e-6 m, beside an over of up to
// 1 m and an eps of 0.01 m^2 at least 0.001: A changes by less than 2e-4. Normals from depth lose
// more: a chord of 1/40 of z with an error of 6e-8 z each way, so 1e-5.
void ExpectLikeTheReference(const GBuffer& g, const ObscuranceOptions& options,
                            const std::string& what) {
    const ZPyramid pyramid(g.z_m, options.taps.filter, options.taps.coarsest_level);
    const Image<float> A =
        SampleObscurance(g, pyramid, options, {0, 0, g.z_m.Width(), g.z_m.Height()});
    int compared = 0, dark = 0, left_out = 0;
    for (int y = 0; y < A.Height(); ++y) {
        for (int x = 0; x < A.Width(); ++x) {
            if (IsNearARounding(g, options, x, y)) {
                ++left_out;
                continue;
            }
            const double reference = ObscuranceOfPixel(g, pyramid, options, x, y);
            ASSERT_NEAR(A(x, y), reference, 2e-4) << what << " " << x << " " << y;
            ++compared;
            dark += reference < 0.9;
        }
    }
    EXPECT_GT(compared, 5 * left_out) << what;
    EXPECT_GT(dark, compared / 20) << what << ": too open to tell anything";
}

TEST(SampleObscurance, IsTheReferenceForEveryPreset) {
    const GBuffer g = MadeGBuffer(MadeView(117, 81, 0.5, 5), Room());
    for (const SaoPreset& preset : SaoPresets()) {
        ExpectLikeTheReference(g, preset.options.sampling, preset.name);
    }
}

TEST(SampleObscurance, IsTheReferenceForEveryOption) {
    const GBuffer g = MadeGBuffer(MadeView(101, 77, 0.5, 3), Room());
    ObscuranceOptions options = SaoSupplement2012().sampling;
    options.sao.radius_m = 2;
    for (const SaoFalloffKind falloff :
         {SaoFalloffKind::kEquation1, SaoFalloffKind::kHpg12, SaoFalloffKind::kSmooth,
          SaoFalloffKind::kNoDivision, SaoFalloffKind::kLowContrast,
          SaoFalloffKind::kHighQuality}) {
        ObscuranceOptions of = options;
        of.sao.falloff = falloff;
        of.sao.intensity = IntensityPower(falloff) == 5 ? 10 : 0.7;
        of.sao.exponent = 1.5;
        of.sao.lift_dark = true;
        of.sao.bias_per_depth = 0.002;
        ExpectLikeTheReference(g, of, "falloff " + std::to_string(int(falloff)));
    }
    for (const TapPlace place : {TapPlace::kTexel, TapPlace::kLevelTexel, TapPlace::kTap}) {
        for (const TapOutside outside : {TapOutside::kBorderPoint, TapOutside::kBorderDepth}) {
            for (const TapRounding rounding : {TapRounding::kOffset, TapRounding::kSum}) {
                ObscuranceOptions of = options;
                of.taps.place = place;
                of.taps.outside = outside;
                of.taps.rounding = rounding;
                ExpectLikeTheReference(g, of, "place " + std::to_string(int(place)));
            }
        }
    }
    for (const HashReading hash :
         {HashReading::kCode, HashReading::kCPrecedence, HashReading::kXorFirst}) {
        for (const PhiArithmetic phi :
             {PhiArithmetic::kExact, PhiArithmetic::kReduced, PhiArithmetic::kFloat32}) {
            ObscuranceOptions of = options;
            of.taps.hash = hash;
            of.taps.phi = phi;
            ExpectLikeTheReference(g, of, "phi " + std::to_string(int(phi)));
        }
    }
    // A pixel is 1/77 of z wide: facing, its area is 1.7e-4 z^2; at edges and where tilted more. Discs
    // are of 20 to 120 px.
    for (const double steepest_area : {0.0, 4e-4}) {
        ObscuranceOptions of = options;
        of.steepest_area = steepest_area;
        of.taps.min_radius_px = steepest_area > 0 ? 0 : 30;
        of.taps.min_tap_px = 7;
        of.sao.radius_m = steepest_area > 0 ? 2 : 2 * 30.5 / DiscRadiusPx(g.view, 2, -4.5);
        ExpectLikeTheReference(g, of, "steepest " + std::to_string(steepest_area));
    }
    for (const ZFilter filter : {ZFilter::kMean, ZFilter::kHarmonicMean, ZFilter::kMax}) {
        ObscuranceOptions of = options;
        of.taps.filter = filter;
        of.taps.coarsest_level = 3;
        of.taps.log2_switch_px = 2;
        of.taps.pattern = TapPattern::kSunflower;
        of.normals = NormalSource::kFace;
        ExpectLikeTheReference(g, of, "filter " + std::to_string(int(filter)));
    }
}

TEST(SampleObscurance, IsTheReferenceWithAShiftedHash) {
    const GBuffer g = MadeGBuffer(MadeView(101, 77, 0.5, 3), Room());
    ObscuranceOptions options = SaoSupplement2012().sampling;
    options.sao.radius_m = 2;
    options.taps.hash_shift_px = 37;
    ExpectLikeTheReference(g, options, "shift 37");
}

// Expected: a picture with a border that is 32 px wider, a texel of its pyramid's coarsest level,
// shows the same pixels if its hash is shifted back; those within 60 px of the frame have discs
// that reach it.
TEST(SampleObscurance, HasOnePatternWhateverTheBorder) {
    ObscuranceOptions options = SaoSupplement2012().sampling;
    options.sao.radius_m = 0.5;
    const auto shown = [&](int guard_px, int shift_px) {
        const GBuffer g = MadeGBuffer(MadeView(201, 177, 0.5, guard_px), Room());
        const ZPyramid pyramid(g.z_m, options.taps.filter, options.taps.coarsest_level);
        options.taps.hash_shift_px = shift_px;
        return SampleObscurance(g, pyramid, options,
                                {guard_px, guard_px, guard_px + 201, guard_px + 177});
    };
    const Image<float> narrow = shown(32, 0), wide = shown(64, -32), unshifted = shown(64, 0);
    double most = 0, rms = 0, dark = 0;
    int pixels = 0, far_off = 0;
    for (int y = 60; y < 117; ++y) {
        for (int x = 60; x < 141; ++x) {
            const double A = narrow(x + 32, y + 32);
            const double off = std::abs(A - wide(x + 64, y + 64));
            far_off += off > 2e-4;  // A tap that the rounding of x + h u moved.
            most = std::max(most, off);
            rms += std::pow(A - unshifted(x + 64, y + 64), 2);
            dark += A < 0.9;
            ++pixels;
        }
    }
    EXPECT_LT(far_off, pixels / 100) << most;
    EXPECT_GT(std::sqrt(rms / pixels), 0.005);
    EXPECT_GT(dark, 50);  // Else every picture is as good.
}

// In the last corner of a 1080p frame the hash is beyond 2^24: no float holds it and a tap's angle.
TEST(SampleObscurance, TurnsByTheHashFarFromTheOrigin) {
    const GBuffer g = MadeGBuffer(MadeView(1920, 1080, 0.5), Room());
    for (const PhiArithmetic phi :
         {PhiArithmetic::kExact, PhiArithmetic::kReduced, PhiArithmetic::kFloat32}) {
        ObscuranceOptions options = SaoSupplement2012().sampling;
        options.sao.falloff = SaoFalloffKind::kEquation1;
        options.sao.radius_m = 0.1;
        options.sao.bias_m = 0;
        options.taps.phi = phi;
        const ZPyramid pyramid(g.z_m, options.taps.filter, options.taps.coarsest_level);
        int dark = 0;
        for (const PixelRect& where :
             {PixelRect{1856, 1060, 1920, 1080}, PixelRect{1088, 860, 1152, 880}}) {
            const Image<float> A = SampleObscurance(g, pyramid, options, where);
            for (int y = where.y0; y < where.y1; ++y) {
                for (int x = where.x0; x < where.x1; ++x) {
                    if (IsNearARounding(g, options, x, y)) continue;
                    const double reference = ObscuranceOfPixel(g, pyramid, options, x, y);
                    ASSERT_NEAR(A(x, y), reference, 2e-4) << x << " " << y;
                    dark += reference < 0.99;
                }
            }
        }
        EXPECT_GT(dark, 20);
    }
}

}  // namespace
}  // namespace plumb
