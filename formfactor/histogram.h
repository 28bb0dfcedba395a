// Light gathered over a visibility: what the paper's curves, and all fits, are made from.
//
// Facets are put into bins by their alpha (or V); a bin gives the count, the true mean
// abscissa, and the mean, variance and 5/50/95 percentiles of every E_k and E(rho). The
// variance within a bin is the error that no curve of that abscissa can remove: its floor,
//
//       floor^2 = Sum_bins n_b var_b / Sum_bins n_b
//
// Source   [Mayaux18] "Collecting Data", step 4.
// Beware   The bins' own width adds to the spread, by slope^2 width^2 / 12: under 1e-3 at
//          100 bins.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/bounce_histogram.h"

namespace plumb {

/// Gathers one quantity after another over bins that are cut once.
class HistogramBuilder {
  public:
    /// `bins` of equal width over [0, 1], by alpha or by V of every facet; by both, a grid of
    /// bins x bins. Throws Error unless 1 <= bins <= 100000 (1000 by both) and the two spans
    /// have one length > 0.
    HistogramBuilder(std::string surface, BinnedBy binned_by, int bins,
                     std::span<const double> alpha, std::span<const double> V);

    void AddBounce(std::span<const double> E_k);
    void AddTotal(double albedo, std::span<const float> E);

    const BounceHistogram& Result() const { return histogram_; }

  private:
    template <class T>
    void Add(std::span<const T> values, std::vector<Spread> BounceBin::*member);

    BounceHistogram histogram_;
    std::vector<std::uint32_t> order_;  // Facets, bin after bin, ascending within.
    std::vector<std::size_t> bin_begin_;
};

/// The floor of the header for E_k (`total` false) or E(rho) number k (`total` true), over the
/// bins of two facets or more: one alone shows no spread. Unitless.
double FloorOf(const BounceHistogram& histogram, int k, bool total);

}  // namespace plumb
