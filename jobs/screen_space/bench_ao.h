// The speed of SAO and AlchemyAO at the sizes of the paper, in one run.
//
// Whole techniques as the supplement has them; sampling passes alone with 9 taps (figure 5),
// AlchemyAO's with its 12, at a small and at the given radius, with and without the pyramid.
//
// Source   [McGuire12] tables 2 and 3, figure 5.
#pragma once

#include <vector>

#include "core/run_context.h"
#include "jobs/screen_space/ao_times.h"
#include "reports/document.h"

namespace plumb {

struct AoBenchSettings {
    double radius_m = 1.5;
    int rounds = 7;  ///< After one that warms up. [1, 1000]
    std::vector<TimedSize> sizes = {{1280, 720, 128}, {1920, 1080, 192}, {2560, 1600, 256}};
};

/// Throws Error, naming field, value and rule.
void Validate(const AoBenchSettings& settings);

doc::Document BenchAo(const Scene& scene, const Camera& camera, const AoBenchSettings& settings,
                      const RunContext& run);

}  // namespace plumb
