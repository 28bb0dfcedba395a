// Ground-truth ambient occlusion (GTAO): cosine visibility from the two horizons of each
// slice.
//
//              1   N
//       A  =  ---  Sum  L_k ( a(h_0, gamma_k) + a(h_1, gamma_k) )       a: slice_integral.h
//              N  k=1
//
//       cos h_1 = max_j  c_low + w(d_j) (c_j - c_low),   c_low = cos(gamma + pi/2); so h_0
//       w(d)    = 1 up to falloff_start r, then linear to 0 at r
//       thin    where a later sample lies lower than the horizon, cos h falls towards it by the
//               share thickness_blend
//
// Without falloff and thin, for a scene that is one height field as seen from the eye, and as
// samples grow, A is the cosine visibility V within the picture (SliceSpread::kLineOfSight).
//
// Source   [Jimenez16] J. Jimenez et al., Practical Real-Time Strategies for Accurate Indirect
//          Occlusion, 2016: slices, integral, linear blend of the attenuation, thickness
//          heuristic. That the blend goes to the tangent plane, and the default start of 0.385
//          r, are those of XeGTAO.
// Symbols  c_j cosine of the angle of sample j from the line of sight; others: slice_march.h.
// Beware   With few slices the mean of an open, tilted plane is 1 on average over the turns of
//          the slices only: a pixel's A may be as great as pi/2. `normalize` divides by the
//          sum of the open slices instead of N, which makes it 1 at every pixel: ours. The sky
//          has A = 1.
// Cost     2 slices steps depth lookups a pixel.
#pragma once

#include "core/image.h"
#include "screen_space/gbuffer.h"
#include "screen_space/peers/slice_march.h"
#include "screen_space/pixel_rect.h"

namespace plumb {

struct GtaoOptions {
    SliceSampling sampling{.slices = 3, .steps = 3, .step_power = 2};
    double falloff_start = 0.385;  ///< Share of the radius. [0, 1]; 1: cut off hard at r.
    double thickness_blend = 0;    ///< [0, 1); 0: everything is thick.
    bool normalize = false;        ///< See Beware.
};

/// Throws Error, naming the first field that breaks its range above.
void Validate(const GtaoOptions& options);

/// A of one pixel, in double: the reference. In [0, pi/2]; in [0, 1] if normalized.
double GtaoOfPixel(const GBuffer& gbuffer, const GtaoOptions& options, int x, int y);

/// A of the drawn size, in float and with SIMD.
Image<float> Gtao(const GBuffer& gbuffer, const GtaoOptions& options = {});

/// The same within `where`, a part of what is drawn; 1 elsewhere.
Image<float> Gtao(const GBuffer& gbuffer, const GtaoOptions& options, const PixelRect& where);

}  // namespace plumb
