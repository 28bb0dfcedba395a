// Light as the scene really has it: albedos that vary, textures, the sky, lights with shadows.
//
//       E(x_0)  =  D(x_0) + mean over walks of Sum_k T_k D(x_k) + T_K L_sky(w_K)
//       T_k     =  Prod_{j=1..k} rho(x_j)                      per colour
//       D(x)    =  Sum_i s_i E_i(x) max(0, <n, l_i>)           lights reached without obstacle
//
// A walk x_0, x_1, ... goes on in a cosine-weighted direction from everything that it meets and
// ends where it escapes to the sky after K surfaces. Its weight is the product of the albedos on
// the way: at one albedo these are the walks of truth/escape_walk.h, number by number. From
// bounce `roulette_from` on, a walk goes on with the probability q = its largest T and divides
// T by it, which leaves the mean as it is; before that nothing is left to chance.
//
// Symbols  rho albedo, n face normal on the side that was met, L_sky radiance of the sky, E_i,
//          l_i, s_i as in core/shading.h. All irradiances divided by pi.
// Beware   Face normals, not shading normals: light does not know of those. Surfaces reflect on
//          both sides. The sky's picture is not sampled by its brightness: a small sun in it
//          makes noise, which the errors show; as a directional light it makes none.
#pragma once

#include <cstdint>
#include <span>

#include "core/monitor.h"
#include "core/scene.h"
#include "rays/ray_caster.h"
#include "truth/receiver.h"
#include "truth/replicates.h"
#include "truth/rgb_sums.h"
#include "truth/sky.h"

namespace plumb {

struct IrradianceOptions {
    NetSampling sampling;
    int roulette_from = 16;  ///< [1, 10000]
    int max_bounces =
        4096;  ///< What is still under way then is cut off, and counted. [1, 10000]
};

/// Throws Error, naming field, value and rule.
void Validate(const IrradianceOptions& options);

struct IrradianceSums {
    RgbSums sums;
    Lost lost;
    std::int64_t cut =
        0;  ///< Walks of weight > 0 that max_bounces ended: their rest is missing.

    /// Adds later points of the same nets.
    void Merge(const IrradianceSums& later) {
        sums.Merge(later.sums);
        lost += later.lost;
        cut += later.cut;
    }
};

/// Cost: one ray a surface met, and one more for every light in front of it.
IrradianceSums MeasureIrradiance(const RayCaster& caster, const Scene& scene,
                                 std::span<const Receiver> receivers,
                                 const IrradianceOptions& options,
                                 Monitor& monitor = SilentMonitor());

}  // namespace plumb
