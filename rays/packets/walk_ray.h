// A ray made ready for its walk through the tree, and how much its walk must allow for.
//
//       The plane at s across axis k is crossed at t = (s - o_k) / d_k, give or take
//
//       w_k = 2^-20 M / |d_k|,     M = the farthest that any corner can be from o along an axis
//
// The near cell is left at t + w at the latest, the far cell entered at t - w at the earliest.
// What w pays for, in units of u M / |d_k| with u = 2^-24: corners sheared in float (6, see
// watertight_test.h), t rounded to float (1), and the arithmetic of t here (3): 10 of 16. So
// every leaf is visited in whose cell a triangle is met, also where rounding moved the meeting
// across the cell's border: the nearest hit is the least (t, triangle) over *all* triangles,
// bit for bit, and does not depend on the tree or on the rays that travel together.
//
// Directions are scaled by a power of two, which is exact, so that their longest component is in
// [1, 2). A component that is shorter than 2^-60 counts as 2^-60 in the walk: along the whole
// scene that is far less than the margin.
//
// Domain   |o_k| <= 1e18 m, finite direction that is not (nearly) 0, near and far no NaN. Rays
//          outside of it meet nothing.
// Source   the margin is ours; that boxes must be tested conservatively for a watertight walk:
//          [Woop13].
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "rays/packets/bsp_tree.h"
#include "rays/packets/watertight_test.h"
#include "rays/ray_caster.h"

namespace plumb {

struct WalkRay {
    static constexpr float kShortest = 0x1p-60f;  ///< Of a direction in the walk.
    static constexpr float kMostOriginM = 1e18f;
    static constexpr float kMostDirection = std::numeric_limits<float>::max();
    static constexpr float kMargin = 0x1p-20f;  ///< Of M.

    std::array<float, 3> origin_m, direction, inverse, margin;
    float near = 0, far = 0;  ///< The ray's own, in lengths of the scaled direction.
    float begin = 0,
          end = -1;          ///< The part of it that is in the tree's box; none: end < begin.
    float per_length = 1;    ///< t in lengths of the direction as given, of t here.
    std::uint32_t kind = 0;  ///< Signs (bits 0 to 2) and longest axis (bits 3, 4): rays of
                             ///< one kind visit cells in one order, sheared along one axis.

    bool EntersBox() const { return begin <= end; }
};

inline WalkRay ReadyToWalk(const Ray& ray, const BspBox& box) {
    WalkRay out;
    out.origin_m = {ray.origin_m[0], ray.origin_m[1], ray.origin_m[2]};
    out.direction = {ray.direction[0], ray.direction[1], ray.direction[2]};
    const std::size_t longest = LongestAxis(out.direction);
    const float power = std::bit_cast<float>(
        std::bit_cast<std::uint32_t>(out.direction[longest]) & 0x7f800000u);
    bool fit = power > 0 && power <= WalkRay::kMostDirection && ray.near <= ray.far;
    for (std::size_t k = 0; k < 3; ++k) {
        fit = fit && std::abs(out.origin_m[k]) <= WalkRay::kMostOriginM &&
              std::abs(out.direction[k]) <= WalkRay::kMostDirection;
    }
    if (!fit) return out;

    out.per_length = 1 / power;
    out.near = ray.near * power;
    out.far = ray.far * power;
    out.begin = out.near;
    out.end = out.far;
    float reach_m = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        reach_m = std::max({reach_m, std::abs(box.low_m[k] - out.origin_m[k]),
                            std::abs(box.high_m[k] - out.origin_m[k])});
    }
    for (std::size_t k = 0; k < 3; ++k) {
        out.direction[k] *= out.per_length;
        const float d = out.direction[k];
        out.inverse[k] =
            1 / (std::abs(d) >= WalkRay::kShortest ? d : std::copysign(WalkRay::kShortest, d));
        out.margin[k] = WalkRay::kMargin * reach_m * std::abs(out.inverse[k]);
        const float a = (box.low_m[k] - out.origin_m[k]) * out.inverse[k];
        const float b = (box.high_m[k] - out.origin_m[k]) * out.inverse[k];
        out.begin = std::max(out.begin, std::min(a, b) - out.margin[k]);
        out.end = std::min(out.end, std::max(a, b) + out.margin[k]);
        out.kind |= std::uint32_t(std::signbit(d)) << k;
    }
    out.kind |= std::uint32_t(longest) << 3;
    return out;
}

}  // namespace plumb
