#include "techniques/filter_knobs.h"
#include "techniques/ray_traced_visibility.h"

namespace plumb::families {

std::vector<PictureTechnique> rays() {
    using R = RayTracedOptions;
    using O = Filtered<R>;
    const BoundKnobs<R> knobs{Number<R>(
                                  "radius_m", "r", "m", {1e-4, 1e7}, "Length of a ray",
                                  [](auto& o) -> auto& { return o.radius_m; }),
                              Whole<R>(
                                  "samples", "N", "", {1, 4096}, "Rays a pixel",
                                  [](auto& o) -> auto& { return o.rays; })};
    const Behaviour<O> behaviour{
        [](const O&) { return Falloff::kHard; }, [](const O& o) { return o.sampling.rays; },
        [](const O& o, const TechniqueInput& in, const PassObserver& observer) {
            R options = o.sampling;
            const BlurOptions& blur = o.filter.blur;
            const bool blurs = o.filter.blur_x || o.filter.blur_y;
            options.margin_px = blurs ? blur.taps_each_side * blur.stride_px : 0;
            RunFilter(in.gbuffer, o.filter,
                      RayTracedVisibility(in.caster, in.scene, in.camera, in.gbuffer, options),
                      observer);
        }};
    std::vector<PictureTechnique> techniques;
    for (const int count : {1, 2, 4, 8}) {
        const std::string number = std::to_string(count);
        techniques.push_back(MakeTechnique<O>(
            {.name = "rays-" + number,
             .family = "rays",
             .paper = "",
             .what = "Ray-traced visibility within r, " + number +
                     (count == 1 ? " ray" : " rays") + " a pixel, then the filter",
             .knobs = {}},
            {.sampling = {.rays = count}}, FilteredKnobs(knobs), behaviour));
    }
    return techniques;
}

}  // namespace plumb::families
