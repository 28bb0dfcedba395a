// Where a set of constants breaks the paper's formula: poles, F0 above 1, F0 above its bound.
//
//       pole        (1 - rho) (1 - F0) + rho F1 = 0      1 - rho tau = 0, times 1 - F0
//       above 1     F0(alpha) > 1                        more light than an open sky sends
//       bound       F0(alpha) > alpha (2 - alpha)        more than any sky of that alpha sends
//
// Source   the formula [Mayaux18 eq. 12] with [Mayaux18 eq. 7], [Mayaux18 eq. 9] and
//          [Mayaux18 eq. 11]; that it has such places is ours.
// Symbols  alpha uniform visibility, rho albedo, F0, F1, tau as in fit/models/mayaux_total.h.
// Beware   Roots are bracketed on a grid (1000 even steps of alpha, and 2000 steps that grow
//          geometrically away from alpha = 1, where the published constants misbehave): two
//          roots within one step would be missed. Bisected to the last bit of a double.
#pragma once

#include <vector>

#include "core/visibility.h"
#include "fit/models/mayaux_total.h"

namespace plumb {

/// An open interval of alpha in which a rule is broken, and where it is broken worst.
struct BrokenInterval {
    double low = 0, high = 0;
    double worst_alpha = 0;
    double worst_excess = 0;  ///< By how much the rule is broken there, > 0.
};

/// The alpha in (0, 1) at which E(rho) has a pole, ascending. Usually one, or none.
std::vector<UniformVisibility> PolesOf(const MayauxConstants<>& constants, Albedo rho);

/// Where F0 > 1, within [0, 1], ascending.
std::vector<BrokenInterval> DirectFactorAboveOne(const DirectFactor<>& F0);

/// Where F0 > alpha (2 - alpha), the greatest cosine visibility, within [0, 1], ascending.
std::vector<BrokenInterval> DirectFactorAboveBound(const DirectFactor<>& F0);

/// Where F0 < alpha^2, the least cosine visibility, within [0, 1], ascending.
std::vector<BrokenInterval> DirectFactorBelowBound(const DirectFactor<>& F0);

}  // namespace plumb
