#include "techniques/sao.h"

#include "core/names.h"
#include "screen_space/sao/sao_presets.h"
#include "techniques/filter_knobs.h"

namespace plumb {
namespace {

using O = SaoOptions;

BoundKnobs<O> EstimatorKnobs() {
    return {
        Number<O>(
            "radius_m", "r", "m", {1e-4, 1e7}, "Reach in the world",
            [](auto& o) -> auto& { return o.sampling.sao.radius_m; }),
        Choice<O>(
            "falloff", {"equation_1", "a", "b", "c", "d", "high_quality"},
            "What one tap adds: eq. 1, A to D of the supplement's shader, or G3D 10's",
            [](auto& o) -> auto& { return o.sampling.sao.falloff; }),
        Number<O>(
            "bias_m", "beta", "m", {0, 1e7}, "Height of a tap that adds nothing yet",
            [](auto& o) -> auto& { return o.sampling.sao.bias_m; }),
        Number<O>(
            "bias_per_depth", "beta", "", {0, 1e3}, "The same of eq. 1, times the depth",
            [](auto& o) -> auto& { return o.sampling.sao.bias_per_depth; }),
        Number<O>(
            "intensity", "sigma", "m^0, m^1 or m^5 by falloff", {0, 1e30}, "Strength",
            [](auto& o) -> auto& { return o.sampling.sao.intensity; }),
        Number<O>(
            "epsilon_m2", "eps", "m^2", {1e-12, 1e12}, "Keeps a tap at the pixel finite",
            [](auto& o) -> auto& { return o.sampling.sao.epsilon_m2; }),
        Number<O>(
            "exponent", "k", "", {0, 100}, "Contrast of eq. 1",
            [](auto& o) -> auto& { return o.sampling.sao.exponent; }),
        Switch<O>(
            "lift_dark", "A becomes (A^0.2 + 1.2 A^4) / 2.2 (falloffs a to d)",
            [](auto& o) -> auto& { return o.sampling.sao.lift_dark; }),
        Choice<O>(
            "depth", {"surface", "d16", "d24", "d32f", "d32f_reversed"},
            "Format of the depth that is read; surface: a float of z itself",
            [](auto& o) -> auto& { return o.depth; }),
    };
}

BoundKnobs<O> TapKnobs() {
    BoundKnob<O> samples = Whole<O>(
        "samples", "s", "", {1, 4096}, "Taps a pixel; turns follow it if not given",
        [](auto& o) -> auto& { return o.sampling.taps.samples; });
    samples.knob.covers = {"turns"};
    samples.set = [](O& o, double s) {
        o.sampling.taps.samples = int(s);
        o.sampling.taps.turns = 0;
    };
    return {
        samples,
        Whole<O>(
            "turns", "tau", "", {0, 65536}, "Turns of the spiral; 0 = by the table of G3D 10",
            [](auto& o) -> auto& { return o.sampling.taps.turns; }),
        Choice<O>(
            "pattern", {"spiral", "sunflower"}, "Where the taps lie on the disc",
            [](auto& o) -> auto& { return o.sampling.taps.pattern; }),
        Number<O>(
            "full_turn_rad", "", "rad", {6, 7}, "Of the spiral: 2 pi, or 6.28 as shipped",
            [](auto& o) -> auto& { return o.sampling.taps.full_turn_rad; }),
        Choice<O>(
            "hash", {"code", "c_precedence", "xor_first"}, "Reading of eq. 8",
            [](auto& o) -> auto& { return o.sampling.taps.hash; }),
        Choice<O>(
            "phi", {"exact", "reduced", "float32"}, "Arithmetic of the hash's angle",
            [](auto& o) -> auto& { return o.sampling.taps.phi; }),
        Choice<O>(
            "rounding", {"offset", "sum"}, "What is rounded to a whole pixel",
            [](auto& o) -> auto& { return o.sampling.taps.rounding; }),
        Choice<O>(
            "place", {"texel", "level_texel", "tap"}, "Where the depth read is put",
            [](auto& o) -> auto& { return o.sampling.taps.place; }),
        Choice<O>(
            "outside", {"border_point", "border_depth"}, "A tap beyond what is drawn",
            [](auto& o) -> auto& { return o.sampling.taps.outside; }),
        Number<O>(
            "min_radius_px", "", "px", {0, 1e3}, "Radius on screen below which A = 1",
            [](auto& o) -> auto& { return o.sampling.taps.min_radius_px; }),
        Number<O>(
            "min_tap_px", "", "px", {0, 1e3}, "Least distance of a tap",
            [](auto& o) -> auto& { return o.sampling.taps.min_tap_px; }),
        Choice<O>(
            "normals", {"depth", "face", "shading"}, "Where the normal comes from",
            [](auto& o) -> auto& { return o.sampling.normals; }),
        Number<O>(
            "steepest_area", "", "", {0, 1e9},
            "A = 1 where a normal made from depth is steeper; 0 = off",
            [](auto& o) -> auto& { return o.sampling.steepest_area; }),
    };
}

BoundKnobs<O> PyramidKnobs() {
    BoundKnob<O> pyramid{SwitchCalled("pyramid", "Taps far away read coarser levels of depth"),
                         [](const O& o) { return o.sampling.taps.coarsest_level > 0 ? 1 : 0; },
                         [](O& o, double on) {
                             int& coarsest = o.sampling.taps.coarsest_level;
                             if (on == 0) coarsest = 0;
                             if (on != 0 && coarsest == 0)
                                 coarsest = TapOptions().coarsest_level;
                         }};
    pyramid.knob.covers = {"coarsest_level"};
    return {
        Choice<O>(
            "pyramid_filter",
            {"rotated_grid", "rotated_grid_g3d10", "mean", "harmonic_mean", "min", "max"},
            "How four depths become one",
            [](auto& o) -> auto& { return o.sampling.taps.filter; }),
        Whole<O>(
            "log2_switch", "log2 q'", "", {0, 14}, "Level m is read from 2^(m+1) q' on",
            [](auto& o) -> auto& { return o.sampling.taps.log2_switch_px; }),
        Whole<O>(
            "coarsest_level", "", "", {0, 14}, "Of the z pyramid; 0 = no pyramid",
            [](auto& o) -> auto& { return o.sampling.taps.coarsest_level; }),
        pyramid,
    };
}

BoundKnobs<O> QuadKnobs() {
    return {Switch<O>(
                "quads", "A averaged over 2 x 2 pixels of one surface",
                [](auto& o) -> auto& { return o.quad_filter; }),
            Number<O>(
                "quad_threshold_m", "t", "m", {0, 1e7, true}, "Step of depth that parts a quad",
                [](auto& o) -> auto& { return o.quad_threshold_m; })};
}

void Run(const O& options, const TechniqueInput& in, const PassObserver& observer) {
    SaoScratch scratch;
    RunSao(in.gbuffer, options, scratch, observer);
}

}  // namespace

BoundKnobs<SaoOptions> SaoKnobs() {
    BoundKnobs<O> knobs = EstimatorKnobs();
    for (const auto& more : {TapKnobs(), PyramidKnobs(), QuadKnobs(), FilterKnobs()}) {
        knobs = Together(knobs, more);
    }
    return knobs;
}

BoundKnob<SaoOptions> SaoKnob(const std::string& name) {
    const BoundKnobs<O> knobs = SaoKnobs();
    return FindNamed(
        knobs, [](const BoundKnob<O>& bound) { return bound.knob.name; }, name,
        "knob of SAO = " + name);
}

Falloff FalloffOf(SaoFalloffKind kind) {
    switch (kind) {
        case SaoFalloffKind::kSmooth:
            return Falloff::kSao;
        case SaoFalloffKind::kNoDivision:
        case SaoFalloffKind::kHighQuality:
            return Falloff::kQuadratic;
        case SaoFalloffKind::kEquation1:
        case SaoFalloffKind::kHpg12:
        case SaoFalloffKind::kLowContrast:
            break;
    }
    return Falloff::kHard;
}

namespace families {

std::vector<PictureTechnique> sao() {
    const Behaviour<O> behaviour{[](const O& o) { return FalloffOf(o.sampling.sao.falloff); },
                                 [](const O& o) { return o.sampling.taps.samples; }, Run};
    const auto one = [&](std::string name, std::string what) {
        const std::string preset = name.starts_with("sao-") ? name.substr(4) : name;
        return MakeTechnique<O>({.name = name,
                                 .family = "sao",
                                 .paper = "McGuire12",
                                 .what = std::move(what),
                                 .knobs = {}},
                                SaoPresetNamed(preset), SaoKnobs(), behaviour);
    };
    return {one("sao-paper", "Scalable ambient obscurance, constants of the paper's text"),
            one("sao-supplement2012", "The same, constants of the shaders that came with it"),
            one("sao-g3d10", "The same, constants of its last version in G3D 10"),
            one("alchemy", "AlchemyAO, the baseline of SAO: no pyramid, no quads, no packing")};
}

}  // namespace families
}  // namespace plumb
