// One map simulated again and again with its heights stretched.
//
// Source   [Mayaux18] "Effect of Maximum Height over the Curves": the amplitude is said to have
//          little influence on the curves but for extreme values.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/bounce_histogram.h"
#include "reports/surface_report.h"

namespace plumb {

struct AmplitudePoint {
    double amplitude_m = 0;
    double amplitude_of_width = 0;  ///< amplitude_m over the map's width. Unitless.
    SurfaceFigures figures;
    BounceHistogram over_alpha;  ///< The curves at this amplitude; may be empty.

    double recommended_rms = SurfaceFigures::kUnknown;  ///< E(rho) of the recommended formula.
    double published_rms = SurfaceFigures::kUnknown;    ///< E(rho) of the published formula.
};

struct AmplitudeSweep {
    std::string map;
    std::vector<AmplitudePoint> points;  ///< Ascending in amplitude.
};

}  // namespace plumb
