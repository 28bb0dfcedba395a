// The light on one surface, with its files: maps, histograms, page.
#pragma once

#include <filesystem>
#include <vector>

#include "core/run_context.h"
#include "jobs/light/simulate_surface.h"
#include "jobs/light/surface.h"
#include "reports/simulate_report.h"

namespace plumb {

struct SimulateJob {
    SimulateSettings settings;
    std::vector<double> albedo;        ///< None, one, or R, G, B: total light for it. [0, 1]
    std::filesystem::path albedo_map;  ///< A picture, one pixel a texel; empty = none.
    bool sweep_amplitude = false;
    bool write_maps = true;  ///< light.exr
};

/// Bounces that light.exr holds at most; the histograms hold all.
inline constexpr int kMappedBounces = 20;

/// Simulates and writes maps, histograms and pictures into the folder of the run. Throws Error if an albedo is outside [0, 1]
/// or the albedo map has another size than the height map.
SimulateReport Simulate(const Surface& surface, const SimulateJob& job, const RunContext& run);

}  // namespace plumb
