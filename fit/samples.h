// What a model is fitted to: points of light with a measured value and a weight.
//
// Each non-empty bin of a histogram gives one sample a curve, or one sample an albedo. The
// abscissae are the bin's true means of alpha and V, never an edge or a centre.
//
//       kUnweighted               w = 1                             the paper's choice
//       kPopulation               w = n_bin / n_map                 every map counts the same
//       kPopulationOverVariance   w = n_bin / n_map / (s^2 + s_0^2)
//
// Symbols  n_bin facets in the bin, n_map in all bins of its map; s^2 variance of the facets of
//          a bin about its mean; s_0 the floor: spread below it is not taken at its word, for
//          no model is that good.
// Beware   Samples of one map share its misfit, and those of one bin at several albedos even
//          its facets: they are not independent, and the standard errors of a fit that takes
//          them to be so are too small. fit/bootstrap.h resamples whole maps instead.
#pragma once

#include <span>
#include <vector>

#include "core/bounce_histogram.h"
#include "fit/model.h"

namespace plumb {

struct Sample {
    LightPoint at;
    double y = 0;       ///< Measured: E(rho), or E_k. Unitless.
    double weight = 1;  ///< [0, ...); 0 = not used.
    int map = 0;        ///< Which map it was measured on.
};

enum class Weighting { kUnweighted, kPopulation, kPopulationOverVariance };

struct SampleOptions {
    Weighting weighting = Weighting::kPopulation;
    double spread_floor = 0.01;  ///< s_0, unitless as E. (0, ...)
};

/// E(rho) of every bin and albedo of every map. Sample::map is the index into `maps`. Throws
/// Error if a map has no facet, sizes that disagree, or a value that is not finite.
std::vector<Sample> TotalSamples(std::span<const BounceHistogram> maps,
                                 const SampleOptions& options = {});

/// E_k of every bin of every map, for one bounce k; k = 0 is V. The albedo of `at` is unknown.
std::vector<Sample> BounceSamples(std::span<const BounceHistogram> maps, int k,
                                  const SampleOptions& options = {});

/// Measured pairs from elsewhere, all of weight 1: `x` is the visibility named, and the only
/// input known. Throws Error if the sizes differ or a value is not finite.
std::vector<Sample> PairSamples(BinnedBy abscissa, std::span<const double> x,
                                std::span<const double> y);

}  // namespace plumb
