#include "screen_space/horizon/hbao.h"

#include <numbers>

#include "techniques/filter_knobs.h"
#include "techniques/slice_knobs.h"

namespace plumb::families {

std::vector<PictureTechnique> hbao() {
    using H = HbaoOptions;
    using O = Filtered<H>;
    const BoundKnobs<H> own{Number<H>(
                                "bias_rad", "", "rad", {0, std::numbers::pi / 2, false, true},
                                "Angle by which the horizon must rise",
                                [](auto& o) -> auto& { return o.bias_rad; }),
                            Number<H>(
                                "strength", "", "", {0, 100}, "Factor on the occlusion",
                                [](auto& o) -> auto& { return o.strength; }),
                            Switch<H>(
                                "attenuate", "What is farther away counts less: 1 - d^2 / r^2",
                                [](auto& o) -> auto& { return o.attenuate; })};
    const BoundKnobs<H> knobs =
        Together(Within<H>(
                     SliceKnobs(), [](auto& o) -> auto& { return o.sampling; }),
                 own);
    const Behaviour<O> behaviour{
        [](const O& o) { return o.sampling.attenuate ? Falloff::kQuadratic : Falloff::kHard; },
        [](const O& o) { return SamplesOf(o.sampling.sampling); },
        [](const O& o, const TechniqueInput& in, const PassObserver& observer) {
            const PixelRect where = ComputedRect(in.gbuffer.view, o.filter);
            RunFilter(in.gbuffer, o.filter, Hbao(in.gbuffer, o.sampling, where), observer);
        }};
    return {MakeTechnique<O>({.name = "hbao",
                              .family = "hbao",
                              .paper = "Bavoil08",
                              .what = "Horizon-based ambient occlusion: uniform in solid angle",
                              .knobs = {}},
                             {}, FilteredKnobs(knobs), behaviour)};
}

}  // namespace plumb::families
