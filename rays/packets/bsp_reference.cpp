#include "rays/packets/bsp_reference.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumb {
namespace {

using Point = std::array<double, 3>;

// A triangle cut by six planes has at most nine corners; where rounding has bent it, a cut may
// make half as many again of any number: 3, 4, 6, 9, 13, 19, 28.
struct Polygon {
    std::array<Point, 28> points;
    int count;
};

// Keeps what lies on `side` of the plane; points on the plane stay.
void Clip(Polygon& polygon, std::size_t axis, double plane, int side) {
    Polygon kept;
    kept.count = 0;
    const double sign = side == 0 ? 1 : -1;
    for (int i = 0; i < polygon.count; ++i) {
        const Point& a = polygon.points[i];
        const Point& b = polygon.points[i + 1 == polygon.count ? 0 : i + 1];
        const double inside_a = sign * (plane - a[axis]), inside_b = sign * (plane - b[axis]);
        if (inside_a >= 0) kept.points[kept.count++] = a;
        if ((inside_a > 0 && inside_b < 0) || (inside_a < 0 && inside_b > 0)) {
            const double along = inside_a / (inside_a - inside_b);
            Point& crossing = kept.points[kept.count++];
            for (std::size_t k = 0; k < 3; ++k) crossing[k] = a[k] + along * (b[k] - a[k]);
            crossing[axis] = plane;
        }
    }
    polygon.count = kept.count;
    std::copy_n(kept.points.begin(), kept.count, polygon.points.begin());
}

float RoundedDown(double x) {
    const float f = float(x);
    return double(f) <= x ? f : std::nextafter(f, -std::numeric_limits<float>::infinity());
}

float RoundedUp(double x) {
    const float f = float(x);
    return double(f) >= x ? f : std::nextafter(f, std::numeric_limits<float>::infinity());
}

}  // namespace

BspReference ReferenceTo(const Corners& corners_m, std::uint32_t triangle) {
    BspReference reference{.box = {corners_m[0], corners_m[0]}, .triangle = triangle};
    for (const std::array<float, 3>& corner : corners_m) {
        for (std::size_t k = 0; k < 3; ++k) {
            reference.box.low_m[k] = std::min(reference.box.low_m[k], corner[k]);
            reference.box.high_m[k] = std::max(reference.box.high_m[k], corner[k]);
        }
    }
    return reference;
}

bool Narrow(BspReference& reference, const Corners& corners_m, std::uint32_t axis,
            float split_m, int side) {
    BspBox& box = reference.box;
    (side == 0 ? box.high_m : box.low_m)[axis] = split_m;
    Polygon polygon;
    polygon.count = 3;
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t k = 0; k < 3; ++k) polygon.points[c][k] = double(corners_m[c][k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] =
            std::minmax({corners_m[0][k], corners_m[1][k], corners_m[2][k]});
        if (low < box.low_m[k]) Clip(polygon, k, double(box.low_m[k]), 1);
        if (high > box.high_m[k]) Clip(polygon, k, double(box.high_m[k]), 0);
    }
    if (polygon.count == 0) return false;
    for (std::size_t k = 0; k < 3; ++k) {
        double low = polygon.points[0][k], high = low;
        for (int i = 1; i < polygon.count; ++i) {
            low = std::min(low, polygon.points[i][k]);
            high = std::max(high, polygon.points[i][k]);
        }
        box.low_m[k] = std::max(box.low_m[k], RoundedDown(low));
        box.high_m[k] = std::min(box.high_m[k], RoundedUp(high));
    }
    return true;
}

}  // namespace plumb
