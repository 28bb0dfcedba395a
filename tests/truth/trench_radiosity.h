// Light in an endless trench of width 1 and depth d by an independent method: the radiosity
// equation of its cross-section, E = V + rho F E, on strips that shrink towards the corners.
//
//       F from a point to a strip seen between angles a and b from the normal: |sin a - sin
//       b|/2
//
// E is constant on a strip, so a point value is off by the square of the strips' size.
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "core/conventions.h"
#include "core/vec.h"

namespace plumb {

class TrenchRadiosity {
  public:
    TrenchRadiosity(double depth, double rho, int strips_a_side) : depth_(depth), rho_(rho) {
        const Vec2 bottom_left(0, -depth), bottom_right(1, -depth);
        AddSide({0, 0}, bottom_left, strips_a_side);
        AddSide(bottom_left, bottom_right, strips_a_side);
        AddSide(bottom_right, {1, 0}, strips_a_side);
        const int n = int(strips_.size());
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n);
        Eigen::VectorXd sky(n);
        for (int i = 0; i < n; ++i) {
            const Vec2 x = (strips_[i].from + strips_[i].to) / 2;
            sky(i) = ToStrip(x, strips_[i].normal, {{1, 0}, {0, 0}, {0, -1}});
            for (int j = 0; j < n; ++j) {
                matrix(i, j) -= rho * ToStrip(x, strips_[i].normal, strips_[j]);
            }
        }
        E_ = matrix.partialPivLu().solve(sky);
    }

    double AtFloor(double x) const { return At({x, -depth_}, {0, 1}); }
    double AtWall(double z) const { return At({0, -z}, {1, 0}); }

  private:
    struct Strip {
        Vec2 from, to, normal;
    };

    void AddSide(const Vec2& a, const Vec2& b, int n) {
        const Vec2 along = (b - a).normalized();
        const auto at = [&](int i) -> Vec2 {  // Denser towards both ends.
            return a + (b - a) * (1 - std::cos(kPi * i / n)) / 2;
        };
        for (int i = 0; i < n; ++i) {
            strips_.push_back({at(i), at(i + 1), {-along.y(), along.x()}});
        }
    }

    static double ToStrip(const Vec2& x, const Vec2& n, const Strip& strip) {
        const auto sine = [&](const Vec2& p) {
            const Vec2 d = p - x;
            return (n.x() * d.y() - n.y() * d.x()) / d.norm();
        };
        const bool own_side =
            std::abs(n.dot(strip.from - x)) < 1e-12 && std::abs(n.dot(strip.to - x)) < 1e-12;
        return own_side ? 0 : std::abs(sine(strip.from) - sine(strip.to)) / 2;
    }

    double At(const Vec2& x, const Vec2& n) const {
        double E = ToStrip(x, n, {{1, 0}, {0, 0}, {0, -1}});
        for (int j = 0; j < int(strips_.size()); ++j) {
            E += rho_ * ToStrip(x, n, strips_[j]) * E_(j);
        }
        return E;
    }

    double depth_, rho_;
    std::vector<Strip> strips_;
    Eigen::VectorXd E_;
};

}  // namespace plumb
