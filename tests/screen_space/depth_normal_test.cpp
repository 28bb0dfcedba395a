// Normals out of depth, against the shapes' own.
#include "screen_space/depth_normal.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/screen_space/made_gbuffers.h"

namespace plumb {
namespace {

// On a plane every chord lies in it, so the normal is exact but for the rounding of z to float:
// each end of a chord is off by at most 6e-8 |z|, and a chord has a length of |z| / 80 or more.
TEST(DepthNormal, OfAPlaneIsItsOwn) {
    const View view = MadeView(60, 40, 0.5);
    for (const Vec3& tilt : {Vec3(0, 0, 1), Vec3(0.5, 0, 1), Vec3(-0.3, 0.6, 1)}) {
        const Vec3 n = tilt.normalized();
        const GBuffer g = MadeGBuffer(view, MadePlane(n, -3 * n.z()));
        for (int y = 0; y < 40; ++y) {
            for (int x = 0; x < 60; ++x) {
                const DepthNormal found = NormalFromDepth(view, g.z_m, x, y);
                ASSERT_LT((found.n - n).norm(), 4 * 6e-8 * 80) << x << " " << y;
            }
        }
    }
}

// [McGuire12 eq. 3] with the sign of the shader: the middle of the picture is straight ahead, its
// corners at the tangents of the view, and what is projected comes back.
TEST(ViewPoint, InvertsTheProjection) {
    const View view = MadeView(60, 40, 0.5, 4);
    EXPECT_LT((view.Point(34, 24, -3) - Vec3(0, 0, -3)).norm(), 1e-15);
    EXPECT_LT((view.Point(4, 4, -2) - Vec3(-1.5, 1, -2)).norm(), 1e-15);
    EXPECT_LT((view.Point(64, 44, -2) - Vec3(1.5, -1, -2)).norm(), 1e-15);
    EXPECT_LT((view.Project(view.Point(11.25, 37.5, -7)) - Vec2(11.25, 37.5)).norm(), 1e-13);
}

// Facing the plane, a pixel covers (|z| / 40)^2 m^2.
TEST(DepthNormal, AreaIsThatOfAPixel) {
    const View view = MadeView(60, 40, 0.5);
    const GBuffer g = MadeGBuffer(view, MadePlane({0, 0, 1}, -7));
    EXPECT_NEAR(NormalFromDepth(view, g.z_m, 11, 12).area, 1 / 1600.0, 1e-9);
    EXPECT_EQ(NormalFromDepth(view, g.z_m, 11, 12).n, Vec3(0, 0, 1));
}

// A chord of a sphere of radius R is tilted by half its angle at the centre: up to pixel / R in each
// of two directions. At the rim chords grow, so we look where the normal is within 60 degrees.
TEST(DepthNormal, OfASphereIsOffByTheChord) {
    const View view = MadeView(400, 400, 0.5);
    const Vec3 centre(0.2, -0.1, -4);
    const double R = 1;
    const GBuffer g = MadeGBuffer(view, MadeSphere(centre, R));
    const double pixel_m = 4 / view.PixelsPerMetre() / std::cos(kPi / 3);
    int seen = 0;
    for (int y = 0; y < 400; ++y) {
        for (int x = 0; x < 400; ++x) {
            const Vec3 n = g.face_normal(x, y).cast<double>();
            if (n.dot(view.Point(x + 0.5, y + 0.5, 1).normalized()) < 0.6) continue;
            const DepthNormal found = NormalFromDepth(view, g.z_m, x, y);
            ASSERT_LT((found.n - n).norm(), 2 * pixel_m / R) << x << " " << y;
            ++seen;
        }
    }
    EXPECT_GT(seen, 3000);
}

// x = 2 and 3 are a quad: 2 sees a step of depth; if 3 is sky it takes 1 instead.
TEST(DepthNormal, TakesTheOtherNeighbourOfTheSky) {
    const View view = MadeView(6, 4);
    GBuffer g = MadeGBuffer(view, MadePlane({0.5, 0, 1}, -3));
    const Vec3 n = Vec3(0.5, 0, 1).normalized();
    g.z_m(3, 1) = GBuffer::kSkyZ;
    EXPECT_LT((NormalFromDepth(view, g.z_m, 2, 1).n - n).norm(), 1e-5);
    g.z_m(3, 1) = -9;
    EXPECT_GT((NormalFromDepth(view, g.z_m, 2, 1).n - n).norm(), 0.1);
    g.z_m(3, 1) = g.z_m(1, 1) = GBuffer::kSkyZ;
    const DepthNormal none = NormalFromDepth(view, g.z_m, 2, 1);
    EXPECT_LT((none.n + view.Point(2.5, 1.5, -1).normalized()).norm(), 1e-15);
    EXPECT_EQ(none.area, 0);
    const GBuffer one = MadeGBuffer(MadeView(1, 1), MadePlane({0, 0, 1}, -3));
    EXPECT_EQ(NormalFromDepth(one.view, one.z_m, 0, 0).n, Vec3(0, 0, 1));
}

}  // namespace
}  // namespace plumb
