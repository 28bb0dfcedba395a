// The rising function that fits best: isotonic regression.
//
//       minimize  Sum_k w_k (f(x_k) - y_k)^2      over all f that never fall
//
// Pool adjacent violators: in order of x, whenever a mean lies below the one before it, the
// two groups are one group with their common mean. What is left are levels, each the mean of
// its y.
//
// Source   [Ayer55] M. Ayer, H. Brunk, G. Ewing, W. Reid, E. Silverman, An Empirical
//          Distribution Function for Sampling with Incomplete Information, Annals of
//          Mathematical Statistics 26(4), 1955.
// Beware   Between levels f is drawn as a straight line, beyond the data it is constant.
#pragma once

#include <span>
#include <vector>

namespace plumb {

struct MonotoneMap {
    struct Level {
        double first_x = 0, last_x = 0;  ///< f = y on [first_x, last_x].
        double y = 0;
    };
    std::vector<Level> levels;  ///< Rising in x and in y.

    /// f(x). Needs a level.
    double operator()(double x) const;
};

struct MonotoneSample {
    double x = 0, y = 0;
};

/// The best f for samples of equal weight, sorted by x; equal x share one value. Cost: n.
MonotoneMap FitSorted(std::span<const MonotoneSample> samples);

/// The same of samples in any order. Cost: n log n.
MonotoneMap FitMonotone(std::vector<MonotoneSample> samples);

}  // namespace plumb
