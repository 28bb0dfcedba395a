#include "tests/examples/technique/ball_ao.h"

#include "techniques/filter_knobs.h"

namespace plumb::families {

std::vector<PictureTechnique> ball_ao() {
    using B = BallOptions;
    using O = Filtered<B>;
    const BoundKnobs<B> knobs{
        Number<B>(
            "radius_m", "r", "m", {1e-4, 1e7}, "Of the ball",
            [](auto& o) -> auto& { return o.radius_m; }),
        Whole<B>(
            "pairs", "N", "", {1, 2048}, "Of points, each with its mirror image",
            [](auto& o) -> auto& { return o.pairs; })};
    const Behaviour<O> behaviour{
        [](const O&) { return Falloff::kHard; },
        [](const O& o) { return 2 * o.sampling.pairs; },
        [](const O& o, const TechniqueInput& in, const PassObserver& observer) {
            const PixelRect where = ComputedRect(in.gbuffer.view, o.filter);
            RunFilter(in.gbuffer, o.filter, BallOcclusion(in.gbuffer, o.sampling, where),
                      observer);
        }};
    return {MakeTechnique<O>({.name = "ball-ao",
                              .family = "ball_ao",
                              .paper = "Mittring07",
                              .what = "How much of a ball about the receiver is seen empty"},
                             {}, FilteredKnobs(knobs), behaviour)};
}

}  // namespace plumb::families
