// A triangle as it is seen through points of the picture: perspective-correct interpolation.
//
//       b_k = w . m_k / (w . n),   m_0 = P_1 x P_2 and so on,   n = m_0 + m_1 + m_2
//       t   = n . P_0 / (w . n)           w = (x_s tan_half_width, y_s tan_half_height, -1)
//
// Nothing is divided by a corner's depth, so corners may lie behind the camera.
//
// Symbols  P_k corners in the camera's frame (m), w the direction of a pixel, b_k barycentric
//          coordinates of the point seen, t its distance from the camera's plane (m).
#pragma once

#include <algorithm>
#include <array>

#include "core/vec.h"
#include "screen_space/view.h"

namespace plumb {

class SeenTriangle {
  public:
    explicit SeenTriangle(const std::array<Vec3, 3>& corners_m)
        : P_(corners_m),
          m_{P_[1].cross(P_[2]), P_[2].cross(P_[0]), P_[0].cross(P_[1])},
          n_((P_[1] - P_[0]).cross(P_[2] - P_[0])) {}

    /// b, each in [0, 1], with sum 1. A pixel that rounding gave to the triangle though its
    /// centre lies outside gets a point of the triangle nearby.
    Vec3 Weights(const View& view, double x_px, double y_px) const {
        const Vec3 w = view.Point(x_px, y_px, -1);
        Vec3 b(w.dot(m_[0]), w.dot(m_[1]), w.dot(m_[2]));
        const double sum = b.sum();
        if (sum != 0) b /= sum;
        b = b.cwiseMax(0);
        const double inside = b.sum();
        // Written so that NaN and an edge-on triangle end here too.
        return inside > 0 && inside < 1e30 ? Vec3(b / inside) : Vec3::Constant(1.0 / 3);
    }

    /// The point of the corners' weights.
    Vec3 PointM(const Vec3& b) const { return b[0] * P_[0] + b[1] * P_[1] + b[2] * P_[2]; }

    /// Unit, towards the viewer.
    Vec3 Normal() const {
        const double length = n_.norm();
        if (!(length > 0)) return Vec3::UnitZ();
        return n_.dot(P_[0]) > 0 ? Vec3(-n_ / length) : Vec3(n_ / length);
    }

    /// d/dx_px and d/dy_px of a quantity that is linear on the triangle, with these values at
    /// the corners.
    Vec2 Derivatives(const View& view, double x_px, double y_px, const Vec3& values) const {
        const Vec3 w = view.Point(x_px, y_px, -1);
        const Vec3 w_x(2 * view.tan_half_width / view.width_px, 0, 0);
        const Vec3 w_y(0, -2 * view.tan_half_height / view.height_px, 0);
        const Vec3 sum = m_[0] + m_[1] + m_[2];
        const Vec3 U = values[0] * m_[0] + values[1] * m_[1] + values[2] * m_[2];
        const double below = w.dot(sum), above = w.dot(U);
        const auto slope = [&](const Vec3& step) {
            return (step.dot(U) * below - above * step.dot(sum)) / (below * below);
        };
        return {slope(w_x), slope(w_y)};
    }

  private:
    std::array<Vec3, 3> P_, m_;
    Vec3 n_;
};

}  // namespace plumb
