// Seconds of a run: what differs from run to run.
#pragma once

#include <string>
#include <vector>

namespace plumb {

struct StageTiming {
    std::string map;
    std::string stage;  ///< "links", "bounces", "fits", ...
    double seconds = 0;
};

/// In the order in which they ran.
using Timings = std::vector<StageTiming>;

}  // namespace plumb
