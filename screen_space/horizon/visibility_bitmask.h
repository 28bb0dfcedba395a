// Visibility bitmask: each slice of the hemisphere is cut into sectors, and every sample
// closes those that it hides; light passes behind it.
//
//       A = 1/N Sum_k (1 - closed_k / sectors)                        uniform, as published
//       A = 1/N Sum_k T_k (1 - closed_k / sectors)                    cosine
//           T_k = L_k (cos gamma_k + gamma_k sin gamma_k)
//
// A sample hides the angles from that of its front, v', to that of its back, v' - thickness V,
// both from V and limited to gamma +- pi/2. The share of the slice that lies before an angle
// th is
//
//       uniform  h(th) = (th - gamma + pi/2) / pi
//       cosine   h(th) = Int_{gamma - pi/2}^th cos(s - gamma) |sin s| ds / T,   T = T_k / L_k
//
// and closes, of the sectors 0 ... S - 1, as published or with both ends rounded alike,
//
//       kCeil    from floor(h_1 S), ceil((h_2 - h_1) S) of them
//       kRound   from round(h_1 S) up to, not including, round(h_2 S)
//
// Source   [Therrien23] O. Therrien, Y. Levesque, G. Gilet, Screen Space Indirect Lighting
//          with Visibility Bitmask, 2023, and its shader: uniform sectors, kCeil, 32 of them.
//          kRound and cosine sectors: ours, after the same mending elsewhere.
// Symbols  S sectors; others: screen_space/horizon/slice_march.h, slice_integral.h.
// Beware   kCeil counts too many: a sample closes at least one sector however thin it is, so
//          that a plane, whose samples lie on the edge of the hemisphere, loses one on each
//          side. Uniform sectors are even in angle, which is neither alpha nor V: a cone of
//          sky of half-angle h has A = 2h / pi. The back is pushed along the receiver's line
//          of sight, as in the shader, so that it stays in the slice. The sky has A = 1. As
//          for GTAO, a cosine A may exceed 1 at one pixel unless `normalize` divides by the
//          mean of T_k.
// Cost     2 slices steps depth lookups and arc tangents a pixel.
#pragma once

#include <cstdint>

#include "core/image.h"
#include "screen_space/gbuffer.h"
#include "screen_space/horizon/slice_march.h"
#include "screen_space/pixel_rect.h"

namespace plumb {

enum class SectorMeasure { kUniform, kCosine };
enum class SectorRounding { kCeil, kRound };

struct BitmaskOptions {
    SliceSampling sampling{.slices = 3, .steps = 6, .step_power = 2};
    double thickness_m = 0.5;  ///< Of everything. (0, infinity]
    int sectors = 32;          ///< S. [1, 64]
    SectorMeasure measure = SectorMeasure::kUniform;
    SectorRounding rounding = SectorRounding::kCeil;
    bool normalize = false;  ///< See Beware.
};

/// Throws Error, naming the first field that breaks its range above.
void Validate(const BitmaskOptions& options);

/// The sectors that the shares from h_1 to h_2 >= h_1 close, both in [0, 1]: bit s is sector
/// s.
std::uint64_t ClosedSectors(double h_1, double h_2, int sectors, SectorRounding rounding);

/// h(th) of an angle in [gamma - pi/2, gamma + pi/2].
double SectorShare(double th_rad, double gamma_rad, SectorMeasure measure);

/// A of one pixel, in double: the reference. In [0, 1], but see Beware.
double VisibilityBitmaskOfPixel(const GBuffer& gbuffer, const BitmaskOptions& options, int x,
                                int y);

/// A of the drawn size, in float and with SIMD.
Image<float> VisibilityBitmask(const GBuffer& gbuffer, const BitmaskOptions& options = {});

/// The same within `where`, a part of what is drawn; 1 elsewhere.
Image<float> VisibilityBitmask(const GBuffer& gbuffer, const BitmaskOptions& options,
                               const PixelRect& where);

}  // namespace plumb
