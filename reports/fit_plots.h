// What the plots of a fit report share: whose data a reader may choose, and shorthands.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reports/fit_report.h"
#include "reports/plot.h"

namespace plumb::fit_sections {

/// A histogram under the name by which the reader picks it.
struct Choice {
    std::string name;
    BounceHistogram histogram;
    bool pooled = false;
};

/// All maps together (if there are several), then each one.
std::vector<Choice> Choices(const FitReport& report, BounceHistogram SurfaceReport::*member);

std::vector<std::string> Names(const std::vector<Choice>& choices);

/// Where a formula is evaluated for a bin: at its true means.
LightPoint At(const BounceBin& bin, double rho = SurfaceFigures::kUnknown);

/// Not joined, of the first shape.
inline PlotSeries Series(std::string label, Mark mark, std::string color, Column x, Column y,
                         Column minus = {}, Column high = {}) {
    return {std::move(label), mark,           std::move(color), std::move(x), std::move(y),
            std::move(minus), std::move(high)};
}

/// A residual axis that holds every finite error up to 0.5; larger ones are cut off.
Axis ResidualAxis(std::string label, double largest);

/// largest = max(largest, |difference|) unless that is not finite.
void TakeLargest(double& largest, double difference);

/// One curve over alpha: a fit, or the published constants.
struct DrawnCurve {
    std::string label, color;
    Mark mark;
    const Formula* formula;  ///< Of the report.
};

/// The curves fitted to E_`bounce`, and the published one.
std::vector<DrawnCurve> CurvesOf(const FitReport& report, int bounce);

}  // namespace plumb::fit_sections
