// The speed of the reference rasterizer against this machine's own memory, in one run: every view
// of a scene on all threads, beside copying its depth and triangle numbers; and right triangles of
// one size that share no vertex, each nearer than the ones before, to depth alone on one thread,
// beside copying 4 bytes a drawn pixel.
#pragma once

#include <vector>

#include "core/run_context.h"
#include "core/scene.h"
#include "reports/document.h"

namespace plumb {

struct RasterBenchSettings {
    int width_px = 1920, height_px = 1080;
    int rounds = 7;  ///< After one that warms up. [1, ...)
    std::vector<double> legs_px = {1, 10, 25, 50, 100, 200, 500};
};

/// All cameras of the scene, then triangles of each size.
doc::Document BenchRaster(const Scene& scene, const RasterBenchSettings& settings,
                          const RunContext& run);

}  // namespace plumb
