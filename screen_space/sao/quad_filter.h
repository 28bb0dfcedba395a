// The 2 x 2 reconstruction: A averaged over a quad of pixels that lie on one surface.
//
//       if |dz/dx'| < t:   A -= dA/dx' ((x' & 1) - 1/2)        then the same along y'
//
// With the derivatives of a quad's row (column) this is the mean of the two pixels, and along both
// axes that of all four.
//
// Source   [McGuire12] section 2.3, after eq. 10; the form: the shader of its supplement.
// Symbols  A obscurance, z depth (m, < 0), (x', y') pixel, t threshold (m).
// Domain   Quads start at even pixels of the drawn picture. A pixel whose partner lies beyond the
//          border keeps its A along that axis; so does one beside the sky.
// Beware   Derivatives are the fine ones (each row and column of the quad its own). A GPU may take
//          the coarse ones, one difference for the whole quad, and then spread A of one row to
//          the other. The threshold is a length, not a share of z: far slopes are not filtered.
#pragma once

#include "core/image.h"
#include "screen_space/pixel_rect.h"

namespace plumb {

inline constexpr double kQuadThresholdM = 0.02;  ///< As shipped.

/// Filters A in place within `where`, on the caller's own thread.
void FilterQuads(Image<float>& A, const Image<float>& z_m, double threshold_m,
                 const PixelRect& where);

/// A filtered within `where`, whose corners are those of quads or of the picture.
Image<float> QuadFiltered(Image<float> A, const Image<float>& z_m, double threshold_m,
                          const PixelRect& where);

}  // namespace plumb
