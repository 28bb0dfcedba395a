// How much of the sky a receiver sees: alpha and V.
//
//       alpha = 1/(2 pi) Int v(w) dw          directions uniform over the hemisphere
//       V     = 1/pi Int v(w) <n, w> dw       directions in proportion to the cosine
//
// Counts of open directions over replicated nets; each ray is a yes or a no, so the counts are
// exact and add up in any order.
//
// Symbols  alpha, V as in core/conventions.h; v(w) = 1 if nothing is met before `reach_m`.
// Cost     one occlusion ray a sample; rays of a receiver that is a point go as one stream.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/mesh.h"
#include "core/monitor.h"
#include "rays/ray_caster.h"
#include "truth/receiver.h"
#include "truth/replicates.h"
#include "truth/sky.h"

namespace plumb {

enum class HemisphereWeight { kUniform, kCosine };  ///< alpha or V.

struct OpenSkyOptions {
    NetSampling sampling;
    HemisphereWeight weighting = HemisphereWeight::kCosine;
    double reach_m =
        std::numeric_limits<double>::infinity();  ///< Hits beyond do not count. > 0
    Sky sky = Sky::kAllAround;
};

/// Throws Error, naming field, value and rule.
void Validate(const OpenSkyOptions& options);

/// Open directions of every receiver and net.
struct OpenCounts {
    int replicates = 0;
    std::int64_t points = 0;
    std::vector<std::uint32_t> open;  ///< [receiver * replicates + replicate]
    Lost lost;                        ///< Counted as not open.

    std::int64_t Receivers() const { return std::int64_t(open.size()) / replicates; }
    Measured Of(std::int64_t receiver, double confidence = kConfidence) const;

    /// Adds later points of the same nets.
    void Merge(const OpenCounts& later);
};

OpenCounts CountOpenSky(const RayCaster& caster, const Mesh& mesh,
                        std::span<const Receiver> receivers, const OpenSkyOptions& options,
                        Monitor& monitor = SilentMonitor());

}  // namespace plumb
