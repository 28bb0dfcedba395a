#include "screen_space/peers/gtao.h"

#include "techniques/filter_knobs.h"
#include "techniques/slice_knobs.h"

namespace plumb::families {

std::vector<PictureTechnique> gtao() {
    using G = GtaoOptions;
    using O = Filtered<G>;
    const BoundKnobs<G> own{
        Number<G>(
            "falloff_start", "", "", {0, 1},
            "Share of the radius from which on samples count less; 1 = cut off at r",
            [](auto& o) -> auto& { return o.falloff_start; }),
        Number<G>(
            "thickness_blend", "", "", {0, 1, false, true},
            "How far a lower sample draws the horizon back; 0 = all is thick",
            [](auto& o) -> auto& { return o.thickness_blend; }),
        Switch<G>(
            "normalize", "Divided by the open slices: an open plane is 1 at every pixel",
            [](auto& o) -> auto& { return o.normalize; })};
    const BoundKnobs<G> knobs =
        Together(Within<G>(
                     SliceKnobs(), [](auto& o) -> auto& { return o.sampling; }),
                 own);
    const Behaviour<O> behaviour{
        [](const O& o) {
            return o.sampling.falloff_start < 1 ? Falloff::kFarEnd : Falloff::kHard;
        },
        [](const O& o) { return SamplesOf(o.sampling.sampling); },
        [](const O& o, const TechniqueInput& in, const PassObserver& observer) {
            const PixelRect where = ComputedRect(in.gbuffer.view, o.filter);
            RunFilter(in.gbuffer, o.filter, Gtao(in.gbuffer, o.sampling, where), observer);
        }};
    O hard;
    hard.sampling.falloff_start = 1;
    hard.sampling.normalize = true;
    return {
        MakeTechnique<O>({.name = "gtao",
                          .family = "gtao",
                          .paper = "Jimenez16",
                          .what = "Ground-truth ambient occlusion: cosine visibility",
                          .knobs = {}},
                         {}, FilteredKnobs(knobs), behaviour),
        MakeTechnique<O>(
            {.name = "gtao-hard",
             .family = "gtao",
             .paper = "Jimenez16",
             .what = "GTAO cut off hard at the radius, every pixel divided by its open slices",
             .knobs = {}},
            hard, FilteredKnobs(knobs), behaviour)};
}

}  // namespace plumb::families
