// A ray against a triangle so that no ray passes between two neighbours.
//
//       z is the axis along which the ray is longest, x and y the others; the ray's origin is
//       moved to 0 and space is sheared so that the ray runs along z:
//
//       A_x = (a - o)_x - S_x (a - o)_z,   S_x = d_x / d_z        B, C and y likewise
//       U = C_x B_y - C_y B_x,   V = A_x C_y - A_y C_x,   W = B_x A_y - B_y A_x
//       met if none of U, V, W is < 0 or none is > 0, and U + V + W = D is not 0
//       t = (U (a-o)_z + V (b-o)_z + W (c-o)_z) / (D d_z),   b_1 = V / D,   b_2 = W / D
//
// Two triangles that share an edge compute the same products for it, with the opposite sign: a
// ray that one of them misses there meets the other.
//
// We differ from the paper in what follows the float test. Corners are sheared in float, as in
// print; products of them are exact in double, so U, V and W in double have the signs of the
// sheared triangle's own, and t and the barycentric coordinates are good to 2^-24 of the
// triangle even where it is seen edge-on and U, V, W cancel. A float product rounds
// monotonically: a float U that is not 0 has the right sign, so the float test refuses nobody
// whom double would take.
//
// Source   [Woop13] S. Woop, C. Benthin, I. Wald, Watertight Ray/Triangle Intersection, JCGT
//          2(1), 2013.
// Symbols  o, d origin (m) and direction, a, b, c corners (m), t in lengths of d.
// Beware   The sheared corner is off by up to 6 u (|a-o|_x + |a-o|_z) / 2, u = 2^-24: a
//          triangle is met as if its corners were moved so far. walk_ray.h allows for it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "rays/packets/triangle_record.h"

namespace plumb {

/// Which axes play x, y and z.
struct ShearAxes {
    std::size_t x, y, z;

    /// As the paper has them, so that triangles keep their sense: depends on the axis along
    /// which the direction is longest, and on its sign.
    static ShearAxes Of(std::size_t longest, bool negative) {
        const std::size_t next = (longest + 1) % 3, after = (longest + 2) % 3;
        return negative ? ShearAxes{after, next, longest} : ShearAxes{next, after, longest};
    }
};

/// The first of the axes along which |direction| is greatest.
inline std::size_t LongestAxis(const std::array<float, 3>& direction) {
    const float x = std::abs(direction[0]), y = std::abs(direction[1]),
                z = std::abs(direction[2]);
    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

/// Where a ray meets a triangle. t is not compared with anything yet.
struct Meeting {
    float t = 0, b_1 = 0, b_2 = 0;
};

class WatertightTest {
  public:
    WatertightTest(const std::array<float, 3>& origin_m, const std::array<float, 3>& direction)
        : origin_m_(origin_m) {
        const std::size_t longest = LongestAxis(direction);
        axes_ = ShearAxes::Of(longest, std::signbit(direction[longest]));
        d_z_ = direction[axes_.z];
        shear_x_ = direction[axes_.x] / d_z_;
        shear_y_ = direction[axes_.y] / d_z_;
    }

    bool Meets(const TriangleRecord& record, Meeting& meeting) const {
        std::array<float, 3> x, y, z;
        for (std::size_t c = 0; c < 3; ++c) {
            z[c] = record.Corner(c, axes_.z) - origin_m_[axes_.z];
            x[c] = record.Corner(c, axes_.x) - origin_m_[axes_.x] - shear_x_ * z[c];
            y[c] = record.Corner(c, axes_.y) - origin_m_[axes_.y] - shear_y_ * z[c];
        }
        const float u = x[2] * y[1] - y[2] * x[1];
        const float v = x[0] * y[2] - y[0] * x[2];
        const float w = x[1] * y[0] - y[1] * x[0];
        if (std::min({u, v, w}) < 0 && std::max({u, v, w}) > 0) return false;
        const auto edge = [&](std::size_t i, std::size_t j) {
            return double(x[i]) * double(y[j]) - double(y[i]) * double(x[j]);
        };
        const double U = edge(2, 1), V = edge(0, 2), W = edge(1, 0);
        if (std::min({U, V, W}) < 0 && std::max({U, V, W}) > 0) return false;
        const double D = U + V + W;
        if (D == 0) return false;
        const double d_z = double(d_z_), per = 1 / (D * d_z), per_D = per * d_z;
        meeting.t = float((U * double(z[0]) + V * double(z[1]) + W * double(z[2])) * per);
        meeting.b_1 = float(V * per_D);
        meeting.b_2 = float(W * per_D);
        return true;
    }

  private:
    std::array<float, 3> origin_m_;
    ShearAxes axes_;
    float shear_x_, shear_y_, d_z_;
};

}  // namespace plumb
