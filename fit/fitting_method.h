// A way from measured maps to a formula: a fit, or, for a baseline, no way at all.
//
// Whoever compares formulas fairly (fit/leave_one_out.h) hands every method the same maps
// and lets it make of them what it can.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "core/bounce_histogram.h"
#include "fit/least_squares.h"
#include "fit/model.h"
#include "fit/models/mayaux_total.h"
#include "fit/samples.h"

namespace plumb {

struct FittingMethod {
    std::string name;
    std::function<Formula(std::span<const BounceHistogram> maps)> learn;
};

/// Always the same formula, whatever the maps.
FittingMethod Unfitted(Formula formula);

/// The model of E(rho), its constants fitted to the maps' totals.
FittingMethod Refitted(const Model& model, const SampleOptions& sampling = {},
                       const LeastSquaresOptions& options = {});

/// The paper's way (fit/mayaux_refit.h).
FittingMethod RefittedAsPublished(PoleGuard guard, const SampleOptions& sampling = {},
                                  const LeastSquaresOptions& options = {});

}  // namespace plumb
