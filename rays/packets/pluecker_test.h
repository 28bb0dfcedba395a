// A ray against a triangle by the sides on which it passes the edges.
//
//       a, b, c are the corners seen from the ray's origin
//       w_0 = d . (c x b),   w_1 = d . (a x c),   w_2 = d . (b x a)
//       met if none of them is < 0 or none is > 0, and D = w_0 + w_1 + w_2 is not 0
//       t = N . a / N . d,   N = (b - a) x (c - a),   b_1 = w_1 / D,   b_2 = w_2 / D
//
// w is the permuted inner product of the Pluecker coordinates of ray and edge, with the ray's
// origin as that of the coordinates: (d : 0) and (q - p : p x q) leave d . (p x q).
//
// Source   [Wald01 section 3.2] and [Shoemake98] K. Shoemake, Pluecker Coordinate Tutorial, Ray
//          Tracing News 11(1).
// Symbols  d direction; lengths in metres, t in lengths of d.
// Beware   In float: where w cancels its sign is a matter of rounding, though the same for both
//          triangles of an edge. N . d = D up to rounding, and t is the less sure the more a
//          triangle is seen edge-on.
#pragma once

#include <algorithm>
#include <array>

#include "rays/packets/triangle_record.h"
#include "rays/packets/watertight_test.h"

namespace plumb {

class PlueckerTest {
  public:
    PlueckerTest(const std::array<float, 3>& origin_m, const std::array<float, 3>& direction)
        : o_(origin_m), d_(direction) {}

    bool Meets(const TriangleRecord& record, Meeting& meeting) const {
        std::array<std::array<float, 3>, 3> p;
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t k = 0; k < 3; ++k) p[c][k] = record.Corner(c, k) - o_[k];
        }
        const float w_0 = Dot(d_, Cross(p[2], p[1]));
        const float w_1 = Dot(d_, Cross(p[0], p[2]));
        const float w_2 = Dot(d_, Cross(p[1], p[0]));
        if (std::min({w_0, w_1, w_2}) < 0 && std::max({w_0, w_1, w_2}) > 0) return false;
        const float D = w_0 + w_1 + w_2;
        std::array<float, 3> e, f;
        for (std::size_t k = 0; k < 3; ++k) {
            e[k] = p[1][k] - p[0][k];
            f[k] = p[2][k] - p[0][k];
        }
        const std::array<float, 3> n = Cross(e, f);
        const float along = Dot(n, d_);
        if (D == 0 || along == 0) return false;
        meeting.t = Dot(n, p[0]) / along;
        meeting.b_1 = w_1 / D;
        meeting.b_2 = w_2 / D;
        return true;
    }

  private:
    using V = std::array<float, 3>;
    static V Cross(const V& p, const V& q) {
        return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2],
                p[0] * q[1] - p[1] * q[0]};
    }
    static float Dot(const V& p, const V& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

    V o_, d_;
};

}  // namespace plumb
