// Which histogram a formula is fitted to and scored on: that over what it reads.
#pragma once

#include <span>
#include <vector>

#include "core/bounce_histogram.h"
#include "fit/model.h"
#include "jobs/light/simulate_surface.h"

namespace plumb {

/// Over alpha for a formula of alpha, over V for one of V, over the grid for one of both.
BinnedBy BinningFor(const ModelInputs& inputs);

const BounceHistogram& HistogramBy(BinnedBy binned_by, const SurfaceLight& light);

inline const BounceHistogram& HistogramFor(const Formula& formula, const SurfaceLight& light) {
    return HistogramBy(BinningFor(formula.model.inputs), light);
}

/// The same of every surface, in order.
std::vector<BounceHistogram> HistogramsBy(BinnedBy binned_by,
                                          std::span<const SurfaceLight> lights);

}  // namespace plumb
