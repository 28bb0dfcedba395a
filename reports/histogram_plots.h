// What plots over the bins of a histogram share.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/bounce_histogram.h"
#include "reports/plot.h"

namespace plumb {

/// The name of the axis that a histogram is cut by.
std::string AbscissaLabel(BinnedBy binned_by);

/// One number of each bin that is not empty, as a column.
template <class Get>
Column BinColumn(const BounceHistogram& histogram, Get&& get) {
    std::vector<double> values;
    for (const BounceBin& bin : histogram.bins)
        if (bin.count > 0) values.push_back(get(bin));
    return values;
}

/// The bins' true mean abscissae.
Column Abscissae(const BounceHistogram& histogram);

/// Maps put together bin by bin, every map the same say: w = n_bin / n_map. Means only: the
/// percentiles of several maps do not follow from each map's own. None if the bins differ.
std::optional<BounceHistogram> PooledMeans(std::span<const BounceHistogram* const> maps);

/// The colour of bounce 1 ... last, by its logarithm: the first bounces differ most.
std::string BounceColor(int bounce, int last);

/// Which bounces have their name in a legend: 1, 2, 3, 5, 10, 20, ...
bool InLegend(int bounce);

/// Indices of the albedos that a plot shows: multiples of 0.1 if the histogram has six or more
/// of them, else all.
std::vector<std::size_t> PlottedAlbedos(const std::vector<double>& albedos);

}  // namespace plumb
