// A straight edge, or a bar between two of them, and the exact share of each pixel that it covers.
//
//       strip    low <= <n, p - middle> < high
//       C(i, j)  = A(high - s) - A(low - s),       s = <n, centre of (i, j) - middle>
//
// where A(t) is the area of the unit square on the near side of a line at the signed distance t from
// its centre: with a >= b the larger and the smaller of |n_x|, |n_y|,
//
//       A(t) = 1/2 + t / a                               |t| <= (a - b)/2
//            = 1 - ((a + b)/2 - t)^2 / (2 a b)           up to t = (a + b)/2, then 1
//       A(-t) = 1 - A(t)
//
// Source   ours: the distribution of the sum of two uniform variables, of widths a and b.
// Symbols  Lengths in pixels, y downward; pixel (i, j) is [i, i + 1] x [j, j + 1].
#pragma once

#include <limits>

#include "core/vec.h"

namespace plumb {

/// (cos, sin) of an angle.
Vec2 UnitNormal(double angle_rad);

struct Strip {
    Vec2 middle_px{0, 0};
    Vec2 normal{1, 0};  ///< n, unit.
    double low_px = 0;
    double high_px = std::numeric_limits<double>::infinity();  ///< Infinite: one edge only.

    /// s of a point.
    double Across(const Vec2& p_px) const { return normal.dot(p_px - middle_px); }

    bool Covers(const Vec2& p_px) const {
        const double s = Across(p_px);
        return low_px <= s && s < high_px;
    }

    /// C(i, j). [0, 1]
    double Coverage(int i, int j) const;

    /// From a point to the nearest edge.
    double EdgeDistance(const Vec2& p_px) const;
};

/// A(t) for a line with unit normal n.
double SquareBelow(const Vec2& n, double t);

}  // namespace plumb
