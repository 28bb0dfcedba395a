#include "jobs/memory_copy.h"

#include <cstdint>
#include <cstring>

#include "core/parallel.h"

namespace plumb {

void MemoryCopy::operator()() {
    constexpr std::int64_t kChunk = 1 << 20;
    ParallelFor(std::int64_t(from_.size()), kChunk, [&](std::int64_t begin, std::int64_t end) {
        std::memcpy(to_.data() + begin, from_.data() + begin, std::size_t(end - begin));
    });
}

}  // namespace plumb
