// How a technique of several passes tells what it did: pass by pass, to whoever asked.
//
// The one who asks holds the stopwatch: the time between two calls is that of the later call's
// pass. A picture told is good until the observer returns.
#pragma once

#include <functional>
#include <string_view>

#include "core/image.h"

namespace plumb {

/// The pass that has just ended, and A of the drawn size after it; empty where it makes no picture.
using PassObserver = std::function<void(std::string_view pass, const Image<float>& A)>;

}  // namespace plumb
