// Visibility limited to a neighbourhood, and how far one sees: means over distances.
//
//       X = 1/pi Int g(d(w)) <n, w> dw          d(w): distance met in direction w, or infinite
//
//       hard        g = 0 for d < r, else 1
//       linear      g = min(1, d / r): X r is the mean free distance, cut off at r
//       SAO         g = 1 - (1 - d^2 / r^2)^3 for d < r, else 1
//       quadratic   g = min(1, d^2 / r^2)           HBAO's, and SAO's of G3D 10
//       far end     g = (d/r - a) / (1 - a) in [0, 1], a = 0.385: GTAO's, near things count whole
//
// g(infinity) = 1, so X lies in [0, 1], and is 1 where nothing is near. The hard one is V of a
// world cut off at r; it tends to V as r grows.
//
// Source   SAO's falloff: [McGuire12] (r^2 - v.v)^3 / r^6, without its own other factors. The
//          last two: as those methods weigh a sample by its distance.
// Symbols  r reach (m), d distance along the ray (m), n unit normal, w direction.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/falloff.h"
#include "core/mesh.h"
#include "core/monitor.h"
#include "rays/ray_caster.h"
#include "truth/receiver.h"
#include "truth/replicates.h"

namespace plumb {

inline constexpr double kFarEndStart = 0.385;  ///< a, as GTAO is shipped.

/// g(d): how open a direction counts in which something is met at d. Monotone, g(r) = 1.
double OpennessAt(double d_m, double reach_m, Falloff falloff);

struct NearOptions {
    NetSampling sampling;
    double reach_m = 1;  ///< r. (0, infinity)
    Falloff falloff = Falloff::kHard;
};

/// Throws Error, naming field, value and rule.
void Validate(const NearOptions& options);

/// Sums of g over the points of every receiver and net.
struct NearSums {
    int replicates = 0;
    std::int64_t points = 0;
    std::vector<double> sum;           ///< [receiver * replicates + replicate]
    std::vector<SampleSpread> spread;  ///< [receiver], of the g.

    std::int64_t Receivers() const { return std::int64_t(sum.size()) / replicates; }
    Measured Of(std::int64_t receiver, double confidence = kConfidence) const;

    /// Adds later points of the same nets.
    void Merge(const NearSums& later);
};

NearSums MeasureNear(const RayCaster& caster, const Mesh& mesh,
                     std::span<const Receiver> receivers, const NearOptions& options,
                     Monitor& monitor = SilentMonitor());

/// The same for several falloffs, from one set of rays: element k is of falloffs[k], to the bit
/// what MeasureNear gives with that one.
std::vector<NearSums> MeasureNearEach(const RayCaster& caster, const Mesh& mesh,
                                      std::span<const Receiver> receivers,
                                      const NearOptions& options,
                                      std::span<const Falloff> falloffs,
                                      Monitor& monitor = SilentMonitor());

}  // namespace plumb
