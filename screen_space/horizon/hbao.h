// Horizon-based ambient occlusion (HBAO): how far the horizon rises above the tangent plane,
// direction by direction of the picture.
//
//                  1   2pi
//       A  =  1 - ---  Int  Sum_j W(d_j) (sin h_j - sin h_{j-1}) dtheta
//                 2pi   0
//
//       sin h_0 = sin(t + bias),   h_j = max(h_{j-1}, elevation of sample j)
//       W(d) = 1 - d^2 / r^2
//
// Elevations are taken from the plane of the picture: h that of a sample seen from C, t that
// of the tangent plane in the slice. Without W and bias the integral is 1 less the share of
// the solid angle below the horizon: A is of the kind of alpha (uniform), not of V.
//
// Source   [Bavoil08] L. Bavoil, M. Sainz, R. Dimitrov, Image-Space Horizon-Based Ambient
//          Occlusion, SIGGRAPH talks, 2008.
// Symbols  C receiver (m), d = |Q - C| (m), r radius (m), theta direction on screen (rad).
// Beware   Directions are evenly spread on screen: off the picture's middle, where the line of
//          sight is not the axis, the integral is a little off the solid angle, as published.
//          The sky has A = 1. Slices, steps and snapping: screen_space/horizon/slice_march.h.
// Cost     directions x steps depth lookups a pixel.
#pragma once

#include "core/image.h"
#include "screen_space/gbuffer.h"
#include "screen_space/horizon/slice_march.h"
#include "screen_space/pixel_rect.h"

namespace plumb {

struct HbaoOptions {
    /// Two directions a slice, as many steps each.
    SliceSampling sampling{.slices = 4, .steps = 4, .step_power = 1};
    double bias_rad = 0;    ///< Angle by which the horizon must rise. [0, pi/2)
    double strength = 1;    ///< Factor on the occlusion. [0, 100]
    bool attenuate = true;  ///< W; false: W = 1 within the radius.
};

/// Throws Error, naming the first field that breaks its range above.
void Validate(const HbaoOptions& options);

/// A of one pixel, in double: the reference. In [0, 1].
double HbaoOfPixel(const GBuffer& gbuffer, const HbaoOptions& options, int x, int y);

/// A of the drawn size, in float and with SIMD.
Image<float> Hbao(const GBuffer& gbuffer, const HbaoOptions& options = {});

/// The same within `where`, a part of what is drawn; 1 elsewhere.
Image<float> Hbao(const GBuffer& gbuffer, const HbaoOptions& options, const PixelRect& where);

}  // namespace plumb
