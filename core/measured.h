// A number with its uncertainty: the one form in which figures travel from those who measure them
// to those who print and compare them.
#pragma once

#include <limits>

#include "core/intervals.h"

namespace plumb {

struct Measured {
    double value = std::numeric_limits<double>::quiet_NaN();

    /// NaN where it is not known (a time has a spread, and no standard error).
    double standard_error = std::numeric_limits<double>::quiet_NaN();

    /// Holds the true value with the confidence that its maker names.
    Interval interval{-std::numeric_limits<double>::infinity(),
                      std::numeric_limits<double>::infinity()};

    /// The part of it that comes from the noise of the reference alone, the candidate and the view
    /// being what they are: the one to hold against a change of the same view. NaN where it is not
    /// known, or not of this kind.
    double noise_error = std::numeric_limits<double>::quiet_NaN();
};

/// In another unit. `factor` > 0.
inline Measured operator*(double factor, const Measured& m) {
    return {.value = factor * m.value,
            .standard_error = factor * m.standard_error,
            .interval = {.low = factor * m.interval.low, .high = factor * m.interval.high},
            .noise_error = factor * m.noise_error};
}

}  // namespace plumb
