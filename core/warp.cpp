#include "core/warp.h"

#include <algorithm>
#include <cmath>

#include "core/conventions.h"

namespace plumb {
namespace {

/// phi / (2 pi) of a point, in [0, 1).
double Turn(double x, double y) {
    const double turn = std::atan2(y, x) / (2 * kPi);
    return turn < 0 ? turn + 1 : turn;
}

// [Shirley97]: concentric squares become concentric circles. The square is cut by its diagonals
// into four wedges; in each, (radius, angle) are linear in the coordinates. `r` is signed: it
// is negative in the left and lower wedge, where the angle is measured from the other end.
struct Polar {
    double r, phi_rad;
};

Polar DiskPolar(const Vec2& u) {
    const double a = 2 * u.x() - 1, b = 2 * u.y() - 1;
    if (a == 0 && b == 0) return {0, 0};
    return std::abs(a) > std::abs(b) ? Polar{a, kPi / 4 * (b / a)}
                                     : Polar{b, kPi / 2 - kPi / 4 * (a / b)};
}

}  // namespace

Vec3 SampleUniformHemisphere(const Vec2& u) {
    const double z = 1 - u.x(), phi_rad = 2 * kPi * u.y();
    const double r = std::sqrt(u.x() * (1 + z));  // 1 - z^2 without the cancellation
    return {r * std::cos(phi_rad), r * std::sin(phi_rad), z};
}

double PdfUniformHemisphere(const Vec3& w) {
    return w.z() < 0 ? 0 : 1 / (2 * kPi);
}

Vec2 InvertUniformHemisphere(const Vec3& w) {
    return {1 - w.z(), Turn(w.x(), w.y())};
}

Vec3 SampleCosineHemisphere(const Vec2& u) {
    const auto [r, phi_rad] = DiskPolar(u);
    const double z = std::sqrt((1 - r) * (1 + r));
    return {r * std::cos(phi_rad), r * std::sin(phi_rad), z};
}

double PdfCosineHemisphere(const Vec3& w) {
    return std::max(0.0, w.z()) / kPi;
}

Vec2 InvertCosineHemisphere(const Vec3& w) {
    return InvertDisk(w.head<2>());
}

Vec2 SampleDisk(const Vec2& u) {
    const auto [r, phi_rad] = DiskPolar(u);
    return {r * std::cos(phi_rad), r * std::sin(phi_rad)};
}

double PdfDisk(const Vec2& p) {
    return p.squaredNorm() > 1 ? 0 : 1 / kPi;
}

Vec2 InvertDisk(const Vec2& p) {
    const double r = p.norm();
    // The wedge to the right or left holds |p_y| < |p_x|, as it does in the square.
    double a, b;
    if (std::abs(p.x()) > std::abs(p.y())) {
        a = std::copysign(r, p.x());
        b = a * std::atan(p.y() / p.x()) * (4 / kPi);
    } else {
        b = std::copysign(r, p.y());
        a = p.y() == 0 ? 0 : b * std::atan(p.x() / p.y()) * (4 / kPi);
    }
    return {(a + 1) / 2, (b + 1) / 2};
}

Vec2 SampleTriangle(const Vec2& u) {
    // 1 - b_0 is the height of a strip parallel to the side b_0 = 0; its length grows in
    // proportion, so the area beyond it is the square.
    const double strip = std::sqrt(u.x());
    return {1 - strip, strip * u.y()};
}

double PdfTriangle(const Vec2& b) {
    return b.x() < 0 || b.y() < 0 || b.x() + b.y() > 1 ? 0 : 2;
}

Vec2 InvertTriangle(const Vec2& b) {
    const double strip = 1 - b.x();
    return {strip * strip, strip == 0 ? 0 : b.y() / strip};
}

Basis::Basis(const Vec3& normal) : n(normal) {
    // [Duff17]: continuous but for the sign of n_z, and never near a division by 0.
    const double sign = std::copysign(1.0, n.z());
    const double a = -1 / (sign + n.z()), b = n.x() * n.y() * a;
    s = Vec3(1 + sign * n.x() * n.x() * a, sign * b, -sign * n.x());
    t = Vec3(b, sign + n.y() * n.y() * a, -n.y());
}

}  // namespace plumb
