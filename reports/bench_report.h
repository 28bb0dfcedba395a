// How fast the light simulation is, as ratios that travel between machines.
//
// Every time is the median of the rounds of one run; what is compared is measured in turns
// within that run, so that a machine that slows down slows both.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "reports/convergence.h"

namespace plumb {

/// Casting the same rays by the facet walk and by Embree (rtcIntersect1, quads, ROBUST), one
/// thread.
struct CastingBench {
    std::int64_t rays = 0;
    double walk_rays_per_second = 0, embree_rays_per_second = 0;

    /// Time of the walk over the time of Embree: median over the rounds, and their range.
    double time_ratio = 0, time_ratio_low = 0, time_ratio_high = 0;

    /// Share of the rays that both send to the same cell or to the sky. Embree sees float
    /// coordinates and a surface that ends one tile beyond the middle one, so not quite 1.
    double agreement = 0;
};

/// One whole simulation, all threads.
struct SimulationBench {
    std::string method;  ///< "slices" or "rays".
    int per_facet = 0;
    double links_s = 0, bounces_s = 0, total_s = 0;
    double units_per_second = 0;  ///< Slices or rays a second while links are made.
    std::int64_t links = 0;
    double bytes_per_link = 0;
    double peak_memory_bytes = 0;  ///< Of the process, up to the end of this simulation.
};

struct LightBench {
    std::string map;
    int width_texels = 0, height_texels = 0;
    std::int64_t facets = 0;
    int threads = 0, bounces = 0;
    CastingBench casting;
    std::vector<SimulationBench> simulations;
    double gather_bytes_per_second = 0;  ///< Links streamed by one bounce, all threads.
    double copy_bytes_per_second = 0;    ///< Read + written by a copy of memory, all threads.
    Convergence convergence;             ///< Error of V against time, both methods.
};

nlohmann::ordered_json ToJson(const LightBench& bench);

/// The same as the text of a file; see reports/json_text.h.
std::string ToJsonText(const LightBench& report);
void WriteTable(std::ostream& out, const LightBench& bench);

}  // namespace plumb
