// The conventions of the whole project, said once. A header that deviates says so under Beware.
//
// Axes       Right-handed. Height fields: x to the right (columns), y along the rows, +z up.
//            A camera looks along -z of its own frame, y up.
// Texels     Row-major, row 0 at y = 0. The height of texel (i, j), column i of row j, stands
// at
//            its centre, x = (i + 1/2) s_x, y = (j + 1/2) s_y; between centres the surface is
//            the triangulated grid of heightfield/height_field.h.
// Images     Linear, row-major, float.
// Angles     Radians inside, degrees in flags and files only, with the unit in the name.
// Units      Every border names its unit: _m, _m2, _px, _texels, _rad, _deg, _s, _spp. No
// suffix
//            means unitless.
// Light      A unit white sky, L_sky = 1, so that open ground has E_open = pi. Every E in the
//            project is divided by E_open: E_0 = V and E(rho) = Sum rho^k E_k lie in [0, 1].
//
// One word for one quantity:
//
//   uniform visibility   alpha   1/(2 pi) Int v(w) dw         UniformVisibility
//   cosine visibility    V       1/pi Int v(w) <n, w> dw      CosineVisibility
//   occlusion            1 - V
//   obscurance           A       the range-limited visibility of a screen-space paper
//   bounce irradiance    E_k     light that arrives after exactly k bounces, albedo 1
//   total                E(rho)  Sum_k rho^k E_k
//   albedo               rho     diffuse reflectance, in [0, 1]
//   form factor          F_ij    share of what leaves i (cosine-weighted) that meets j
//
// One word for one count: a direction cast from a facet is a ray, a vertical plane through it a
// slice, a sample of a pixel is counted in spp, a depth lookup of a screen-space method is a
// tap.
#pragma once

#include <numbers>

namespace plumb {

inline constexpr double kPi = std::numbers::pi;

/// Irradiance of open ground under a sky of unit radiance.
inline constexpr double kOpenIrradiance = kPi;

}  // namespace plumb
