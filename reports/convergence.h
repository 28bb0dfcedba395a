// Error of the light simulation against its run time, as the samples of a facet grow.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/measured.h"

namespace plumb {

struct ConvergencePoint {
    std::string method;  ///< "slices" or "rays": one series a method.
    int per_facet = 0;   ///< Slices or rays of a facet.
    Measured seconds;    ///< Of making the links and letting light bounce; see time_in_turns.h.
    double rms_V = 0;    ///< Of V against the reference, over facets.
    double rms_E_half = 0;  ///< Of E(1/2) against the reference, over facets.
    double max_abs_V = 0;   ///< Largest error of V of a facet.
};

struct Convergence {
    std::string map;
    std::string reference;  ///< What the errors are measured against, e.g. "slices, 2048".
    std::int64_t facets = 0;
    int threads = 0;
    double machine_rays_per_second = 0;    ///< Raw rays of this machine, same run. 0 = none.
    std::vector<ConvergencePoint> points;  ///< Ascending in per_facet within a method.
};

nlohmann::ordered_json ToJson(const Convergence& convergence);

}  // namespace plumb
