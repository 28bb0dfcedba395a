#include "screen_space/horizon/gtao.h"

#include <algorithm>

#include "techniques/filter_knobs.h"
#include "techniques/slice_knobs.h"

namespace plumb::families {
namespace {

struct Turned {
    GtaoOptions gtao;
    double radius_multiplier = 1;
};
using O = Filtered<Turned>;

BoundKnobs<Turned> OwnKnobs() {
    using T = Turned;
    return {
        Number<T>(
            "radius_multiplier", "", "", {0.1, 10}, "Reach searched, as a share of r",
            [](auto& o) -> auto& { return o.radius_multiplier; }),
        Number<T>(
            "falloff_start", "", "", {0, 1},
            "Share of the reach from which on samples count less; 1 = cut off",
            [](auto& o) -> auto& { return o.gtao.falloff_start; }),
        Choice<T>(
            "fade", {"tangent_plane", "behind"}, "To what the horizon of a far sample is drawn",
            [](auto& o) -> auto& { return o.gtao.fade; }),
        Number<T>(
            "thickness_blend", "", "", {0, 1, false, true},
            "How far a lower sample draws the horizon back; 0 = all is thick",
            [](auto& o) -> auto& { return o.gtao.thickness_blend; }),
        Number<T>(
            "length_lift", "", "", {0, 1},
            "Share by which the projected normal's length is drawn to 1",
            [](auto& o) -> auto& { return o.gtao.length_lift; }),
        Number<T>(
            "power", "", "", {0.1, 10}, "Of the visibility",
            [](auto& o) -> auto& { return o.gtao.power; }),
        Number<T>(
            "least", "", "", {0, 1}, "Visibility at least",
            [](auto& o) -> auto& { return o.gtao.least; }),
        Switch<T>(
            "normalize", "Divided by the open slices: an open plane is 1 at every pixel",
            [](auto& o) -> auto& { return o.gtao.normalize; })};
}

// [Jimenez16]: 12 samples a pixel, horizons that fade to -1. What our sources do not tell is ours:
// one slice, since neighbours turn theirs and the filter joins them; even steps; all is thick; the
// start of the falloff is XeGTAO's.
Turned Paper() {
    Turned paper;
    paper.gtao.sampling = {.slices = 1, .steps = 6, .step_power = 1};
    paper.gtao.falloff_start = 0.385;
    paper.gtao.fade = HorizonFade::kBehind;
    return paper;
}

// The preset High of its shader. Not its own: noise, mips of depth and denoiser are those of the
// other techniques here; the first sample lies 1 px away, not 1.3; no fade-out below 10 px.
Turned XeGtao() {
    Turned xegtao;
    xegtao.radius_multiplier = 1.457;
    xegtao.gtao.sampling = {.slices = 3, .steps = 3, .step_power = 2};
    xegtao.gtao.falloff_start = 1 - 0.615;
    xegtao.gtao.fade = HorizonFade::kTangentPlane;
    xegtao.gtao.length_lift = 0.05;
    xegtao.gtao.power = 2.2;
    xegtao.gtao.least = 0.03;
    return xegtao;
}

// Ours: what V within r asks for.
Turned Hard() {
    Turned hard;
    hard.gtao.sampling = {.slices = 3, .steps = 3, .step_power = 2};
    hard.gtao.falloff_start = 1;
    hard.gtao.normalize = true;
    return hard;
}

void Run(const O& o, const TechniqueInput& in, const PassObserver& observer) {
    GtaoOptions options = o.sampling.gtao;
    options.sampling.radius_m =
        std::clamp(options.sampling.radius_m * o.sampling.radius_multiplier, 1e-4, 1e7);
    const PixelRect where = ComputedRect(in.gbuffer.view, o.filter);
    RunFilter(in.gbuffer, o.filter, Gtao(in.gbuffer, options, where), observer);
}

// XeGTAO's larger reach was fitted so that what it says is V within r itself.
Falloff FalloffOfTurned(const O& o) {
    const bool fades = o.sampling.gtao.falloff_start < 1 && o.sampling.radius_multiplier == 1;
    return fades ? Falloff::kFarEnd : Falloff::kHard;
}

}  // namespace

std::vector<PictureTechnique> gtao() {
    const BoundKnobs<Turned> knobs =
        Together(Within<Turned>(
                     SliceKnobs(), [](auto& o) -> auto& { return o.gtao.sampling; }),
                 OwnKnobs());
    const Behaviour<O> behaviour{
        FalloffOfTurned, [](const O& o) { return SamplesOf(o.sampling.gtao.sampling); }, Run};
    const auto one = [&](std::string name, std::string what, const Turned& published) {
        return MakeTechnique<O>({.name = std::move(name),
                                 .family = "gtao",
                                 .paper = "Jimenez16",
                                 .what = std::move(what)},
                                {.sampling = published}, FilteredKnobs(knobs), behaviour);
    };
    return {one("gtao-paper", "Ground-truth ambient occlusion: cosine visibility, 12 lookups",
                Paper()),
            one("gtao-xegtao", "The same with the constants of XeGTAO, fitted to V within r",
                XeGtao()),
            one("gtao-hard",
                "The same cut off hard at r, every pixel divided by its open slices", Hard())};
}

}  // namespace plumb::families
