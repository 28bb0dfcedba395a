// What holds for every technique that is listed, whatever it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include "core/error.h"
#include "rays/embree/embree_caster.h"
#include "scenes/catalogue.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "techniques/technique.h"

namespace plumb {
namespace {

class Listed : public testing::TestWithParam<std::string> {
  protected:
    const PictureTechnique& Technique() const { return FindTechnique(GetParam()); }
    const Description& About() const { return Technique().description; }
};

std::vector<std::string> Names() {
    std::vector<std::string> names;
    for (const PictureTechnique& one : AllTechniques()) names.push_back(one.description.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Techniques, Listed, testing::ValuesIn(Names()), [](const auto& of) {
    std::string name = of.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(Techniques, HaveNamesOfTheirOwn) {
    const std::vector<std::string> names = Names();
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
    EXPECT_THROW(FindTechnique("ssao"), Error);
}

// Plain ray tracing is nobody's paper.
TEST_P(Listed, CitesAPaperOfTheReferences) {
    if (About().family == "rays") {
        EXPECT_EQ(About().paper, "");
        return;
    }
    std::ifstream page(PLUMB_SOURCE_DIR "/docs/references.bib");
    const std::string text{std::istreambuf_iterator<char>(page), {}};
    EXPECT_NE(text.find("{" + About().paper + ","), std::string::npos) << About().paper;
}

TEST_P(Listed, SaysWhatItIs) {
    EXPECT_FALSE(About().what.empty());
    EXPECT_FALSE(About().family.empty());
    std::set<std::string> names;
    for (const Knob& knob : About().knobs) {
        EXPECT_TRUE(names.insert(knob.name).second) << knob.name << " twice";
        EXPECT_FALSE(knob.meaning.empty()) << knob.name;
        EXPECT_TRUE(Allows(knob, knob.published)) << knob.name << " = " << knob.published;
        EXPECT_EQ(knob.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"),
                  std::string::npos)
            << knob.name;
        // A length says so in its name.
        for (const std::string unit : {"m", "m2", "px", "rad"}) {
            const std::string written = unit == "m2" ? "m^2" : unit;
            EXPECT_EQ(knob.name.ends_with("_" + unit), knob.unit == written) << knob.name;
        }
        const std::string text = TextOf(knob, knob.published);
        EXPECT_EQ(ValueOfText(knob, text, ""), knob.published) << knob.name;
    }
    EXPECT_TRUE(names.contains("radius_m"));
    EXPECT_TRUE(names.contains("samples"));
    EXPECT_TRUE(names.contains("filter"));
}

TEST_P(Listed, RefusesWhatIsNoKnobOrOutsideOfItsDomain) {
    EXPECT_THROW(Technique().with({{"no_such_knob", 1}}), Error);
    for (const Knob& knob : About().knobs) {
        const bool chosen = !knob.choices.empty();
        EXPECT_THROW(Technique().with({{knob.name, chosen ? 99.0 : knob.low - 1}}), Error)
            << knob.name;
        if (!chosen && !std::isinf(knob.high)) {
            EXPECT_THROW(Technique().with({{knob.name, 2 * knob.high + 1}}), Error)
                << knob.name;
        }
        EXPECT_NO_THROW(Technique().with({{knob.name, knob.published}})) << knob.name;
    }
}

struct Corner {
    Scene scene = SceneKindNamed("cornell_box").make();
    Camera camera = [this] {
        Camera small = scene.cameras.front();
        small.width_px = 96;
        small.height_px = 72;
        return small;
    }();
    EmbreeCaster caster{scene};
    GBuffer gbuffer = DrawGBuffer(scene, camera, {.guard_px = 12});

    Image<float> Of(const PictureTechnique& technique, const KnobValues& values) const {
        Image<float> last;
        technique.with(values).run({gbuffer, scene, camera, caster},
                                   [&](std::string_view, const Image<float>& A) { last = A; });
        return last;
    }
};

// Values that move nothing on their own: of what is off, or of what this scene does not hold.
bool MayLeaveThePicture(const Knob& knob) {
    static const std::set<std::string> idle{
        "filter_near_m2", "filter_monotonic", "quad_threshold_m", "outside",
        "steepest_area",  "min_radius_px",    "min_tap_px",       "bias_per_depth",
        "bias_m",         "exponent",         "lift_dark",        "shading_normals",
        "normals",        "normalize",        "full_turn_rad",    "turns",
        "filter_planes",  "filter_normals",   "filter_z_min_m"};
    return idle.contains(knob.name) || knob.name.starts_with("filter_g");
}

// A switch is there because it changes the picture; turned to what it already is it does not.
TEST_P(Listed, EverySwitchChangesThePicture) {
    const Corner corner;
    const Image<float> published = corner.Of(Technique(), {{"radius_m", 0.3}});
    for (const Knob& knob : About().knobs) {
        if (!knob.IsSwitch()) continue;
        KnobValues values{{"radius_m", 0.3}, {knob.name, knob.published}};
        EXPECT_EQ(corner.Of(Technique(), values).Pixels(), published.Pixels()) << knob.name;
        values[knob.name] = 1 - knob.published;
        if (MayLeaveThePicture(knob)) continue;
        EXPECT_NE(corner.Of(Technique(), values).Pixels(), published.Pixels()) << knob.name;
    }
}

std::vector<std::string> Told(const PictureTechnique& technique, const KnobValues& values) {
    const Corner corner;
    std::vector<std::string> told;
    technique.with(values).run(
        {corner.gbuffer, corner.scene, corner.camera, corner.caster},
        [&](std::string_view pass, const Image<float>&) { told.emplace_back(pass); });
    return told;
}

TEST_P(Listed, FiltersAlongOneAxisWhereTheOtherIsOff) {
    const auto has = [](const std::vector<std::string>& told, const char* pass) {
        return std::count(told.begin(), told.end(), pass);
    };
    const std::vector<std::string> only_y = Told(Technique(), {{"filter_x", 0}});
    EXPECT_EQ(has(only_y, "blur x"), 0);
    EXPECT_EQ(has(only_y, "blur y"), 1);
    const std::vector<std::string> none = Told(Technique(), {{"filter", 0}});
    EXPECT_EQ(has(none, "blur x") + has(none, "blur y"), 0);
    EXPECT_EQ(has(none, "sample"), 1);
}

// Expected by hand: 24 taps of SAO; of slices 2 x 4 x 3, since sqrt(12) is nearest to 3.
TEST_P(Listed, TakesAsManySamplesAsAsked) {
    EXPECT_EQ(Technique().with({{"samples", 24}}).samples, 24);
}

// 20 taps make the 9 turns of the table if none are given; 7 are as published.
TEST(SaoTechnique, TurnsFollowTheSamples) {
    const Corner corner;
    const PictureTechnique& sao = FindTechnique("sao-supplement2012");
    const auto A = [&](const KnobValues& values) { return corner.Of(sao, values).Pixels(); };
    EXPECT_EQ(A({{"samples", 20}}), A({{"samples", 20}, {"turns", 9}}));
    EXPECT_NE(A({{"samples", 20}}), A({{"samples", 20}, {"turns", 7}}));
}

// Law: at reach r x and no other change, a multiplier of x is a radius x times as great.
TEST(GtaoTechnique, ReachesAsFarAsItsMultiplierSays) {
    const Corner corner;
    for (const char* name : {"gtao-paper", "gtao-xegtao"}) {
        const auto A = [&](double radius_m, double multiplier) {
            return corner
                .Of(FindTechnique(name),
                    {{"radius_m", radius_m}, {"radius_multiplier", multiplier}})
                .Pixels();
        };
        EXPECT_EQ(A(0.15, 2), A(0.3, 1)) << name;
        EXPECT_NE(A(0.15, 2), A(0.15, 1)) << name;
    }
}

// Law: of four depths the nearest (max: z < 0) occludes more than the farthest (min), and the means lie
// between.
TEST(SaoTechnique, PyramidsOfTheNearestOccludeMore) {
    const Corner corner;
    const PictureTechnique& sao = FindTechnique("sao-supplement2012");
    const Knob& filter = KnobNamed(sao.description, "pyramid_filter", "test");
    const auto mean = [&](const char* name) {
        const Image<float> A = corner.Of(
            sao, {{"radius_m", 0.3}, {"pyramid_filter", ValueOfText(filter, name, "")}});
        double sum = 0;
        for (const float a : A.Pixels()) sum += a;
        return sum / double(A.Pixels().size());
    };
    const double nearest = mean("max"), farthest = mean("min");
    EXPECT_LT(nearest, farthest - 1e-4);
    for (const char* name : {"mean", "harmonic_mean"}) {
        EXPECT_LT(nearest, mean(name)) << name;
        EXPECT_GT(farthest, mean(name)) << name;
    }
}

}  // namespace
}  // namespace plumb
