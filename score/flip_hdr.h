// FLIP of pictures of high dynamic range: the greatest over all exposures that show them.
//
//       HDR-FLIP = max_k FLIP( clamp T(2^(s_k) c), clamp T(2^(s_k) t) )           per pixel
//
// with the curve T and the exposures s_k of score/tone_curve.h.
//
// Source   [Andersson21] P. Andersson, J. Nilsson, P. Shirley, T. Akenine-Moller, Visualizing
//          Errors in Rendered High Dynamic Range Images, Eurographics short papers, 2021.
// Symbols  c candidate, t reference.
// Domain   Linear, finite. Negative numbers count as 0, for no screen shows them; the curves would
//          make large negative ones bright.
// Beware   The exposures depend on the reference: figures of different references do not compare
//          unless the exposures are given.
// Cost     that of score/flip.h, once an exposure.
#pragma once

#include <optional>

#include "core/image.h"
#include "score/flip.h"
#include "score/tone_curve.h"

namespace plumb {

struct HdrFlipOptions {
    FlipOptions flip = {};
    ToneCurve curve = ToneCurve::kAces;
    std::optional<ToneExposures> exposures = {};  ///< Unset: those of the reference.
};

struct HdrFlip {
    Image<float> map;
    ToneExposures exposures;  ///< That were taken.
};

/// `mask` says which pixels the exposures are measured on. Throws Error as FlipMap and ExposuresOf.
HdrFlip HdrFlipMap(const Image<Rgb>& candidate, const Image<Rgb>& reference,
                   const Mask& mask = {}, const HdrFlipOptions& options = {});

}  // namespace plumb
