// Light by the way it came: at which bounce a walk through the scene escapes to the sky.
//
//       E(rho) = Sum_k p_k rho^k            p_k: share of walks that escape at bounce k
//
// A walk starts at the receiver in a cosine-weighted direction and goes on in one from
// everything that it meets. Under a unit white sky with one albedo, it brings back rho^k if it
// escapes after k surfaces. So every walk is made once with rho = 1, nothing is cut by
// roulette, and counts of escapes by bounce hold the answer for every albedo: p_0 = V, p_k =
// E_k, and what does not add up to 1 is named:
//
//       Sum_{k <= K} p_k + under way after bounce K + lost = 1              exactly, in counts
//       Sum_k p_k rho^k  <=  E(rho)  <=  the same + rho^(K+1) under way + lost
//
// Source   ours after the form of [Mayaux18 eq. 5]; cosine sampling makes every weight 1.
// Symbols  V, E_k, E(rho), rho as in core/conventions.h; K the last bounce followed.
// Beware   One albedo for the whole scene. The variance of E(rho) does not grow with rho, as
//          that of walks absorbed with 1 - rho would fall.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh.h"
#include "core/monitor.h"
#include "core/visibility.h"
#include "rays/ray_caster.h"
#include "truth/receiver.h"
#include "truth/replicates.h"
#include "truth/sky.h"

namespace plumb {

struct WalkOptions {
    NetSampling sampling;
    int bounces = 20;  ///< K. [0, 10000]
    Sky sky = Sky::kAllAround;
    /// Whether surfaces reflect on their backs too. If not, none should be met from there (in a
    /// closed scene, or a height field seen from above): a walk that is, by the rounding of
    /// where rays start, sets out once more, and is lost if that does not help.
    bool two_sided = true;
};

/// Throws Error, naming field, value and rule.
void Validate(const WalkOptions& options);

/// Walks of every receiver and net by their end.
class EscapeCounts {
  public:
    EscapeCounts(std::int64_t receivers, int replicates, int bounces, std::int64_t points);

    std::int64_t Receivers() const { return receivers_; }
    int Replicates() const { return replicates_; }
    int Bounces() const { return bounces_; }
    std::int64_t Points() const { return points_; }

    /// Walks that escaped at bounce 0 ... K, then those under way, then those lost.
    std::span<std::uint32_t> Row(std::int64_t receiver, int replicate);
    std::span<const std::uint32_t> Row(std::int64_t receiver, int replicate) const;

    /// p_k = E_k; p_0 = V. 0 <= k <= K.
    Measured Bounce(std::int64_t receiver, int k, double confidence = kConfidence) const;

    /// Shares of walks still under way after bounce K, and lost.
    Measured UnderWay(std::int64_t receiver, double confidence = kConfidence) const;
    Measured LostShare(std::int64_t receiver, double confidence = kConfidence) const;

    /// E(rho). The value is the middle of the bracket above; the interval holds all of it.
    Measured Total(std::int64_t receiver, Albedo rho, double confidence = kConfidence) const;

    /// By reason, over all receivers.
    Lost lost;

    /// Adds later points of the same nets.
    void Merge(const EscapeCounts& later);

  private:
    Measured Column(std::int64_t receiver, int column, double confidence) const;

    std::int64_t receivers_;
    int replicates_, bounces_;
    std::int64_t points_;
    std::vector<std::uint32_t> counts_;
};

/// Cost: one ray a walk and surface met. Memory: 4 (K + 3) R bytes a receiver.
EscapeCounts WalkToTheSky(const RayCaster& caster, const Mesh& mesh,
                          std::span<const Receiver> receivers, const WalkOptions& options,
                          Monitor& monitor = SilentMonitor());

}  // namespace plumb
