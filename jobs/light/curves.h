// The curves of the paper fitted to any samples of the bounces: F0, F1, and one for each E_k.
#pragma once

#include <functional>
#include <vector>

#include "fit/least_squares.h"
#include "fit/samples.h"
#include "reports/fit_report.h"

namespace plumb {

/// Fills report.curves and report.bounce_family from `samples_of(k)`, E_k over alpha, for k = 0
/// to `bounces` (at most kMayaux18Bounces of the family). Source: [Mayaux18 eq. 7] [Mayaux18
/// eq. 11].
void FitCurves(const std::function<std::vector<Sample>(int k)>& samples_of, int bounces,
               const LeastSquaresOptions& options, FitReport& report);

}  // namespace plumb
