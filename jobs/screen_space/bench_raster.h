// The speed of the reference rasterizer against this machine's own memory, in one run.
#pragma once

#include <vector>

#include "core/monitor.h"
#include "core/scene.h"
#include "jobs/light/simulate_surface.h"
#include "reports/raster_bench_report.h"

namespace plumb {

struct RasterBenchSettings {
    int width_px = 1920, height_px = 1080;
    int rounds = 7;  ///< After one that warms up. [1, ...)
    std::vector<double> legs_px = {1, 10, 25, 50, 100, 200, 500};
};

/// All cameras of the scene, then triangles of each size.
RasterBench BenchRaster(const Scene& scene, const RasterBenchSettings& settings,
                        const Clock& clock, Monitor& monitor = SilentMonitor());

}  // namespace plumb
