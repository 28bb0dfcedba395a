// The filters of FLIP, each the weights of one line of pixels: all are separable.
//
//       contrast   g(x) = a sqrt(pi / b) exp(-pi^2 x^2 / b)         x in degrees
//                  Y: (a, b) = (1, 0.0047);  Cx: (1, 0.0053);  each normalized to the sum 1
//                  Cz: (34.1, 0.04) and (13.5, 0.025) added, which are sums of two separable
//                  filters, normalized together
//       features   G    = exp(-x^2 / (2 sigma^2))                   x in pixels, sum 1
//                  G'   = -x G                  positive parts to the sum 1, negative to -1
//                  G''  = (x^2 / sigma^2 - 1) G                     likewise
//
// The contrast filter keeps what an eye sees of a pattern of so many cycles a degree; the
// features are edges and points as wide as an eye tells apart, w = 0.082 degrees:
// sigma = w ppd / 2.
//
// Source   [Andersson20] sections 4.1.1 and 4.2; a and b: [Johnson01], as there.
// Symbols  ppd pixels a degree of the field of view.
// Domain   ppd in [1, 1000].
// Beware   One radius serves all contrast filters, ceil(3 sqrt(0.04 / (2 pi^2)) ppd). Weights
//          below 1e-12 of the middle's are left out: they are less than a rounding of the sum.
#pragma once

#include <vector>

namespace plumb {

/// Weights w[0] of the middle, w[k] of the pixels k away; odd: that of the pixel before is
/// -w[k].
struct LineFilter {
    std::vector<double> w;
    bool odd = false;

    int Reach() const { return int(w.size()) - 1; }
};

struct FlipFilters {
    LineFilter Y, Cx, Cz_wide, Cz_narrow;  ///< Cz is the sum of its two.
    LineFilter G, edge, point;             ///< G, G', G''.

    /// The farthest that any of them reaches. [px]
    int reach_px = 0;
};

/// Throws Error if `pixels_per_degree` is outside its domain.
FlipFilters MakeFlipFilters(double pixels_per_degree);

}  // namespace plumb
