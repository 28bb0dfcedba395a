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
};

}  // namespace plumb
