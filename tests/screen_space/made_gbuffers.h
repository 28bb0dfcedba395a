// G-buffers made by ray and shape, each pixel's centre on its own, in double: what a rasterizer
// would draw of a plane, a floor and wall, a trench, a sphere, without a rasterizer.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "core/conventions.h"
#include "screen_space/gbuffer.h"

namespace plumb {

struct MadeHit {
    double depth = std::numeric_limits<double>::infinity();  ///< -z of the point met (m).
    Vec3 normal{0, 0, 0};                                    ///< Unit, towards the eye.
};

/// What the ray from the eye through `direction` = (x, y, -1) meets first.
using MadeShape = std::function<MadeHit(const Vec3& direction)>;

/// The plane n.P = d of the camera's frame, cut to where `keep` holds.
inline MadeShape MadePlane(const Vec3& normal, double d,
                           std::function<bool(const Vec3&)> keep = nullptr) {
    return [n = normal.normalized(), d, keep](const Vec3& w) {
        MadeHit hit;
        const double t = d / n.dot(w);
        if (!(t > 0) || !std::isfinite(t) || (keep && !keep(t * w))) return hit;
        hit.depth = t;
        hit.normal = n.dot(w) < 0 ? n : Vec3(-n);
        return hit;
    };
}

inline MadeShape MadeSphere(const Vec3& centre, double radius) {
    return [centre, radius](const Vec3& w) {
        MadeHit hit;
        const double a = w.squaredNorm(), b = w.dot(centre);
        const double under = b * b - a * (centre.squaredNorm() - radius * radius);
        if (under < 0) return hit;
        const double t = (b - std::sqrt(under)) / a;
        if (t <= 0) return hit;
        hit.depth = t;
        hit.normal = (t * w - centre) / radius;
        return hit;
    };
}

/// The nearer of the two.
inline MadeShape Union(const MadeShape& a, const MadeShape& b) {
    return [a, b](const Vec3& w) {
        const MadeHit hit_a = a(w), hit_b = b(w);
        return hit_a.depth <= hit_b.depth ? hit_a : hit_b;
    };
}

/// A floor y = -1 and a wall z = -5 behind it.
inline MadeShape MadeFloorAndWall() {
    return Union(MadePlane({0, 1, 0}, -1), MadePlane({0, 0, 1}, -5));
}

/// Looking down into a trench of half-width 0.5 m and depth 1 m: its rim is at z = -4.
inline MadeShape MadeTrench() {
    const auto on_rim = [](const Vec3& P) { return std::abs(P.x()) >= 0.5; };
    const auto below_rim = [](const Vec3& P) { return P.z() <= -4 && P.z() >= -5; };
    const auto between = [](const Vec3& P) { return std::abs(P.x()) <= 0.5; };
    return Union(
        Union(MadePlane({0, 0, 1}, -4, on_rim), MadePlane({0, 0, 1}, -5, between)),
        Union(MadePlane({1, 0, 0}, -0.5, below_rim), MadePlane({1, 0, 0}, 0.5, below_rim)));
}

/// A sphere of 0.5 m, 0.1 m above a floor y = -1, far in front of a wall.
inline MadeShape MadeSphereOverPlane() {
    return Union(Union(MadePlane({0, 1, 0}, -1), MadePlane({0, 0, 1}, -8)),
                 MadeSphere({0, -0.4, -4.5}, 0.5));
}

/// A view of `width` x `height` square pixels, tan of half its height `tan`.
inline View MadeView(int width, int height, double tan = 0.5, int guard = 0) {
    return {.width_px = width,
            .height_px = height,
            .guard_px = guard,
            .tan_half_width = tan * width / height,
            .tan_half_height = tan};
}

inline GBuffer MadeGBuffer(const View& view, const MadeShape& shape) {
    const int W = view.DrawnWidth(), H = view.DrawnHeight();
    GBuffer g;
    g.view = view;
    g.z_m = Image<float>(W, H, GBuffer::kSkyZ);
    g.triangle = Image<std::uint32_t>(W, H, GBuffer::kSky);
    g.face_normal = Image<Vec3f>(W, H, Vec3f(0, 0, 0));
    g.shading_normal = g.face_normal;
    g.albedo = Image<Rgb>(W, H, Rgb{0, 0, 0});
    for (int y = 0; y < H; ++y) {
        for (int x = 0; x < W; ++x) {
            const MadeHit hit = shape(view.Point(x + 0.5, y + 0.5, -1));
            if (!std::isfinite(hit.depth)) continue;
            g.z_m(x, y) = float(-hit.depth);
            g.triangle(x, y) = 0;
            g.face_normal(x, y) = g.shading_normal(x, y) = hit.normal.cast<float>();
            g.albedo(x, y) = {1, 1, 1};
        }
    }
    return g;
}

}  // namespace plumb
