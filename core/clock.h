// Where a run takes its times from.
//
// Kernels have no clock (style: values in, values out). Who measures times is handed one, so that a
// test can hand one in whose times are known.
#pragma once

#include <functional>

namespace plumb {

/// Seconds from some fixed moment.
using Clock = std::function<double()>;

}  // namespace plumb
