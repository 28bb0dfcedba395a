// The fit of a model to samples: curves and totals go the same way.
//
// Source   least squares as in fit/least_squares.h; the paper fits its curves so as well.
// Beware   A curve reads alpha or V and is fitted to BounceSamples or PairSamples; a total also
//          reads rho and is fitted to TotalSamples. A sample that lacks an input is an Error.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/bounce_histogram.h"
#include "fit/least_squares.h"
#include "fit/model.h"
#include "fit/models/bounce_curve.h"
#include "fit/samples.h"

namespace plumb {

/// Samples of weight 0 are left out. Throws Error as Minimize does, if a sample lacks an input
/// of the model, and if the model has no free constant.
LeastSquaresFit FitModel(const Model& model, std::span<const Sample> samples,
                         const LeastSquaresOptions& options = {});

/// The model with the constants that the fit found.
Formula Fitted(const Model& model, const LeastSquaresFit& fit, std::string name);

/// One BounceCurveModel for each bounce 1 ... bounces; element k - 1 is bounce k. Throws Error
/// if a map has fewer bounces.
std::vector<LeastSquaresFit> FitBounceFamily(std::span<const BounceHistogram> maps,
                                             const SampleOptions& sampling = {},
                                             int bounces = kMayaux18Bounces,
                                             const LeastSquaresOptions& options = {});

}  // namespace plumb
