// Every fit and every score of a fit report, from light that is simulated already.
//
//       light -> curves; baselines; totals fitted, held out, chosen among; faults; floors
//
// Source   [Mayaux18], "Collecting Data" onwards; the models of ours are in fit/.
#pragma once

#include <span>

#include "core/monitor.h"
#include "jobs/light/fit_constants.h"
#include "jobs/light/simulate_surface.h"
#include "reports/fit_report.h"

namespace plumb {

/// Fills curves, bounce_family, totals, formulas, floors, faults and, of four maps or more,
/// choice. With one map nothing is held out.
void FitTotals(std::span<const SurfaceLight> lights, const FitSettings& settings,
               FitReport& report, Monitor& monitor = SilentMonitor());

}  // namespace plumb
