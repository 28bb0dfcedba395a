#include "scenes/catalogue.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "core/error.h"
#include "scenes/dense.h"

namespace plumb {
namespace {

std::int64_t Triangles(const Scene& scene) {
    std::int64_t count = 0;
    for (const auto& q : scene.mesh.quads) count += q[2] == q[3] ? 1 : 2;
    return count;
}

// Expected: what the issue asks for (atrium about 250 000, slivers and forest 1e6), and counts
// by hand of the small ones: a plane of 20 x 20 quads is 800, a box 12, a ball of 192 x 96
// quads 36864, five walls 10 and two blocks of five sides 20.
TEST(SceneKinds, HaveTheTrianglesThatTheyPromise) {
    std::map<std::string, std::int64_t> counts;
    for (const SceneKind& kind : SceneKinds()) {
        const Scene scene = kind.make();
        EXPECT_EQ(scene.name, kind.name);
        EXPECT_FALSE(scene.cameras.empty()) << kind.name;
        EXPECT_NO_THROW(Validate(scene)) << kind.name;
        counts[scene.name] = Triangles(scene);
    }
    EXPECT_EQ(counts["box_on_plane"], 800 + 12);
    EXPECT_EQ(counts["ball_over_plane"], 800 + 36864);
    EXPECT_EQ(counts["cornell_box"], 10 + 20);
    EXPECT_EQ(counts["slivers"], 1'000'000);
    EXPECT_EQ(counts["forest"], 1'000'000 + 200);
    EXPECT_GT(counts["atrium"], 220'000);
    EXPECT_LT(counts["atrium"], 280'000);
}

// Expected: by the divergence theorem the faces of a closed body seen from outside span
// 1/3 Sum p . n A = its volume: a cube of 1 m has 1, a ball of 0.8 m about 2.145 (a little less,
// its faces are chords), up to the ground, which contributes nothing at z = 0.
TEST(SceneKinds, BodiesAreSeenFromOutside) {
    const auto volume = [](const Scene& scene) {
        double sum = 0;
        for (const auto& q : scene.mesh.quads) {
            const auto p = [&](int k) -> Vec3 {
                return scene.mesh.vertices_m[q[k]].cast<double>();
            };
            sum += p(0).dot(p(1).cross(p(3))) / 6;
            if (q[2] != q[3]) sum += p(2).dot(p(3).cross(p(1))) / 6;
        }
        return sum;
    };
    EXPECT_NEAR(volume(SceneKindNamed("box_on_plane").make()), 1, 1e-5);
    const double ball = 4.0 / 3 * std::numbers::pi * 0.512;
    EXPECT_NEAR(volume(SceneKindNamed("ball_over_plane").make()), ball, 2e-3 * ball);
}

TEST(SceneKinds, RefuseUnknownNamesAndCounts) {
    try {
        SceneKindNamed("sponza");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).substr(0, 37),
                  "scene \"sponza\", must be one of atrium");
    }
    EXPECT_THROW(Fence(0), Error);
    EXPECT_THROW(Slivers(-1), Error);
}

Scene Room() {
    return SceneKindNamed("cornell_box").make();
}

std::string Complaint(const Scene& scene) {
    try {
        Validate(scene);
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

TEST(Scene, NamesWhatIsWrong) {
    Scene scene = Room();
    scene.cameras[0].fov_rad = std::numbers::pi;
    EXPECT_EQ(Complaint(scene), "cornell_box: cameras[0].fov_deg = 180, must be in (0, 180)");
    scene = Room();
    scene.cameras[0].width_px = 0;
    EXPECT_EQ(Complaint(scene), "cornell_box: cameras[0].width_px = 0, must be in [1, 65536]");
    scene = Room();
    scene.cameras[0].width_px = scene.cameras[0].height_px = 60000;
    EXPECT_NE(Complaint(scene).find("at most 2^28"), std::string::npos);
    scene = Room();
    scene.cameras[0].target_m = scene.cameras[0].position_m;
    EXPECT_NE(Complaint(scene).find("target is the position"), std::string::npos);
    scene = Room();
    scene.materials[1].albedo[2] = 1.5f;
    EXPECT_EQ(Complaint(scene), "cornell_box: materials[1].albedo[2] = 1.5, must be in [0, 1]");
    scene = Room();
    scene.mesh.vertices_m[3].z() = std::nanf("");
    EXPECT_NE(Complaint(scene).find("vertex 3.z = nan"), std::string::npos);
    scene = Room();
    scene.mesh.quads[0][1] = 12345;
    EXPECT_NE(Complaint(scene).find("corner of face 0 = 12345"), std::string::npos);
    scene = Room();
    scene.mesh.quads.clear();
    EXPECT_EQ(Complaint(scene), "cornell_box: faces = 0, must be >= 1");
}

// Expected: by hand. A camera at the origin that looks along +y with up +z: right is +x. At
// 90 degrees of height and 2 x 1 pixels, half the height is 1 and half the width 2 at depth 1.
TEST(Camera, SendsPixelsWhereTheyLie) {
    const Camera camera{.position_m = {0, 0, 0},
                        .target_m = {0, 5, 0},
                        .fov_rad = std::numbers::pi / 2,
                        .width_px = 2,
                        .height_px = 1};
    const CameraFrame frame(camera);
    EXPECT_LT((frame.Direction(camera, 1, 0.5) - Vec3(0, 1, 0)).norm(), 1e-12);
    EXPECT_LT((frame.Direction(camera, 0, 0) - Vec3(-2, 1, 1)).norm(), 1e-12);
    EXPECT_LT((frame.Direction(camera, 1.5, 0.5) - Vec3(1, 1, 0)).norm(), 1e-12);
}

}  // namespace
}  // namespace plumb
