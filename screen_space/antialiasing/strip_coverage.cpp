#include "screen_space/antialiasing/strip_coverage.h"

#include <algorithm>
#include <cmath>

namespace plumb {

double SquareBelow(const Vec2& n, double t) {
    const double a = n.cwiseAbs().maxCoeff(), b = n.cwiseAbs().minCoeff();
    const double distance = std::abs(t);
    double area = 1;
    if (distance <= (a - b) / 2) {
        area = 0.5 + distance / a;
    } else if (distance < (a + b) / 2) {
        const double left = (a + b) / 2 - distance;
        area = 1 - left * left / (2 * a * b);
    }
    return t < 0 ? 1 - area : area;
}

Vec2 UnitNormal(double angle_rad) {
    return {std::cos(angle_rad), std::sin(angle_rad)};
}

double Strip::Coverage(int i, int j) const {
    const double s = Across({i + 0.5, j + 0.5});
    return std::max(0.0, SquareBelow(normal, high_px - s) - SquareBelow(normal, low_px - s));
}

double Strip::EdgeDistance(const Vec2& p_px) const {
    const double s = Across(p_px);
    return std::min(std::abs(s - low_px), std::abs(s - high_px));
}

}  // namespace plumb
