// The sampling pass: A of each pixel from its taps, before any filter.
//
//       C = z_C (s_x, s_y, 1)                                       [McGuire12 eq. 3]
//       n from depth or given,    v_i = Q_i - C
//       A = the estimator of sao.h over the taps of tap_lookup.h
//
// Two ways to the same number: ObscuranceOfPixel, the reference, in double and one pixel at a
// time; SampleObscurance, the picture, in float with SIMD, tile by tile, on all cores. The bits of
// the picture depend neither on the number of threads nor on the width of the machine's vectors.
//
// Source   [McGuire12] section 2.3.
// Symbols  as in sao.h and tap_lookup.h.
// Beware   Eq. 3 as printed ("- (-2 ...)") does not put the middle of the picture at y = 0; View::Point
//          does. The two ways round a tap's place separately: where h u comes within its float's
//          rounding of a whole number they may read neighbouring pixels.
//          The sky has A = 1, and a tap that meets the sky adds nothing.
// Cost     s depth lookups a pixel.
#pragma once

#include "core/image.h"
#include "screen_space/gbuffer.h"
#include "screen_space/pixel_rect.h"
#include "screen_space/sao/sao.h"
#include "screen_space/sao/tap_lookup.h"
#include "screen_space/sao/z_pyramid.h"

namespace plumb {

/// |n|^2 of a given normal; one that is longer, or not a number, occludes nothing: A = 1.
inline constexpr float kMostNormal2 = 4;

enum class NormalSource {
    kDepth,    ///< [McGuire12 eq. 4]
    kFace,     ///< GBuffer::face_normal
    kShading,  ///< GBuffer::shading_normal
};

struct ObscuranceOptions {
    SaoParams sao;
    TapOptions taps;
    NormalSource normals = NormalSource::kDepth;
    double steepest_area = 0;  ///< kDepth: A = 1 where DepthNormal::area is greater; 0 = off.
};

/// Throws Error, naming the first field that breaks its range.
void Validate(const ObscuranceOptions& options);

/// A of pixel (x, y); its taps turned by the hash.
double ObscuranceOfPixel(const GBuffer& gbuffer, const ZPyramid& pyramid,
                         const ObscuranceOptions& options, int x, int y);

/// As above, its taps turned by `phi_rad` instead.
double ObscuranceOfPixel(const GBuffer& gbuffer, const ZPyramid& pyramid,
                         const ObscuranceOptions& options, int x, int y, double phi_rad);

/// A of the drawn size: computed within `where`, 1 outside. `pyramid` is of gbuffer.z_m.
Image<float> SampleObscurance(const GBuffer& gbuffer, const ZPyramid& pyramid,
                              const ObscuranceOptions& options, const PixelRect& where);

}  // namespace plumb
