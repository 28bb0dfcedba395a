// How wrong a formula is facet by facet, and how wrong any formula of its inputs must be.
//
//       rms^2   = mean over facets i and albedos rho of (f(alpha_i, V_i, rho) - E_i(rho))^2
//       floor^2 = the same for the best f that there can be, the mean of E over all facets of
//                 the same alpha (V, both): the spread within the bins of a fine histogram
//
// Source   ours.
// Beware   Facets where a formula is not finite (a pole) are left out of its rms; the table
//          of scores counts poles.
#pragma once

#include "fit/model.h"
#include "jobs/light/simulate_surface.h"
#include "reports/fit_report.h"

namespace plumb {

/// Facets that a rms is taken over at most: every n-th of a larger map, which leaves an error
/// of the rms of under 1 %.
inline constexpr std::int64_t kScoredFacets = 65537;

/// rms of the header. Cost: one evaluation a scored facet and albedo.
double FacetRms(const Formula& formula, const SurfaceLight& light);

/// The floors of alpha and of V, from the histograms of the simulation, and of both, from a grid of
/// 100 x 100.
Floors FloorsOf(const SurfaceLight& light);

}  // namespace plumb
