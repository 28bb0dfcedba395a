// Surfaces on which every facet sees the same sky: the bowl and the wedge, exact for all
// bounces.
//
//       E_k = V (1 - V)^k        E(rho) = V / (1 - rho (1 - V))
//
// Bowl: a cap of a sphere of half-angle psi, seen from its centre, its rim level with a plane.
// On a sphere the form factor to any piece is the piece's share of the whole area, whatever the
// two points, so every point of the cap sees the cap with 1 - V = (1 - cos psi) / 2:
//
//       V = (1 + cos psi) / 2 everywhere;     alpha = 1 - sin(psi / 2) at the bottom
//
// Wedge: two endless half-planes with the dihedral angle beta between them:
//
//       V = sin^2(beta / 2)        alpha = beta / pi
//
// (for the endless wedge E_k holds because V is the same on both planes).
//
// Source   derived here from the definitions; the bowl is known from planetary craters.
// Symbols  psi, beta in radians; V, alpha, E_k, rho as in core/conventions.h.
#pragma once

#include <cmath>

#include "core/conventions.h"
#include "core/visibility.h"

namespace plumb {

inline CosineVisibility BowlVisibility(double psi_rad) {
    return CosineVisibility((1 + std::cos(psi_rad)) / 2);
}
inline UniformVisibility BowlBottomUniformVisibility(double psi_rad) {
    return UniformVisibility(1 - std::sin(psi_rad / 2));
}

inline CosineVisibility WedgeVisibility(double beta_rad) {
    const double s = std::sin(beta_rad / 2);
    return CosineVisibility(s * s);
}
inline UniformVisibility WedgeUniformVisibility(double beta_rad) {
    return UniformVisibility(beta_rad / kPi);
}

/// E_k where V is the same everywhere.
inline double CavityBounce(CosineVisibility V, int k) {
    return V.value * std::pow(1 - V.value, k);
}

}  // namespace plumb
