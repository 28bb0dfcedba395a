// How loops that nobody handed a monitor hear Ctrl-C: the program names its monitor once.
//
// SilentMonitor(), the default of every function that takes a Monitor, says nothing; it cancels if
// the program's monitor does, and without one never.
#pragma once

#include "core/monitor.h"

namespace plumb {

/// The monitor that SilentMonitor asks whether to stop; null = none, so at the start. Set by the
/// program only, for as long as that monitor lives.
void SetProgramMonitor(const Monitor* monitor);

/// Says nothing and never cancels: for what writes out results after a run was cancelled.
Monitor& DeafMonitor();

}  // namespace plumb
