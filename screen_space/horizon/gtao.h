// Ground-truth ambient occlusion (GTAO): cosine visibility from the two horizons of each
// slice.
//
//              1   N
//       V  =  ---  Sum  L_k ( a(h_0, gamma_k) + a(h_1, gamma_k) )       a: slice_integral.h
//              N  k=1
//
//       A       = max(least, V^power),    L_k drawn to 1 by the share length_lift
//       cos h_1 = max_j  c_far + w(d_j) (c_j - c_far),   at least cos(gamma + pi/2); so h_0
//       c_far   = cos(gamma + pi/2), the tangent plane; or -1
//       w(d)    = 1 up to falloff_start r, then linear to 0 at r
//       thin    where a later sample lies lower than the horizon, cos h falls towards it by the
//               share thickness_blend
//
// Without falloff, thin, power and lift, for a scene that is one height field as seen from the eye, and as
// samples grow, A is the cosine visibility V within the picture (SliceSpread::kLineOfSight).
//
// Source   [Jimenez16] J. Jimenez et al., Practical Real-Time Strategies for Accurate Indirect
//          Occlusion, 2016: slices, integral, linear blend of the attenuation, thickness
//          heuristic, c_far = -1. XeGTAO (its shader): c_far the tangent plane, "because [-1] is
//          under horizon", the start of 0.385 r, step_power 2, power 2.2, least 0.03, length_lift
//          0.05, "slight overdarkening on high slopes", and r 1.457 times the radius meant.
// Symbols  c_j cosine of the angle of sample j from the line of sight; others: slice_march.h.
// Beware   With few slices the mean of an open, tilted plane is 1 on average over the turns of
//          the slices only: a pixel's A may be as great as pi/2. `normalize` divides by the
//          sum of the open slices instead of N, which makes it 1 at every pixel: ours. The sky
//          has A = 1.
// Cost     2 slices steps depth lookups a pixel.
#pragma once

#include "core/image.h"
#include "screen_space/gbuffer.h"
#include "screen_space/horizon/slice_march.h"
#include "screen_space/pixel_rect.h"

namespace plumb {

/// To what the horizon of a far sample is drawn.
enum class HorizonFade {
    kTangentPlane,  ///< What a far sample hides shrinks to nothing.
    kBehind,        ///< To straight away from the eye; the tangent plane cuts it off.
};

struct GtaoOptions {
    SliceSampling sampling{.slices = 3, .steps = 3, .step_power = 2};
    double falloff_start = 0.385;  ///< Share of the radius. [0, 1]; 1: cut off hard at r.
    HorizonFade fade = HorizonFade::kTangentPlane;
    double thickness_blend = 0;  ///< [0, 1); 0: everything is thick.
    double length_lift = 0;      ///< [0, 1]
    double power = 1;            ///< Of V. [0.1, 10]
    double least = 0;            ///< Of A. [0, 1]
    bool normalize = false;      ///< See Beware.
};

/// Throws Error, naming the first field that breaks its range above.
void Validate(const GtaoOptions& options);

/// A of one pixel, in double: the reference. In [0, (pi/2)^power]; in [0, 1] if normalized.
double GtaoOfPixel(const GBuffer& gbuffer, const GtaoOptions& options, int x, int y);

/// A of the drawn size, in float and with SIMD.
Image<float> Gtao(const GBuffer& gbuffer, const GtaoOptions& options = {});

/// The same within `where`, a part of what is drawn; 1 elsewhere.
Image<float> Gtao(const GBuffer& gbuffer, const GtaoOptions& options, const PixelRect& where);

}  // namespace plumb
