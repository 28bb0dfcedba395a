// A triangle as the tests of this folder read it: 48 bytes, four to three cache lines.
//
//       numbers   by the test that reads them: three corners (watertight_test.h,
//                 pluecker_test.h), or what is prepared of planes (projected_test.h)
//       axis      of projected_test.h only
//       id        what a Hit names
//
// Source   [Wald01 section 2.2 and 3.1]: what a test needs is kept together, nothing else with
//          it, and 37 bytes become 48.
#pragma once

#include <array>
#include <cstdint>

#include "rays/packets/bsp_reference.h"

namespace plumb {

struct alignas(16) TriangleRecord {
    std::array<float, 9> numbers{};
    std::uint32_t axis = 0;
    std::uint32_t id = 0;
    std::uint32_t holes = 0;  ///< Not 0: a hit counts only where the surface is solid.

    float Corner(std::size_t corner, std::size_t k) const { return numbers[3 * corner + k]; }
};
static_assert(sizeof(TriangleRecord) == 48);

inline TriangleRecord RecordOfCorners(const Corners& corners_m) {
    TriangleRecord record;
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t k = 0; k < 3; ++k) record.numbers[3 * c + k] = corners_m[c][k];
    }
    return record;
}

}  // namespace plumb
