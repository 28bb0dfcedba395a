// Ray-traced visibility at a handful of rays a pixel: what the milliseconds of a screen-space
// method would buy without any trick.
//
//       A = share of N cosine-weighted rays of length r that meet nothing
//
// It is made like a technique, not like a truth: from the G-buffer's triangle at the pixel's
// centre, with as few rays as asked for, and noisy. A filter may follow (BlurPass of
// screen_space/sao/sao_passes.h).
//
// Symbols  N rays a pixel, r radius (m).
// Cost     N occlusion rays a pixel.
#pragma once

#include <cstdint>

#include "core/scene.h"
#include "rays/ray_caster.h"
#include "screen_space/gbuffer.h"

namespace plumb {

struct RayTracedOptions {
    double radius_m = 1.5;  ///< r. (0, infinity)
    int rays = 1;           ///< N. [1, 4096]
    std::uint64_t seed = 1;
    int margin_px = 8;  ///< Of the border drawn; the reach of SAO's filter. >= 0
};

/// Throws Error, naming field, value and rule.
void Validate(const RayTracedOptions& options);

/// A of the drawn size, made where it is shown and `margin_px` beyond, where a filter reads; 1
/// elsewhere and where the sky is seen.
Image<float> RayTracedVisibility(const RayCaster& caster, const Scene& scene,
                                 const Camera& camera, const GBuffer& gbuffer,
                                 const RayTracedOptions& options);

}  // namespace plumb
