// Depth formats: known values, both ways, and what is lost on the way.
#include "screen_space/raster/depth_format.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace plumb {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
constexpr DepthFormat kFormats[] = {DepthFormat::kD16, DepthFormat::kD24, DepthFormat::kD32F,
                                    DepthFormat::kD32FReversed};

// Expected: by hand. n = 1, f = 3, t = 2: a = 3/2, b = -1/2, e = 1/4, d = 3/4. Infinite: e = 1/2.
TEST(DepthFormat, CurveByHand) {
    EXPECT_DOUBLE_EQ(DepthCurve({1, 3}).E(2), 0.25);
    EXPECT_DOUBLE_EQ(DepthCurve({1, kEndless}).E(2), 0.5);
    EXPECT_DOUBLE_EQ(DepthCurve({1, 3}).E(1), 1);
    EXPECT_NEAR(DepthCurve({1, 3}).E(3), 0, 1e-16);
    EXPECT_DOUBLE_EQ(DepthCurve({1, 3}).DistanceM(0.25), 2);
}

// Expected: by hand, from the definition of each format, at e = 1/4: d = 3/4.
TEST(DepthFormat, BitsByHand) {
    EXPECT_EQ(EncodeDepth(DepthFormat::kD16, 0.25), 49151u);  // 49151.25
    EXPECT_EQ(EncodeDepth(DepthFormat::kD24, 0.25), 12582911u);
    EXPECT_EQ(EncodeDepth(DepthFormat::kD32F, 0.25), std::bit_cast<std::uint32_t>(0.75f));
    EXPECT_EQ(EncodeDepth(DepthFormat::kD32FReversed, 0.25),
              std::bit_cast<std::uint32_t>(0.25f));
    EXPECT_EQ(DecodeDepth(DepthFormat::kD16, 65535), 1);
    EXPECT_EQ(DecodeDepth(DepthFormat::kD24, 16777215), 1);
    for (const DepthFormat format : kFormats) {
        const double cleared = DecodeDepth(format, BitsOfKey(format, KeyOf(format, 0)));
        EXPECT_EQ(cleared, format == DepthFormat::kD32FReversed ? 0 : 1) << NameOf(format);
        const double near = DecodeDepth(format, BitsOfKey(format, KeyOf(format, 1)));
        EXPECT_EQ(near, format == DepthFormat::kD32FReversed ? 1 : 0) << NameOf(format);
    }
}

// Expected: by hand for n = 1, f = 3: d = 3/4 is z = -2; infinite f: d = 1/2 is z = -2.
TEST(DepthFormat, ReconstructsZByHand) {
    EXPECT_DOUBLE_EQ(ReconstructZ(DepthFormat::kD24, {1, 3}, 0.75), -2);
    EXPECT_DOUBLE_EQ(ReconstructZ(DepthFormat::kD24, {1, kEndless}, 0.5), -2);
    EXPECT_DOUBLE_EQ(ReconstructZ(DepthFormat::kD32FReversed, {1, 3}, 0.25), -2);
    EXPECT_DOUBLE_EQ(ReconstructZ(DepthFormat::kD32FReversed, {1, kEndless}, 0.5), -2);
    EXPECT_FLOAT_EQ(ReconstructZ(DepthFormat::kD24, {1, 3}, 0.75f), -2);
}

// Expected: what storing may lose. A step of d is 1 / (2^bits - 1), or half an ulp of d or e;
// dz / de = t^2 / a. The rasterizer's key may be one more half step off: e is float there, and
// its product with 2^24 - 1 is rounded too.
TEST(DepthFormat, LosesNoMoreThanARounding) {
    for (const DepthRange range : {DepthRange{0.1, 100}, DepthRange{0.1, kEndless}}) {
        const DepthCurve curve(range);
        for (const DepthFormat format : kFormats) {
            for (double t = 0.1; t < 99; t *= 1.0173) {
                const double e = curve.E(t);
                const double half_step = format == DepthFormat::kD16    ? 0.5 / 65535
                                         : format == DepthFormat::kD24  ? 0.5 / 16777215
                                         : format == DepthFormat::kD32F ? 0x1p-25
                                                                        : e * 0x1p-24;
                const double slope = t * t / curve.a;
                const double d = DecodeDepth(format, EncodeDepth(format, e));
                // 1.1: the curve bends; 1e-15: the double arithmetic itself.
                EXPECT_NEAR(ReconstructZ(format, range, d), -t,
                            1.1 * half_step * slope + 1e-12 * slope)
                    << NameOf(format) << " " << t;
                const double drawn =
                    DecodeDepth(format, BitsOfKey(format, KeyOf(format, float(e))));
                EXPECT_NEAR(drawn, d, 2 * half_step + e * 0x1p-24)
                    << NameOf(format) << " " << t;
            }
        }
    }
}

// Expected: by definition, a nearer surface has the greater or the same key.
TEST(DepthFormat, KeysFallWithDistance) {
    for (const DepthFormat format : kFormats) {
        float last = KeyOf(format, 1);
        for (float e = 1; e > 1e-6f; e *= 0.99f) {
            EXPECT_LE(KeyOf(format, e), last);
            last = KeyOf(format, e);
        }
        EXPECT_LT(last, KeyOf(format, 1));
    }
}

TEST(DepthFormat, RefusesPlanesThatAreNone) {
    for (const DepthRange bad :
         {DepthRange{0, 1}, DepthRange{-1, 1}, DepthRange{1, 1}, DepthRange{std::nan(""), 1},
          DepthRange{1, std::nan("")}, DepthRange{kEndless, kEndless}}) {
        EXPECT_THROW(Validate(bad), Error) << bad.near_m << " " << bad.far_m;
    }
}

}  // namespace
}  // namespace plumb
