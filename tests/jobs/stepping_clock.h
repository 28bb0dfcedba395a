// A clock whose times are known: the intervals between its first and second look, third and fourth,
// ... last 1, 2, 3, ... seconds.
#pragma once

#include "core/clock.h"

namespace plumb {

inline Clock SteppingClock() {
    return [now_s = 0.0, looks = 0]() mutable {
        if (++looks % 2 == 0) now_s += looks / 2;
        return now_s;
    };
}

}  // namespace plumb
