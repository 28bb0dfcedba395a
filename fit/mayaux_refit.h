// The paper's own way to its constants, on new data: F0 fitted to E_0, F1 to E_1, tau follows.
//
// Source   [Mayaux18 eq. 7] and [Mayaux18 eq. 11] fitted to curves over alpha, put together by
//          [Mayaux18 eq. 9] and [Mayaux18 eq. 12]. Set SampleOptions::weighting to kUnweighted
//          for the paper's equal weight of every bin.
// Beware   Nothing in this way knows of the total, nor keeps F0 below 1: refitted constants may
//          have poles as the published ones do. Ask fit/mayaux_faults.h.
#pragma once

#include <span>

#include "core/bounce_histogram.h"
#include "fit/least_squares.h"
#include "fit/models/mayaux_total.h"
#include "fit/samples.h"

namespace plumb {

struct MayauxRefit {
    LeastSquaresFit F0, F1;

    MayauxConstants<> Constants() const;
};

/// Throws Error as FitModel does.
MayauxRefit RefitMayaux(std::span<const BounceHistogram> maps,
                        const SampleOptions& sampling = {},
                        const LeastSquaresOptions& options = {});

/// [Mayaux18 eq. 12] with these constants, as a formula to score.
Formula MayauxFormula(const MayauxConstants<>& constants, PoleGuard guard, std::string name);

}  // namespace plumb
