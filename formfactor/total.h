// The sum of all bounces for an albedo of every facet's own, as one linear system.
//
//       (I - F diag(rho)) E = V
//
// solved by BiCGSTAB, a Krylov method: it does not stall where the series of
// formfactor/bounces.h does, at rho near 1 in a deep pit, where light leaves the surface only
// after hundreds of bounces.
//
// Source   the radiosity equation; [Mayaux18 eq. 2] with the neighbour's own albedo kept. The
//          solver is Eigen's.
// Symbols  E irradiance over that of open ground, V cosine visibility, F links, rho albedo.
// Beware   With rho = 1 everywhere E = 1 is the solution whatever the surface: the furnace.
#pragma once

#include <span>
#include <vector>

#include "formfactor/links.h"

namespace plumb {

/// What the solver found, and how good it is. Not converging is an outcome.
struct TotalLight {
    std::vector<double> E;
    bool converged = false;
    int iterations = 0;
    double residual =
        0;  ///< |V - (I - F diag(rho)) E| / |V|, Euclidean, computed anew at the end.
};

/// E for one albedo a facet, each in [0, 1]; throws Error otherwise. `tolerance` bounds the
/// residual.
TotalLight SolveTotal(const Links& links, std::span<const double> albedo,
                      double tolerance = 1e-10, Monitor& monitor = SilentMonitor());

}  // namespace plumb
