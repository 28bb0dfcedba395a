// Bilateral filter of heights: smooths the stairs of coarsely quantized heights, keeps steps.
//
//                Sum_k w_s(k) w_r(z_k - z) z_k
//       z'  =   -------------------------------,    w_s = exp(-(di^2 + dj^2) / (2 r^2)),
//                  Sum_k w_s(k) w_r(z_k - z)
//
//       w_r(d)  =  (1 - (d / t)^2)^2  for |d| < t,  else 0          |di|, |dj| <= r
//
// Source   C. Tomasi, R. Manduchi, Bilateral Filtering for Gray and Color Images, 1998; w_r is
//          Tukey's biweight. The maker of [Mayaux18]'s constants filtered his 8-bit maps so,
//          with a radius of 1 texel and a tolerance of 0.2 of the range.
// Symbols  z height of a texel (m), r radius (texels), t tolerance (m).
// Domain   Any field. Neighbours beyond the border are those of the field's boundary: wrapped,
//          mirrored about the row of border centres, or, if it is open, left out.
// Beware   The exact kernel of the original is not published. Tukey's has finite support:
//          a step of t or more is kept exactly, its two sides never mix.
//          Distances count in texels along both axes, whatever the spacing.
#pragma once

#include "heightfield/height_field.h"

namespace plumb {

struct BilateralFilter {
    int radius_texels = 1;   ///< r. [0, 64], 0 = the field as it is
    double tolerance_m = 0;  ///< t. (0, ...); 0.2 (highest - lowest) is the original's
};

/// Throws Error, naming the first field that breaks its range above.
void Validate(const BilateralFilter& filter);

/// The filtered field; its grid, boundary and diagonal are those of `field`. Never beyond the
/// range of the heights in the window. Cost: (2 r + 1)^2 lookups a texel.
HeightField Filtered(const HeightField& field, const BilateralFilter& filter);

}  // namespace plumb
