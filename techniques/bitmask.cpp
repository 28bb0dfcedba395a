#include "screen_space/horizon/visibility_bitmask.h"
#include "techniques/filter_knobs.h"
#include "techniques/slice_knobs.h"

namespace plumb::families {

std::vector<PictureTechnique> bitmask() {
    using B = BitmaskOptions;
    using O = Filtered<B>;
    const BoundKnobs<B> own{
        Number<B>(
            "thickness_m", "", "m", {0, kInfinity, true}, "Of everything: light passes behind",
            [](auto& o) -> auto& { return o.thickness_m; }),
        Whole<B>(
            "sectors", "S", "", {1, 64}, "Of a slice",
            [](auto& o) -> auto& { return o.sectors; }),
        Choice<B>(
            "measure", {"uniform", "cosine"}, "What sectors are even in",
            [](auto& o) -> auto& { return o.measure; }),
        Choice<B>(
            "ends", {"ceil", "round"}, "How the ends of what a sample hides are rounded",
            [](auto& o) -> auto& { return o.rounding; }),
        Switch<B>(
            "normalize", "A cosine A divided by the open slices",
            [](auto& o) -> auto& { return o.normalize; })};
    const BoundKnobs<B> knobs =
        Together(Within<B>(
                     SliceKnobs(), [](auto& o) -> auto& { return o.sampling; }),
                 own);
    const Behaviour<O> behaviour{
        [](const O&) { return Falloff::kHard; },
        [](const O& o) { return SamplesOf(o.sampling.sampling); },
        [](const O& o, const TechniqueInput& in, const PassObserver& observer) {
            const PixelRect where = ComputedRect(in.gbuffer.view, o.filter);
            RunFilter(in.gbuffer, o.filter, VisibilityBitmask(in.gbuffer, o.sampling, where),
                      observer);
        }};
    O cosine;
    cosine.sampling.measure = SectorMeasure::kCosine;
    cosine.sampling.rounding = SectorRounding::kRound;
    return {
        MakeTechnique<O>({.name = "bitmask",
                          .family = "bitmask",
                          .paper = "Therrien23",
                          .what = "Visibility bitmask: sectors of a slice, everything of one "
                                  "thickness",
                          .knobs = {}},
                         {}, FilteredKnobs(knobs), behaviour),
        MakeTechnique<O>(
            {.name = "bitmask-cosine",
             .family = "bitmask",
             .paper = "Therrien23",
             .what = "The same with sectors even in cosine and both ends rounded alike",
             .knobs = {}},
            cosine, FilteredKnobs(knobs), behaviour)};
}

}  // namespace plumb::families
