// Error of the simulation against its run time: slices beside rays, each against one reference.
#pragma once

#include "core/monitor.h"
#include "core/time_in_turns.h"
#include "heightfield/height_field.h"
#include "jobs/light/simulate_surface.h"
#include "reports/convergence.h"

namespace plumb {

struct ConvergenceSettings {
    std::vector<int> slices = {4, 8, 16, 32};
    std::vector<int> rays = {16, 64, 256};
    int reference_slices = 256;  ///< With another seed than those that are judged.
    int rounds = kTimedRounds;   ///< Of each, in turns, after one that warms up. [1, ...)
};

/// Simulates `field` with each count. The errors are root mean squares over facets
/// against the reference, whose own error is smaller by the square root of the counts' ratio or
/// more; its facets are cut three times as fine, so that what the cut costs is seen.
Convergence StudyConvergence(const std::string& name, const HeightField& field,
                             const ConvergenceSettings& settings, const Clock& clock,
                             Monitor& monitor = SilentMonitor());

}  // namespace plumb
