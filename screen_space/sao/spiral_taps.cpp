#include "screen_space/sao/spiral_taps.h"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "core/conventions.h"

namespace plumb {
namespace {

// G3D 10, AmbientOcclusionSettings: indexed by the number of taps.
constexpr std::array<int, 100> kLeastDiscrepancyTurns{
    1,  1,  1,  2,  3,  2,  5,  2,  3,  2,   //  0
    3,  3,  5,  5,  3,  4,  7,  5,  5,  7,   // 10
    9,  8,  5,  5,  7,  7,  7,  8,  5,  8,   // 20
    11, 12, 7,  10, 13, 8,  11, 8,  7,  14,  // 30
    11, 11, 13, 12, 13, 19, 17, 13, 11, 18,  // 40
    19, 11, 11, 14, 17, 21, 15, 16, 17, 18,  // 50
    13, 17, 11, 17, 19, 18, 25, 18, 19, 19,  // 60
    29, 21, 19, 27, 31, 29, 21, 18, 17, 29,  // 70
    31, 31, 23, 18, 25, 26, 25, 23, 19, 34,  // 80
    19, 27, 21, 25, 39, 29, 17, 21, 27, 29,  // 90
};
constexpr int kLargePrime = 5779;  // Of the same file, for every larger number of taps.

}  // namespace

int SpiralTurns(int samples) {
    assert(samples > 0);
    return samples < int(kLeastDiscrepancyTurns.size())
               ? kLeastDiscrepancyTurns[std::size_t(samples)]
               : kLargePrime;
}

UnitTap SpiralTap(int i, int samples, int turns, double full_turn_rad) {
    assert(0 <= i && i < samples);
    const double alpha = (i + 0.5) / samples;  // [McGuire12 eq. 6]
    return {.alpha = alpha, .angle_rad = full_turn_rad * alpha * turns};
}

UnitTap SunflowerTap(int i, int samples) {
    assert(0 <= i && i < samples);
    const double golden_angle = 2 * kPi * (2 - std::numbers::phi);
    return {.alpha = std::sqrt((i + 0.5) / samples), .angle_rad = i * golden_angle};
}

}  // namespace plumb
