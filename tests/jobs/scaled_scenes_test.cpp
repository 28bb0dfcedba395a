// Metamorphic: a scene in another unit is the same picture. Every technique that is listed, the
// truth, and the study of all layers, with all lengths that they take scaled alike.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "jobs/screen_space/layered_obscurance.h"
#include "jobs/screen_space/technique.h"
#include "jobs/truth/view_truth.h"
#include "rays/embree/embree_caster.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/near_plane.h"
#include "tests/jobs/made_scenes.h"
#include "tests/jobs/plain_scores.h"

namespace plumb {
namespace {

constexpr double kRadiusM = 0.7;
constexpr int kGuardPx = 16;

struct Scaled {
    double scale;
    Scene scene;
    Camera camera;
    EmbreeCaster caster;
    GBuffer gbuffer;

    explicit Scaled(double by)
        : scale(by),
          scene(Made(by)),
          camera(scene.cameras.front()),
          caster(scene),
          gbuffer(DrawGBuffer(scene, camera, SuitedTo(scene, camera, kGuardPx))) {}

    static Scene Made(double by) {
        Scene scene = FloorAndWall(96, 54);
        // A plate before the wall: more than one layer.
        AddFace(scene, {Vec3f(-0.3F, 1.2F, 0.1F), Vec3f(0.2F, 1.2F, 0.1F),
                        Vec3f(0.2F, 1.2F, 0.5F), Vec3f(-0.3F, 1.2F, 0.5F)});
        for (Vec3f& v : scene.mesh.vertices_m) v = (by * v.cast<double>()).cast<float>();
        Camera& camera = scene.cameras.front();
        // So near that things lie within the radius of the eye.
        camera.position_m = by * Vec3(0.5, 0.4, 0.6);
        camera.target_m = by * Vec3(0, 1.5, 0.2);
        return scene;
    }
    TechniqueInput In() const { return {gbuffer, scene, camera, caster}; }
};

// The published values of its knobs, those that are lengths `scale` times as great.
TechniqueSettings InUnit(const std::string& name, double scale) {
    const Description& about = FindTechnique(name).description;
    TechniqueSettings settings{.radius_m = kRadiusM * scale};
    for (const Knob& knob : about.knobs) {
        double power = knob.unit == "m" ? 1 : knob.unit == "m^2" ? 2 : 0;
        if (knob.name == "intensity") {
            const Knob& falloff = KnobNamed(about, "falloff", "test");
            power = IntensityPower(SaoFalloffKind(int(falloff.published)));
        }
        if (power == 0 || knob.name == "radius_m") continue;
        settings.knobs[knob.name] = knob.published * std::pow(scale, power);
    }
    return settings;
}

Image<float> PictureOf(const std::string& name, const Scaled& scaled) {
    const Technique technique = TechniqueNamed(name, InUnit(name, scaled.scale));
    return Shown(technique.run(scaled.In(), Ticking()).back().A, scaled.gbuffer.view);
}

ViewTruth TruthOf(const Scaled& scaled) {
    const std::vector<Falloff> falloffs{Falloff::kHard, Falloff::kLinear, Falloff::kSao,
                                        Falloff::kQuadratic, Falloff::kFarEnd};
    return MeasureViewTruth(scaled.caster, scaled.scene, scaled.camera, falloffs,
                            {.radius_m = kRadiusM * scaled.scale, .spp = 64});
}

Image<float> LayersOf(const Scaled& scaled) {
    SaoOptions options = SaoWith("supplement2012", InUnit("sao-supplement2012", scaled.scale));
    options.sampling.taps.coarsest_level = 0;
    return LayeredObscurance(scaled.In(), options, {.stride_px = 1});
}

// Pixels of which the two are farther apart than that.
int Differing(const Image<float>& a, const Image<float>& b, double than) {
    int count = 0;
    for (std::size_t p = 0; p < a.Pixels().size(); ++p) {
        count += std::abs(double(a.Pixels()[p]) - b.Pixels()[p]) > than;
    }
    return count;
}

// Expected: a power of two changes no digit of a float, so the pictures are the same to the bit.
TEST(ScaledScenes, ByAPowerOfTwoAreTheSameBits) {
    const Scaled one(1);
    for (const double scale : {0x1p-10, 0x1p10}) {
        const Scaled other(scale);
        for (const std::string& name : TechniqueNames()) {
            EXPECT_EQ(PictureOf(name, other).Pixels(), PictureOf(name, one).Pixels())
                << name << " " << scale;
        }
        const ViewTruth a = TruthOf(one), b = TruthOf(other);
        EXPECT_EQ(b.V.value.Pixels(), a.V.value.Pixels()) << scale;
        EXPECT_EQ(b.V.standard_error.Pixels(), a.V.standard_error.Pixels()) << scale;
        for (const auto& [falloff, near] : a.near) {
            EXPECT_EQ(b.near.at(falloff).value.Pixels(), near.value.Pixels()) << int(falloff);
        }
        EXPECT_EQ(LayersOf(other).Pixels(), LayersOf(one).Pixels()) << scale;
    }
}

// Expected: the same but at pixels where a tap, or a ray that grazes an edge, rounds to its neighbour:
// no more than one of a hundred. Where sectors of a bitmask are rounded up, a plane's samples lie on
// the edge of one (screen_space/horizon/visibility_bitmask.h), and roundings tell: one of 32 on
// each side of a slice at most.
TEST(ScaledScenes, ByAThousandAreTheSameButForRounding) {
    const Scaled one(1);
    const int few = 96 * 54 / 100;
    for (const double scale : {1e-3, 1e3}) {
        const Scaled other(scale);
        for (const std::string& name : TechniqueNames()) {
            const Image<float> a = PictureOf(name, one), b = PictureOf(name, other);
            if (name == "bitmask") {
                EXPECT_EQ(Differing(a, b, 2.0 / 32), 0) << scale;
            } else {
                EXPECT_LE(Differing(a, b, 1e-4), few) << name << " " << scale;
            }
        }
        const ViewTruth a = TruthOf(one), b = TruthOf(other);
        EXPECT_LE(Differing(a.V.value, b.V.value, 1e-4), few) << scale;
        for (const auto& [falloff, near] : a.near) {
            EXPECT_LE(Differing(near.value, b.near.at(falloff).value, 1e-4), few)
                << int(falloff);
        }
        EXPECT_LE(Differing(LayersOf(one), LayersOf(other), 1e-4), few) << scale;
    }
}

// Else all of the above would say nothing: every picture has something in it.
TEST(ScaledScenes, AreNoBlankPictures) {
    const Scaled one(1);
    const Image<float> open(96, 54, 1);
    for (const std::string& name : TechniqueNames()) {
        EXPECT_GT(Differing(PictureOf(name, one), open, 0.1), 96 * 54 / 10) << name;
    }
    EXPECT_GT(Differing(LayersOf(one), open, 0.1), 96 * 54 / 10);
}

}  // namespace
}  // namespace plumb
