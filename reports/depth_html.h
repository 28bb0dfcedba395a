// The part of a page that shows what depth buffers keep: [McGuire12] figures 3 and 4.
#pragma once

#include <string>

#include "reports/plot.h"
#include "reports/z_precision_report.h"

namespace plumb {

/// The plot of z's error against distance, worst cases of all combinations, and of normals.
std::string DepthHtml(const ZPrecisionReport& report, PlotSheet& sheet);

}  // namespace plumb
