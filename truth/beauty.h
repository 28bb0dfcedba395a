// The picture that anti-aliasing should arrive at: the shading model, averaged over each pixel.
//
//       B(i, j) = Int_0^1 Int_0^1 L(i + x, j + y) dx dy         box filter, one pixel wide
//
// L is core/shading.h where the ray through (i + x, j + y) meets a surface, with hard shadows by
// rays, and the sky's radiance where it meets none. Points of a pixel are those of an
// Owen-scrambled net: n = 2^k of them are one to each of n equal parts of the pixel, in every
// division into boxes at once.
//
// Symbols  L radiance, in the unit in which a white surface under a sky of 1 has 1.
// Beware   Not what light does: see core/shading.h. The light of the scene as it is, is
//          truth/irradiance.h.
#pragma once

#include "core/camera.h"
#include "core/monitor.h"
#include "core/scene.h"
#include "rays/ray_caster.h"
#include "truth/rgb_sums.h"

namespace plumb {

/// Of every pixel (row * width + column), of the sky too.
RgbSums MeasureBeauty(const RayCaster& caster, const Scene& scene, const Camera& camera,
                      const NetSampling& sampling, Monitor& monitor = SilentMonitor());

}  // namespace plumb
