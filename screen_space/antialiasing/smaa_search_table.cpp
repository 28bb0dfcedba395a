#include "screen_space/antialiasing/smaa_search_table.h"

#include <array>
#include <optional>

namespace plumb {
namespace {

// The bits that a fetch of e / 32 has seen: far and near of the row above, far and near.
struct Seen {
    bool far_above, near_above, far, near;
};

std::array<std::optional<Seen>, 33> Decoded() {
    std::array<std::optional<Seen>, 33> of;
    for (unsigned bits = 0; bits < 16; ++bits) {
        const Seen seen{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0};
        of[seen.far_above + 3u * seen.near_above + 7u * seen.far + 21u * seen.near] = seen;
    }
    return of;
}

int ReachLeft(const Seen& cross, const Seen& run) {
    if (!run.near) return 0;
    return run.far && !cross.near && !cross.near_above ? 2 : 1;
}

int ReachRight(const Seen& cross, const Seen& run) {
    if (!run.near || cross.near || cross.near_above) return 0;
    return run.far && !cross.far && !cross.far_above ? 2 : 1;
}

}  // namespace

std::vector<std::uint8_t> SmaaSearchTable() {
    const std::array<std::optional<Seen>, 33> seen = Decoded();
    std::vector<std::uint8_t> table(std::size_t(kSmaaSearchWidth) * kSmaaSearchHeight, 0);
    for (std::size_t y = 0; y < kSmaaSearchHeight; ++y) {
        const std::optional<Seen>& run = seen[32 - y];
        for (std::size_t x = 0; x < kSmaaSearchWidth; ++x) {
            const std::optional<Seen>& cross = seen[x % 33];
            if (!run || !cross) continue;
            const int reach = x < 33 ? ReachLeft(*cross, *run) : ReachRight(*cross, *run);
            table[y * kSmaaSearchWidth + x] = std::uint8_t(127 * reach);
        }
    }
    return table;
}

}  // namespace plumb
