// How much the fitted constants depend on which maps they were fitted to.
//
// Of M maps, M are drawn with replacement and the model is fitted again; over many such
// replicates the constants' standard deviation is their standard error and their percentiles an
// interval. A map drawn m times has its weights multiplied by m, which is the same thing.
//
// Source   B. Efron, Bootstrap Methods: Another Look at the Jackknife, Annals of Statistics 7,
//          1979; the interval is the percentile interval.
// Beware   The maps are the independent units, not the bins: with five maps the interval is
//          rough and, as a rule, too narrow. Deterministic by seed, on any number of threads.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/monitor.h"
#include "fit/least_squares.h"
#include "fit/model.h"
#include "fit/samples.h"

namespace plumb {

struct BootstrapOptions {
    int replicates = 200;      ///< [2, ...)
    double confidence = 0.95;  ///< Share of the replicates within [low, high]. (0, 1)
    std::uint64_t seed = 1;
};

/// Throws Error, naming the first field that breaks its range above.
void Validate(const BootstrapOptions& options);

struct BootstrapInterval {
    std::string name;
    double standard_error = 0;
    double low = 0, high = 0;
};

struct BootstrapResult {
    std::vector<BootstrapInterval> parameters;
    int replicates = 0;  ///< That gave a fit.
    int failed = 0;      ///< That did not converge, or drew maps with nothing to fit.
};

/// `samples` must come from at least two maps (Sample::map). Each replicate starts from the
/// constants of the fit to all maps and, if options.starts > 1, from others too. Throws Error
/// if there are too few maps, if that first fit throws, or if fewer than two replicates give a
/// fit.
BootstrapResult BootstrapOverMaps(const Model& model, std::span<const Sample> samples,
                                  const BootstrapOptions& bootstrap = {},
                                  const LeastSquaresOptions& options = {.starts = 2},
                                  Monitor& monitor = SilentMonitor());

}  // namespace plumb
