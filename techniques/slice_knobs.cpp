#include "techniques/slice_knobs.h"

#include <algorithm>
#include <cmath>

namespace plumb {

BoundKnobs<SliceSampling> SliceKnobs() {
    using O = SliceSampling;
    BoundKnob<O> samples = Whole<O>(
        "samples", "", "", {1, 4096},
        "About so many depth lookups a pixel: sets slices and steps",
        [](auto& o) -> auto& { return o.steps; });
    samples.knob.covers = {"slices", "steps"};
    samples.get = [](const O& o) { return double(SamplesOf(o)); };
    samples.set = [](O& o, double wanted) {
        o.steps = std::max(1, int(std::lround(std::sqrt(wanted / 2))));
        o.slices = std::max(1, int(std::lround(wanted / 2 / o.steps)));
    };
    return {
        Number<O>(
            "radius_m", "r", "m", {1e-4, 1e7}, "Reach in the world",
            [](auto& o) -> auto& { return o.radius_m; }),
        samples,
        Whole<O>(
            "slices", "N", "", {1, 4096}, "Of the hemisphere; each has two sides",
            [](auto& o) -> auto& { return o.slices; }),
        Whole<O>(
            "steps", "", "", {1, 65536}, "Samples a side",
            [](auto& o) -> auto& { return o.steps; }),
        Number<O>(
            "step_power", "", "", {0.25, 8}, "Above 1 near samples lie closer together",
            [](auto& o) -> auto& { return o.step_power; }),
        Choice<O>(
            "spread", {"screen", "line_of_sight"}, "What slices are spread evenly about",
            [](auto& o) -> auto& { return o.spread; }),
        Switch<O>(
            "jitter", "Slices turn and steps shift from pixel to pixel",
            [](auto& o) -> auto& { return o.jitter; }),
        Switch<O>(
            "shading_normals", "Interpolated normals instead of the faces'",
            [](auto& o) -> auto& { return o.shading_normals; }),
    };
}

int SamplesOf(const SliceSampling& sampling) {
    return 2 * sampling.slices * sampling.steps;
}

}  // namespace plumb
