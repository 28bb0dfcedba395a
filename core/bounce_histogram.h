// What a light simulation says of one surface, gathered over a visibility: the data of every
// fit.
//
// A bin holds the facets whose alpha (or V) lies in its interval. It keeps its true mean
// abscissa, never an edge or a centre: [Mayaux18]'s constants carry half a bin of shift from
// that.
//
// Symbols  alpha, V, E_k, E(rho) as in core/conventions.h.
// Beware   Every facet counts once: facets share one projected area, so this is the paper's
//          count of texels, not a mean over the true area of steep walls.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace plumb {

/// Mean, variance and percentiles of one quantity within one bin.
struct Spread {
    double mean = 0;
    double variance = 0;  ///< Of a facet about the bin's mean, not of the mean.
    double p05 = 0, p50 = 0, p95 = 0;
};

struct BounceBin {
    double low = 0, high = 0;  ///< The interval [low, high); the last bin is closed.
    std::int64_t count =
        0;             ///< Facets in the bin. 0 = empty: every mean is 0 and means nothing.
    double alpha = 0;  ///< Mean uniform visibility of the facets in the bin.
    double V = 0;      ///< Mean cosine visibility.
    std::vector<Spread> bounce;  ///< E_k, k = 0 ... K (E_0 = V).
    std::vector<Spread> total;   ///< E(rho) for every albedo of the histogram.
};

/// Which visibility the bins are cut by. Bins by both are the squares of a grid over (alpha,
/// V), row after row of rising alpha; low and high are then those of alpha.
enum class BinnedBy { kUniformVisibility, kCosineVisibility, kBothVisibilities };

struct BounceHistogram {
    std::string surface;  ///< Name of the map that it was measured on.
    BinnedBy binned_by = BinnedBy::kUniformVisibility;
    std::vector<double> albedos;  ///< rho of BounceBin::total, ascending, each in [0, 1].
    std::vector<BounceBin> bins;

    int Bounces() const { return bins.empty() ? 0 : int(bins.front().bounce.size()) - 1; }
};

}  // namespace plumb
