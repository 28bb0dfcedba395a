// The precision of z and of normals from depth, against derived bounds and the paper's findings.
#include "screen_space/raster/z_precision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/error.h"
#include "scenes/simple.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/normal_precision.h"

namespace plumb {
namespace {

TEST(ZPipeline, EachCombinationOnce) {
    std::set<std::string> names;
    for (const ZPipeline& p : AllZPipelines()) names.insert(NameOf(p));
    EXPECT_EQ(names.size(), AllZPipelines().size());
    EXPECT_EQ(names.size(), 112u);
    EXPECT_EQ(NameOf(ZPipeline{}), "double concatenated rows GL D24 infinite");
}

// Expected: a bound by counting roundings. clip_w is a sum of four products: each entry, product
// and partial sum rounds by 2^-24 of at most S = Sum |m_k v_k|, six times in a row for one
// matrix, thrice that for three. |v| in the object's frame is at most 1.6 t plus both distances
// from the origin. e = n / w, the store and z(d) round three times more.
TEST(ZPrecision, ReversedFloatIsAsGoodAsTheVertexTransform) {
    const ZStudySettings s;
    for (const HostPrecision host : {HostPrecision::kDouble, HostPrecision::kFloat}) {
        const ZPipeline p{
            .host = host, .clip = ClipRange::kZeroToOne, .format = DepthFormat::kD32FReversed};
        for (const ZError& error : MeasureZError(p, s)) {
            const double apart = s.from_origin_m + s.object_from_origin_m;
            const double S = std::sqrt(3.0) * (1.6 * error.t_m + apart) + apart;
            const double matrices = host == HostPrecision::kDouble ? 6 : 18;
            EXPECT_LT(error.worst_m, 0x1p-24 * (matrices * S + 3 * 1.01 * error.t_m));
            EXPECT_GT(error.rms_m, 0);
        }
    }
}

// Expected: rounding to 2^16 - 1 steps is the only error that counts: uniform within a step, so
// step / sqrt(12), times dz/dd = t^2 / a. Tolerance: 1 % of t about t = 10 are 13 steps, of which
// the last may be cut: 15 %.
TEST(ZPrecision, SixteenBitsAreAUniformRounding) {
    ZStudySettings s;
    s.first_m = 5;
    s.last_m = 10;
    s.distances = 2;
    for (const bool infinite : {true, false}) {
        const ZPipeline p{.format = DepthFormat::kD16, .far_is_infinite = infinite};
        const double a = DepthCurve({s.near_m, infinite ? INFINITY : s.far_m}).a;
        for (const ZError& error : MeasureZError(p, s)) {
            const double expected = error.t_m * error.t_m / a / 65535 / std::sqrt(12.0);
            EXPECT_NEAR(error.rms_m / expected, 1, 0.15);
            EXPECT_LT(std::abs(error.mean_m), 0.2 * expected);
        }
    }
}

double Rms(const ZPipeline& p, double t_m) {
    ZStudySettings s;
    s.first_m = t_m;
    s.last_m = 1.001 * t_m;
    s.far_m = 200;
    s.distances = 2;
    s.poses = 400;
    return MeasureZError(p, s)[0].rms_m;
}

// Expected: the caption of figure 3 of [McGuire12]: "An infinite far plane impacts recovered z
// accuracy more than depth buffer format at 24-bit or higher precision."
TEST(ZPrecision, TheFarPlaneMattersMoreThanTheFormat) {
    for (const double t : {2.0, 10.0, 50.0}) {
        const auto rms = [&](DepthFormat format, bool infinite) {
            return Rms({.format = format, .far_is_infinite = infinite}, t);
        };
        const double d24 = rms(DepthFormat::kD24, true), d32 = rms(DepthFormat::kD32F, true);
        EXPECT_NEAR(d24 / d32, 1, 0.02) << t;
        EXPECT_LT(d24, 0.75 * rms(DepthFormat::kD24, false)) << t;
        EXPECT_LT(d32, 0.75 * rms(DepthFormat::kD32F, false)) << t;
    }
}

// Expected: recommendation 1 of the paper: never worse, where z near the camera shows it.
TEST(ZPrecision, DoubleProductsHelpOneMatrix) {
    const double in_double = Rms({.host = HostPrecision::kDouble}, 2);
    const double in_float = Rms({.host = HostPrecision::kFloat}, 2);
    EXPECT_LT(in_double, in_float);
}

TEST(ZPrecision, NamesWhatIsWrong) {
    const auto why = [](const ZStudySettings& s) -> std::string {
        try {
            MeasureZError({}, s);
        } catch (const Error& e) {
            return e.what();
        }
        return "";
    };
    EXPECT_EQ(why({.near_m = 0}), "near_m = 0, must be > 0 and finite");
    EXPECT_EQ(why({.far_m = 50}), "far_m = 50, must be > last_m and finite");
    EXPECT_EQ(why({.points = 0}), "points = 0, must be >= 1");
    EXPECT_EQ(why({.poses = 0}), "poses = 0, must be >= 1");
    EXPECT_EQ(why({.distances = 1}), "distances = 1, must be >= 2");
}

// Expected: z of the surface is a float: its neighbours' difference loses 2^-24 t each, over a
// lateral step of about t / pixels_per_metre, turned by at most pixels 2^-23 / cos^2 of the slant;
// on the faces of a box seen at no less than cos = 1/4 that is 620 x 2^-23 x 16 x sqrt 2.
TEST(NormalPrecision, OfTheSurfaceItselfIsFloatRounding) {
    const Scene scene = BoxOnPlane();
    const GBuffer g = DrawGBuffer(scene, scene.cameras[0]);
    const Image<float> angle = NormalErrorRad(g);
    int judged = 0, edges = 0;
    for (int j = 0; j < g.z_m.Height(); ++j) {
        for (int i = 0; i < g.z_m.Width(); ++i) {
            const Vec3 w = g.view.Point(i + 0.5, j + 0.5, -1).normalized();
            if (-w.dot(g.face_normal(i, j).cast<double>()) < 0.25) continue;
            if (std::isnan(angle(i, j))) {
                ++edges;
                continue;
            }
            ++judged;
            ASSERT_LT(angle(i, j), 652 * 0x1p-23 * 16 * 1.42) << i << " " << j;
        }
    }
    EXPECT_GT(judged, 100000);
    EXPECT_GT(edges, 100);
}

}  // namespace
}  // namespace plumb
