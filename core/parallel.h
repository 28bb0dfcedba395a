// Loops over both cores whose result does not depend on how many there are.
//
// The range is cut into chunks of a fixed size, whatever the number of threads; a chunk is
// worked on by one thread, in order; chunks may run in any order. So a body that writes only to
// the indices of its chunk, or to a slot of its chunk that is summed afterwards in chunk order,
// gives the same bits on 1 thread and on 64.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "core/monitor.h"

namespace plumb {

/// Threads that loops use from now on: 0 = all that the machine has. Set once, by the program.
void SetThreadCount(int threads);
int ThreadCount();

/// body(begin, end) for every chunk of `chunk_size` indices of [0, n). The chunk number is
/// begin / chunk_size. The first exception thrown by a body is thrown again here, after all
/// running bodies ended. Between chunks the monitor is told the progress and asked whether to
/// stop (then: Interrupted).
void ParallelFor(std::int64_t n, std::int64_t chunk_size,
                 const std::function<void(std::int64_t begin, std::int64_t end)>& body,
                 Monitor& monitor = SilentMonitor(), std::string_view stage = "");

}  // namespace plumb
