// Where light is measured: a point of a triangle, or all of its area, on one of its sides.
#pragma once

#include <cstdint>

#include "core/vec.h"
#include "core/warp.h"
#include "rays/triangle.h"

namespace plumb {

struct Receiver {
    std::uint32_t triangle = 0;
    bool spread = true;  ///< Over the area, uniformly; otherwise at (b_1, b_2).
    bool back = false;   ///< On the side from which the corners run clockwise.
    double b_1 = 1.0 / 3, b_2 = 1.0 / 3;

    /// Where a sample starts, as (b_1, b_2); `u` of the unit square places it if it is spread.
    Vec2 Place(const Vec2& u) const { return spread ? SampleTriangle(u) : Vec2(b_1, b_2); }
    Vec3 Normal(const Triangle& of) const { return back ? -of.Normal() : of.Normal(); }
};

}  // namespace plumb
