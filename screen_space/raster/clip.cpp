#include "screen_space/raster/clip.h"

#include <algorithm>

namespace plumb {
namespace {

// { P : n . P >= c }.
struct HalfSpace {
    Vec3 n;
    double c = 0;

    double Inside(const Vec3& P) const { return n.dot(P) - c; }
};

ClippedPolygon Clip(const ClippedPolygon& polygon, const HalfSpace& half) {
    ClippedPolygon out;
    for (int k = 0; k < polygon.size; ++k) {
        const Vec3& P = polygon.corners[std::size_t(k)];
        const Vec3& Q = polygon.corners[std::size_t((k + 1) % polygon.size)];
        const double p = half.Inside(P), q = half.Inside(Q);
        if (p >= 0) out.corners[std::size_t(out.size++)] = P;
        if ((p >= 0) == (q >= 0)) continue;
        out.corners[std::size_t(out.size++)] =
            p >= 0 ? Vec3(P + p / (p - q) * (Q - P)) : Vec3(Q + q / (q - p) * (P - Q));
    }
    return out;
}

}  // namespace

ClippedPolygon ClipTriangle(const std::array<Vec3, 3>& corners, const PictureMap& map,
                            double near_m) {
    // x_px >= -reach as (k_x x + c_x t) + reach t >= 0 with t = -z, and so on.
    const double reach = kReachPx;
    const std::array<HalfSpace, 5> planes{
        HalfSpace{{0, 0, -1}, near_m}, HalfSpace{{map.k_x, 0, -(map.c_x + reach)}},
        HalfSpace{{-map.k_x, 0, -(map.width_px - map.c_x + reach)}},
        HalfSpace{{0, -map.k_y, -(map.c_y + reach)}},
        HalfSpace{{0, map.k_y, -(map.height_px - map.c_y + reach)}}};
    ClippedPolygon polygon;
    for (const Vec3& P : corners) polygon.corners[std::size_t(polygon.size++)] = P;
    for (const HalfSpace& plane : planes) {
        polygon = Clip(polygon, plane);
        if (polygon.size < 3) return {};
    }
    // Rounding may leave a corner a hair before the near plane.
    for (int k = 0; k < polygon.size; ++k) {
        double& z = polygon.corners[std::size_t(k)].z();
        z = std::min(z, -near_m);
    }
    return polygon;
}

}  // namespace plumb
