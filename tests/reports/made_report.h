// A small fit report made up by hand: two maps, four bins of which one is empty, three albedos.
#pragma once

#include "reports/fit_report.h"
#include "reports/simulate_report.h"

namespace plumb::made {

/// The name of the first map: what must not get through to a page or a table as it stands.
inline constexpr const char* kHostileName = "<b>\"x\"</b>, </script>=1";

/// The second map has nothing measured but its histograms: its figures are NaN.
FitReport MakeFitReport();

SimulateReport MakeSimulateReport();

}  // namespace plumb::made
