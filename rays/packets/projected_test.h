// A ray against a triangle: first the plane, then barycentric coordinates in a projection.
//
//       k is the axis along which the triangle's normal N is longest, u and v the next ones;
//       n = N / N_k
//
//       t   = (n . a - o_k - n_u o_u - n_v o_v) / (d_k + n_u d_u + n_v d_v)
//       H   = o + t d, of which only H_u and H_v are needed
//       b_1 = H_u p_u + H_v p_v + p_0,   b_2 = H_u q_u + H_v q_v + q_0
//       met if b_1 >= 0, b_2 >= 0 and b_1 + b_2 <= 1
//
// p and q are scaled equations of two edges. Prepared in double and kept in 9 floats: n_u, n_v,
// n . a, p_u, p_v, p_0, q_u, q_v, q_0.
//
// Source   [Wald01 section 3.1], after [Badouel90] D. Badouel, An Efficient Ray-Polygon
//          Intersection, Graphics Gems.
// Symbols  a first corner, o, d origin (m) and direction, t in lengths of d.
// Beware   Neither watertight nor sure far from the origin of the coordinates: n . a and p_0
//          round relative to the corners' distance from it. Meant for comparison.
#pragma once

#include <array>

#include "rays/packets/triangle_record.h"
#include "rays/packets/watertight_test.h"

namespace plumb {

/// Of a triangle with an area.
TriangleRecord RecordOfPlanes(const Corners& corners_m);

class ProjectedTest {
  public:
    ProjectedTest(const std::array<float, 3>& origin_m, const std::array<float, 3>& direction)
        : o_(origin_m), d_(direction) {}

    bool Meets(const TriangleRecord& record, Meeting& meeting) const {
        const std::array<float, 9>& r = record.numbers;
        const std::size_t k = record.axis, u = (k + 1) % 3, v = (k + 2) % 3;
        const float along = d_[k] + r[0] * d_[u] + r[1] * d_[v];
        const float t = (r[2] - o_[k] - r[0] * o_[u] - r[1] * o_[v]) / along;
        const float H_u = o_[u] + t * d_[u], H_v = o_[v] + t * d_[v];
        const float b_1 = H_u * r[3] + H_v * r[4] + r[5];
        const float b_2 = H_u * r[6] + H_v * r[7] + r[8];
        if (!(b_1 >= 0 && b_2 >= 0 && b_1 + b_2 <= 1)) return false;
        meeting = {t, b_1, b_2};
        return true;
    }

  private:
    std::array<float, 3> o_, d_;
};

}  // namespace plumb
