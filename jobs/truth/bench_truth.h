// The speed and the certainty of the path tracer, in one run: beside this machine's own Embree, in
// a furnace, and against independent sampling.
#pragma once

#include <vector>

#include "core/run_context.h"
#include "jobs/truth/load_scene.h"
#include "reports/document.h"

namespace plumb {

struct TruthBenchSettings {
    std::string camera;                      ///< Empty = the scene's first.
    int width_px = 960, height_px = 540;     ///< [1, 65536]
    int pixel_rows = 68;                     ///< Of the picture, evenly spread. [1, height]
    std::vector<int> threads = {1, 2};       ///< Each >= 1.
    int rounds = 5;                          ///< After one that warms up. [1, ...)
    std::int64_t furnace_paths = 1'000'000;  ///< Rounded up to whole batches; 0 = none. >= 0
    std::int64_t reference_rays = 131'072;   ///< A receiver. A power of two >= 64.
};

doc::Document BenchTruth(const LoadedScene& loaded, const TruthBenchSettings& settings,
                         const RunContext& run);

}  // namespace plumb
