// The bounce ratio tau: how much each bounce after the first keeps of the one before it.
//
//       tau = 1 - F1 / (1 - F0)                                        [Mayaux18 eq. 9]
//
// so that F0 + F1 (1 + tau + tau^2 + ...) = 1: at albedo 1 no light is lost.
//
// Source   [Mayaux18 eq. 9].
// Symbols  F0 the direct factor, F1 the first bounce, both at one alpha.
// Domain   F0 < 1 and F1 <= 1 - F0 give 0 <= tau <= 1, the only tau that mean anything.
// Beware   tau -> -infinity or +infinity where F0 -> 1: with the published F0 that happens at
//          alpha = 0.94925, well inside the domain (fit/mayaux_faults.h). The true ratios
//          E_(k+1) / E_k of a surface are not constant in k.
#pragma once

namespace plumb {

/// tau. Unitless. Not finite where F0 = 1.
template <class T>
T BounceRatio(const T& F0, const T& F1) {
    return 1.0 - F1 / (1.0 - F0);  // [Mayaux18 eq. 9]
}

}  // namespace plumb
