// Every constant of every preset, against the papers and the shaders that they are named after.
//
// Expected values: SAO's from the text of [McGuire12] (paper), the shaders of its supplement and of
// G3D 10; XeGTAO's from XeGTAO.h and XeGTAO.hlsli; the bitmask's from the shader of [Therrien23].
// What the paper leaves open is marked ours in screen_space/sao/sao_presets.h.
#include <gtest/gtest.h>

#include "techniques/technique.h"

namespace plumb {
namespace {

using Texts = std::map<std::string, std::string>;

void ExpectPublished(const std::string& technique, const Texts& texts) {
    const Description& about = FindTechnique(technique).description;
    for (const auto& [name, text] : texts) {
        const Knob& knob = KnobNamed(about, name, "test");
        EXPECT_EQ(TextOf(knob, knob.published), text) << technique << "." << name;
    }
}

// Says something of every knob: a new one must be looked up too.
void ExpectAll(const std::string& technique, const Texts& texts) {
    ExpectPublished(technique, texts);
    for (const Knob& knob : FindTechnique(technique).description.knobs) {
        EXPECT_TRUE(texts.contains(knob.name)) << technique << "." << knob.name;
    }
}

Texts Over(Texts under, const Texts& over) {
    for (const auto& [name, text] : over) under[name] = text;
    return under;
}

// What no preset changes.
const Texts kCommonFilter{{"packing", "off"},
                          {"filter_z_min_m", "-300"},
                          {"filter_taps", "4"},
                          {"filter_stride_px", "2"},
                          {"filter_lift", "0.3"},
                          {"filter_sharpness", "2000"},
                          {"filter_tiny", "1e-4"},
                          {"filter_normals", "off"},
                          {"filter_planes", "off"},
                          {"filter_monotonic", "off"},
                          {"filter_near_m2", "0.001"},
                          {"filter_g0", "0.15317"},
                          {"filter_g1", "0.144893"},
                          {"filter_g2", "0.122649"},
                          {"filter_g3", "0.092902"},
                          {"filter_g4", "0.06297"},
                          {"filter_g5", "0"},
                          {"filter_g6", "0"},
                          {"filter", "on"},
                          {"filter_x", "on"},
                          {"filter_y", "on"}};

const Texts kSupplement = Over(kCommonFilter, {{"packing", "on"},
                                               {"radius_m", "1"},
                                               {"falloff", "b"},
                                               {"bias_m", "0.01"},
                                               {"bias_per_depth", "0"},
                                               {"intensity", "1"},
                                               {"epsilon_m2", "0.01"},
                                               {"exponent", "1"},
                                               {"lift_dark", "off"},
                                               {"samples", "11"},
                                               {"turns", "7"},
                                               {"pattern", "spiral"},
                                               {"full_turn_rad", "6.28"},
                                               {"hash", "code"},
                                               {"phi", "float32"},
                                               {"rounding", "offset"},
                                               {"place", "texel"},
                                               {"outside", "border_point"},
                                               {"min_radius_px", "0"},
                                               {"min_tap_px", "0"},
                                               {"normals", "depth"},
                                               {"depth", "surface"},  // no format of its own
                                               {"steepest_area", "0"},
                                               {"pyramid_filter", "rotated_grid"},
                                               {"log2_switch", "3"},
                                               {"coarsest_level", "5"},
                                               {"pyramid", "on"},
                                               {"quads", "on"},
                                               {"quad_threshold_m", "0.02"}});

TEST(Presets, SaoSupplement2012) {
    ExpectAll("sao-supplement2012", kSupplement);
}

TEST(Presets, SaoPaper) {
    ExpectAll("sao-paper", Over(kSupplement, {{"falloff", "equation_1"},
                                              {"bias_m", "0"},
                                              {"bias_per_depth", "0.001"},
                                              {"samples", "9"},
                                              {"full_turn_rad", "6.283185307179586"},
                                              {"hash", "c_precedence"},
                                              {"phi", "exact"},
                                              {"rounding", "sum"},
                                              {"filter_z_min_m", "-200"},
                                              {"filter_taps", "3"},
                                              {"filter_stride_px", "3"},
                                              {"filter_lift", "0"},
                                              {"filter_sharpness", "2048"},  // 2^11
                                              {"filter_tiny", "0"},
                                              {"filter_g0", "0.356642"},
                                              {"filter_g1", "0.2394"},
                                              {"filter_g2", "0.07241"},
                                              {"filter_g3", "0.009869"},
                                              {"filter_g4", "0"}}));
}

TEST(Presets, SaoG3d10) {
    ExpectAll("sao-g3d10", Over(kSupplement, {{"radius_m", "0.75"},
                                              {"falloff", "high_quality"},
                                              {"bias_m", "0.023"},
                                              {"epsilon_m2", "0.001"},
                                              {"samples", "19"},
                                              {"turns", "0"},  // by its table
                                              {"outside", "border_depth"},
                                              {"min_radius_px", "3"},
                                              {"min_tap_px", "0.75"},
                                              {"normals", "shading"},
                                              {"steepest_area", "6e-5"},
                                              {"pyramid_filter", "rotated_grid_g3d10"},
                                              {"quads", "off"},
                                              {"packing", "off"},
                                              {"filter_z_min_m", "-1000"},
                                              {"filter_normals", "on"},
                                              {"filter_planes", "on"}}));
}

TEST(Presets, Alchemy) {
    ExpectAll("alchemy", Over(kSupplement, {{"falloff", "equation_1"},
                                            {"bias_m", "0"},
                                            {"bias_per_depth", "0.001"},
                                            {"samples", "12"},
                                            {"turns", "0"},
                                            {"pattern", "sunflower"},
                                            {"full_turn_rad", "6.283185307179586"},
                                            {"hash", "c_precedence"},
                                            {"phi", "exact"},
                                            {"normals", "face"},
                                            {"coarsest_level", "0"},
                                            {"pyramid", "off"},
                                            {"quads", "off"},
                                            {"packing", "off"},
                                            {"filter_z_min_m", "-200"},
                                            {"filter_taps", "6"},  // 13 x 13
                                            {"filter_stride_px", "1"},
                                            {"filter_lift", "0"},
                                            {"filter_sharpness", "2048"},
                                            {"filter_tiny", "0"},
                                            {"filter_g0", "0.11122"},
                                            {"filter_g1", "0.107798"},
                                            {"filter_g2", "0.098151"},
                                            {"filter_g3", "0.083953"},
                                            {"filter_g4", "0.067458"},
                                            {"filter_g5", "0.05092"},
                                            {"filter_g6", "0.036108"}}));
}

const Texts kSlices = Over(
    kCommonFilter,
    {{"radius_m", "1"}, {"spread", "screen"}, {"jitter", "on"}, {"shading_normals", "off"}});

TEST(Presets, Hbao) {
    ExpectAll("hbao", Over(kSlices, {{"samples", "32"},
                                     {"slices", "4"},
                                     {"steps", "4"},
                                     {"step_power", "1"},
                                     {"bias_rad", "0"},
                                     {"strength", "1"},
                                     {"attenuate", "on"}}));
}

const Texts kXeGtao = Over(kSlices, {{"samples", "18"},  // preset High: 3 slices of 2 x 3
                                     {"slices", "3"},
                                     {"steps", "3"},
                                     {"step_power", "2"},
                                     {"radius_multiplier", "1.457"},
                                     {"falloff_start", "0.385"},  // 1 - 0.615
                                     {"fade", "tangent_plane"},
                                     {"thickness_blend", "0"},
                                     {"length_lift", "0.05"},
                                     {"power", "2.2"},
                                     {"least", "0.03"},
                                     {"normalize", "off"}});

TEST(Presets, GtaoOfXeGtao) {
    ExpectAll("gtao-xegtao", kXeGtao);
}

TEST(Presets, GtaoOfThePaper) {
    ExpectAll("gtao-paper", Over(kXeGtao, {{"samples", "12"},
                                           {"slices", "1"},
                                           {"steps", "6"},
                                           {"step_power", "1"},
                                           {"radius_multiplier", "1"},
                                           {"fade", "behind"},
                                           {"length_lift", "0"},
                                           {"power", "1"},
                                           {"least", "0"}}));
}

TEST(Presets, GtaoHard) {
    ExpectAll("gtao-hard", Over(kXeGtao, {{"radius_multiplier", "1"},
                                          {"falloff_start", "1"},
                                          {"length_lift", "0"},
                                          {"power", "1"},
                                          {"least", "0"},
                                          {"normalize", "on"}}));
}

TEST(Presets, Bitmasks) {
    const Texts published = Over(kSlices, {{"samples", "36"},
                                           {"slices", "3"},
                                           {"steps", "6"},
                                           {"step_power", "2"},
                                           {"thickness_m", "0.5"},
                                           {"sectors", "32"},
                                           {"measure", "uniform"},
                                           {"ends", "ceil"},
                                           {"normalize", "off"}});
    ExpectAll("bitmask", published);
    ExpectAll("bitmask-cosine", Over(published, {{"measure", "cosine"}, {"ends", "round"}}));
}

// What each means to compute, by its own equations: SAO's by the factor that a tap loses with its
// distance v (eq. 1, A and D: none within the disc; B: (r^2 - v^2)^3; C and high quality: 1 - v^2 / r^2),
// HBAO's attenuation 1 - v^2 / r^2, GTAO's fade from a share of r on. XeGTAO's longer reach was fitted
// to what is hard.
TEST(Presets, AreScoredAgainstTheTruthOfTheirFalloff) {
    const auto falloff = [](const char* name, const KnobValues& values) {
        return FindTechnique(name).with(values).falloff;
    };
    EXPECT_EQ(falloff("sao-paper", {}), Falloff::kHard);
    EXPECT_EQ(falloff("sao-supplement2012", {}), Falloff::kSao);
    EXPECT_EQ(falloff("sao-g3d10", {}), Falloff::kQuadratic);
    EXPECT_EQ(falloff("alchemy", {}), Falloff::kHard);
    EXPECT_EQ(falloff("hbao", {}), Falloff::kQuadratic);
    EXPECT_EQ(falloff("hbao", {{"attenuate", 0}}), Falloff::kHard);
    EXPECT_EQ(falloff("gtao-paper", {}), Falloff::kFarEnd);
    EXPECT_EQ(falloff("gtao-paper", {{"falloff_start", 1}}), Falloff::kHard);
    EXPECT_EQ(falloff("gtao-xegtao", {}), Falloff::kHard);
    EXPECT_EQ(falloff("gtao-hard", {}), Falloff::kHard);
    EXPECT_EQ(falloff("bitmask", {}), Falloff::kHard);
    EXPECT_EQ(falloff("bitmask-cosine", {}), Falloff::kHard);
    const Knob& choice =
        KnobNamed(FindTechnique("sao-supplement2012").description, "falloff", "test");
    const std::map<std::string, Falloff> by_name{
        {"equation_1", Falloff::kHard}, {"a", Falloff::kHard},
        {"b", Falloff::kSao},           {"c", Falloff::kQuadratic},
        {"d", Falloff::kHard},          {"high_quality", Falloff::kQuadratic}};
    EXPECT_EQ(choice.choices.size(), by_name.size());
    for (const auto& [name, expected] : by_name) {
        EXPECT_EQ(falloff("sao-supplement2012", {{"falloff", ValueOfText(choice, name, "")}}),
                  expected)
            << name;
    }
}

}  // namespace
}  // namespace plumb
