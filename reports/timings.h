// Seconds and bytes of a run: the only figures of a report that differ from run to run.
//
// They stand in a section of their own, which a caller that wants the same bytes again leaves
// empty.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace plumb {

struct StageTiming {
    std::string map;
    std::string stage;  ///< "links", "bounces", "histograms", "fits", ...
    double seconds = 0;
};

struct Timings {
    std::vector<StageTiming> stages;
    double peak_memory_bytes = 0;        ///< 0 = not measured.
    double machine_rays_per_second = 0;  ///< Raw rays of this machine, same run. 0 = none.
    int threads = 0;

    bool Empty() const { return stages.empty(); }
};

nlohmann::ordered_json ToJson(const Timings& timings);

}  // namespace plumb
