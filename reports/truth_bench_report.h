// How fast and how sure the path tracer is: against this machine's own Embree, a furnace and
// independent sampling.
//
// What is compared is measured in turns within one run; ratios are medians over its rounds.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <string>
#include <vector>

namespace plumb {

/// V of a view beside nothing but Embree's own calls over the same rays.
struct TruthSpeed {
    int threads = 0;
    double rays_per_second = 0;         ///< Of the measurement: samples, rays, counts.
    double bare_stream_per_second = 0;  ///< rtcOccluded1M, as many rays at once.
    double bare_single_per_second = 0;  ///< rtcOccluded1, one after the other.
    double share = 0;                   ///< Of the bare stream's speed; median of the rounds.
    double share_low = 0, share_high = 0;
};

/// Walks over a closed, noisy height field at albedo 1: each should come back.
struct TruthFurnace {
    int cells = 0;
    std::int64_t paths = 0, bounces = 0;
    std::int64_t lost = 0;       ///< NaN, met from behind, or gone where no sky is.
    std::int64_t rescued = 0;    ///< Got behind a surface, noticed, and started again.
    std::int64_t under_way = 0;  ///< After the last bounce followed; not lost.
    double seconds = 0;
    double Deficit() const { return paths == 0 ? 0 : double(lost) / double(paths); }
};

/// Root mean square error of V against a reference, by samples a receiver.
struct TruthConvergence {
    struct Point {
        std::int64_t rays = 0;
        double nets = 0, independent = 0;
    };
    std::int64_t receivers = 0, reference_rays = 0;
    std::vector<Point> points;
    double slope_nets = 0, slope_independent = 0;  ///< Of log error over log rays.
};

struct TruthBench {
    std::string scene, camera;
    int width_px = 0, height_px = 0, rays_per_pixel = 0, rounds = 0;
    std::int64_t triangles = 0, receivers = 0;
    std::int64_t differing_rays = 0;  ///< Met by one of both ways and not by the other.
    std::vector<TruthSpeed> speeds;   ///< One a number of threads.
    TruthFurnace furnace;
    TruthConvergence convergence;
};

nlohmann::ordered_json ToJson(const TruthBench& bench);

/// The same as the text of a file; see reports/json_text.h.
std::string ToJsonText(const TruthBench& bench);
void WriteTable(std::ostream& out, const TruthBench& bench);

}  // namespace plumb
