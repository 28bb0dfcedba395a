// Error of the light simulation against its run time, as the samples of a facet grow.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/measured.h"
#include "reports/document.h"

namespace plumb {

struct ConvergencePoint {
    std::string method;  ///< "slices" or "rays": one series a method.
    int per_facet = 0;   ///< Slices or rays of a facet.
    Measured seconds;    ///< Of making the links and letting light bounce; see time_in_turns.h.
    double rms_V = 0;    ///< Of V against the reference, over facets.
    double rms_E_half = 0;  ///< Of E(1/2) against the reference, over facets.
    double max_abs_V = 0;   ///< Largest error of V of a facet.
};

struct Convergence {
    std::string map;
    std::string
        reference;  ///< What the errors are measured against, e.g. "slices, 2048 a facet".
    std::int64_t facets = 0;
    int threads = 0;
    std::vector<ConvergencePoint> points;  ///< Ascending in per_facet within a method.
};

/// Its figures, the time that one method takes to the error of another, and both as plots.
doc::Section ConvergenceSection(const Convergence& convergence);

}  // namespace plumb
