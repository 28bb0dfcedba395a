#include "core/parallel.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <memory>

#include "core/error.h"

namespace plumb {
namespace {

// The control bounds every user of oneTBB in the process (Embree builds with it too); the arena
// is what our loops run in, because the implicit one never exceeds the machine's own cores.
struct Threads {
    std::unique_ptr<tbb::global_control> control;
    std::unique_ptr<tbb::task_arena> arena = std::make_unique<tbb::task_arena>();
};

Threads& TheThreads() {
    static Threads threads;
    return threads;
}

}  // namespace

void SetThreadCount(int threads) {
    assert(threads >= 0);
    Threads& the = TheThreads();
    the.control.reset();
    if (threads > 0) {
        the.control = std::make_unique<tbb::global_control>(
            tbb::global_control::max_allowed_parallelism, std::size_t(threads));
    }
    the.arena = std::make_unique<tbb::task_arena>(
        threads > 0 ? threads : int{tbb::task_arena::automatic});
}

int ThreadCount() {
    return TheThreads().arena->max_concurrency();
}

void ParallelFor(std::int64_t n, std::int64_t chunk_size,
                 const std::function<void(std::int64_t begin, std::int64_t end)>& body,
                 Monitor& monitor, std::string_view stage) {
    assert(n >= 0 && chunk_size > 0);
    const std::int64_t chunks = (n + chunk_size - 1) / chunk_size;
    std::atomic<std::int64_t> finished = 0;
    const auto work = [&](const tbb::blocked_range<std::int64_t>& range) {
        for (std::int64_t chunk = range.begin(); chunk < range.end(); ++chunk) {
            if (monitor.Cancelled()) throw Interrupted();
            const std::int64_t begin = chunk * chunk_size;
            body(begin, std::min(begin + chunk_size, n));
            monitor.Progress(stage, double(++finished) / double(chunks));
        }
    };
    TheThreads().arena->execute([&] {
        tbb::parallel_for(tbb::blocked_range<std::int64_t>(0, chunks), work,
                          tbb::simple_partitioner());
    });
}

}  // namespace plumb
