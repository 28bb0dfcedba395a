// The speed of the light simulation against this machine's own limits, in one run: casting the
// same rays by the facet walk and by Embree (rtcIntersect1, quads, ROBUST) on one thread; whole
// simulations by both methods; one bounce over its links beside a copy of as many bytes; error
// of V against time.
#pragma once

#include <functional>

#include "core/run_context.h"
#include "core/time_in_turns.h"
#include "jobs/light/surface.h"
#include "reports/document.h"

namespace plumb {

struct LightBenchSettings {
    int slices = 32, rays = 256;  ///< A facet, of the two simulations.
    int bounces = 20;
    int casting_rays = 64;                ///< A facet, of the casting bench.
    std::int64_t casting_facets = 16384;  ///< Spread over the map.
    int rounds = kTimedRounds;            ///< After one that warms up. [1, ...)
    bool study_convergence = true;
};

/// Peak memory of the process in bytes; the caller knows how to ask the system.
using PeakMemory = std::function<double()>;

doc::Document BenchLight(const Surface& surface, const LightBenchSettings& settings,
                         const PeakMemory& peak_memory, const RunContext& run);

}  // namespace plumb
