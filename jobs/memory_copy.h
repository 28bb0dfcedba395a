// Copying memory: the limit of this machine that other work is compared with.
#pragma once

#include <cstddef>
#include <vector>

namespace plumb {

/// Larger than any cache, read and written together.
inline constexpr std::size_t kLargeCopyBytes = std::size_t{1} << 28;

class MemoryCopy {
  public:
    /// Of `bytes` read and written together: half of them each.
    explicit MemoryCopy(std::size_t bytes) : from_(bytes / 2, 1), to_(bytes / 2) {}

    /// Once, all threads.
    void operator()();

    /// Read and written by one copy.
    double Bytes() const { return 2 * double(from_.size()); }

  private:
    std::vector<char> from_, to_;
};

}  // namespace plumb
