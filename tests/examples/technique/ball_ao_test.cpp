// The example of docs/extending.md: a technique of one kernel, described, run and known.
#include "tests/examples/technique/ball_ao.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "rays/embree/embree_caster.h"
#include "scenes/catalogue.h"
#include "techniques/technique.h"
#include "tests/screen_space/made_gbuffers.h"

namespace plumb {
namespace families {
std::vector<PictureTechnique> ball_ao();
}
namespace {

GBuffer FacingPlane() {
    GBuffer g = MadeGBuffer(MadeView(48, 32, 0.5, 8), MadePlane({0, 0, 1}, -3));
    g.triangle = Image<std::uint32_t>(g.z_m.Width(), g.z_m.Height(), 0);
    return g;
}

// Expected: of each pair one point lies before a plane that faces the eye, one behind it, wherever
// both are within what was drawn, as they are in the middle.
TEST(BallAo, APlaneIsHalf) {
    const GBuffer g = FacingPlane();
    const Image<float> A = BallOcclusion(g, {.radius_m = 0.1}, Drawn(g.view));
    EXPECT_EQ(A(32, 24), 0.5f);
    EXPECT_EQ(A(20, 15), 0.5f);
}

// Expected: even in volume, the mean of |s|^3 is 1/2; of the 1024 first points of a net it is off by
// less than one stratum of 1024.
TEST(BallAo, PointsAreEvenInVolume) {
    double sum = 0;
    for (const Vec3& s : PointsOfBall(1024)) sum += std::pow(s.norm(), 3) / 1024;
    EXPECT_NEAR(sum, 0.5, 1.0 / 1024);
}

TEST(BallAo, IsDescribedAndRuns) {
    const PictureTechnique technique = families::ball_ao().front();
    for (const Knob& knob : technique.description.knobs) {
        EXPECT_TRUE(Allows(knob, knob.published)) << knob.name;
    }
    const Scene scene = SceneKindNamed("wedge").make();
    const Camera camera = scene.cameras.front();
    const EmbreeCaster caster(scene);
    const GBuffer g = FacingPlane();
    std::vector<std::string> passes;
    Image<float> last;
    const TurnedTechnique turned = technique.with({{"radius_m", 0.1}, {"pairs", 4}});
    EXPECT_EQ(turned.samples, 8);
    turned.run({g, scene, camera, caster}, [&](std::string_view pass, const Image<float>& A) {
        passes.emplace_back(pass);
        last = A;
    });
    EXPECT_EQ(passes, (std::vector<std::string>{"sample", "key", "blur x", "blur y"}));
    EXPECT_NEAR(last(32, 24), 0.5, 1e-4);  // the filter's own loss: filter_tiny
    EXPECT_THROW(technique.with({{"pairs", 0}}), Error);
}

}  // namespace
}  // namespace plumb
