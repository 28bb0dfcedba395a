// How a long computation tells its caller how far it is, and learns that it should stop.
//
// Kernels have no clock, no log and no signal handler (style: values in, values out). A job
// hands them a Monitor; the command line's monitor draws a progress line and knows about
// Ctrl-C.
#pragma once

#include <string_view>

namespace plumb {

class Monitor {
  public:
    virtual ~Monitor() = default;

    /// `done` of [0, 1] of the stage named is finished. May be called from any thread.
    virtual void Progress(std::string_view stage, double done) = 0;

    /// True once the run should end. Whoever sees it throws Interrupted.
    virtual bool Cancelled() const = 0;
};

/// Says nothing, never cancels: the default of every function that takes a Monitor.
Monitor& SilentMonitor();

}  // namespace plumb
