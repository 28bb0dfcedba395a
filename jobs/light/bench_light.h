// The speed of the light simulation against this machine's own limits, in one run.
#pragma once

#include <functional>

#include "core/monitor.h"
#include "jobs/light/simulate_surface.h"
#include "jobs/light/surface.h"
#include "reports/bench_report.h"

namespace plumb {

struct LightBenchSettings {
    int slices = 32, rays = 256;  ///< A facet, of the two simulations.
    int bounces = 20;
    int casting_rays = 64;                ///< A facet, of the casting bench.
    std::int64_t casting_facets = 16384;  ///< Spread over the map.
    int rounds = 5;                       ///< After one that warms up. [1, ...)
    bool study_convergence = true;
};

/// Peak memory of the process in bytes; the caller knows how to ask the system.
using PeakMemory = std::function<double()>;

LightBench BenchLight(const Surface& surface, const LightBenchSettings& settings,
                      const Clock& clock, const PeakMemory& peak_memory,
                      Monitor& monitor = SilentMonitor());

}  // namespace plumb
