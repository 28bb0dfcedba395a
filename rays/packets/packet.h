// Rays that travel together: up to 64, component by component.
//
// Source   [Wald01 section 2.4].
// Beware   Places are filled from 0 on; what lies beyond them enters nothing.
#pragma once

#include <array>
#include <cstdint>

#include "rays/packets/walk_ray.h"

namespace plumb {

struct alignas(64) Packet {
    static constexpr std::size_t kMost = 64;
    template <class T>
    using Each = std::array<T, kMost>;
    using Three = std::array<Each<float>, 3>;

    Three origin_m{}, direction{};  ///< As given; the direction is scaled later (walk_ray.h).
    Each<float> near{};
    // Before a walk where the ray ends, after it where its nearest hit is. After a walk for any
    // hit -infinity where there was one.
    Each<float> best{};
    Each<std::uint32_t> triangle{};  ///< Of the hit, or Hit::kNone.
    Each<float> b_1{}, b_2{};

    // Made by MakeReady: the fields of WalkRay, and the shear of watertight_test.h.
    Three inverse{}, margin{};
    Each<float> begin{}, end{}, per_length{}, shear_x{}, shear_y{};
    Each<std::uint32_t> kinds{};

    int rays = 0;            ///< 4, 16 or 64 places.
    std::uint32_t kind = 0;  ///< Of those that walk.

    void Put(std::size_t i, const Ray& ray) {
        for (std::size_t k = 0; k < 3; ++k) {
            origin_m[k][i] = ray.origin_m[int(k)];
            direction[k][i] = ray.direction[int(k)];
        }
        near[i] = ray.near;
        best[i] = ray.far;
    }

    ShearAxes Axes() const {
        const std::size_t longest = kind >> 3;
        return ShearAxes::Of(longest, (kind >> longest) & 1);
    }
    bool IsNegative(std::size_t axis) const { return (kind >> axis) & 1; }
};

}  // namespace plumb
