// Meshes and rays that strain a ray caster.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/conventions.h"
#include "core/mesh.h"
#include "core/random.h"
#include "rays/ray_caster.h"

namespace plumb {

inline Vec3 RandomPoint(std::uint64_t seed, std::uint64_t i, std::uint64_t k) {
    return {RandomUnit(seed, i, k, 0), RandomUnit(seed, i, k, 1), RandomUnit(seed, i, k, 2)};
}

inline void AddFace(Mesh& mesh, const std::vector<Vec3>& corners) {
    const std::uint32_t first = std::uint32_t(mesh.vertices_m.size());
    for (const Vec3& p : corners) mesh.vertices_m.push_back(p.cast<float>());
    mesh.quads.push_back(
        {first, first + 1, first + 2, corners.size() == 4 ? first + 3 : first + 2});
}

/// Triangles, and quads that are not flat, of about `size` in the unit cube.
inline Mesh Soup(int faces, double size) {
    Mesh mesh;
    for (int f = 0; f < faces; ++f) {
        const Vec3 at = RandomPoint(1, std::uint64_t(f), 0);
        std::vector<Vec3> corners;
        for (int k = 0; k < (f % 3 == 0 ? 3 : 4); ++k) {
            corners.push_back(at +
                              size * RandomPoint(1, std::uint64_t(f), std::uint64_t(k + 1)));
        }
        AddFace(mesh, corners);
    }
    return mesh;
}

/// n x n cells of the unit square, z = f(x, y); vertices are shared.
template <class F>
Mesh Sheet(int n, const F& f) {
    Mesh mesh;
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            const double x = double(i) / n, y = double(j) / n;
            mesh.vertices_m.push_back(Vec3(x, y, f(x, y)).cast<float>());
        }
    }
    const std::uint32_t row = std::uint32_t(n) + 1;
    for (std::uint32_t j = 0; j + 1 < row; ++j) {
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t a = j * row + i;
            mesh.quads.push_back({a, a + 1, a + row + 1, a + row});
        }
    }
    return mesh;
}

inline Mesh Hills(int n) {
    return Sheet(n, [](double x, double y) {
        return 0.1 * std::sin(9 * x + 2 * y) + 0.05 * std::sin(31 * y - 7 * x);
    });
}

/// A closed ball about the origin, of triangles `segments` times as high as wide.
inline Mesh SliverBall(int rings, int segments) {
    Mesh mesh;
    for (int r = 0; r <= rings; ++r) {
        for (int s = 0; s < segments; ++s) {
            const double theta = kPi * r / rings, phi = 2 * kPi * s / segments;
            // One point for all at the poles: sin(pi) is not 0 in double.
            const double rim = r == 0 || r == rings ? 0 : std::sin(theta);
            mesh.vertices_m.push_back(
                Vec3(rim * std::cos(phi), rim * std::sin(phi), std::cos(theta)).cast<float>());
        }
    }
    const std::uint32_t n = std::uint32_t(segments);
    for (std::uint32_t r = 0; r < std::uint32_t(rings); ++r) {
        for (std::uint32_t s = 0; s < n; ++s) {
            const std::uint32_t next = (s + 1) % n, row = r * n;
            mesh.quads.push_back({row + s, row + n + s, row + n + next, row + next});
        }
    }
    return mesh;
}

/// Thin upright walls, some of them twice at the same place, over a floor cut into strips.
inline Mesh FenceAndFloor() {
    Mesh mesh;
    for (int i = 0; i < 60; ++i) {
        const double x = i / 60.0, wide = 1e-4;
        AddFace(mesh, {{x, 0.4, 0}, {x + wide, 0.4, 0}, {x + wide, 0.4, 1}, {x, 0.4, 1}});
        AddFace(mesh, {{x, 0.4, 0}, {x, 0.6, 0}, {x, 0.6, 1}, {x, 0.4, 1}});
        if (i % 3 == 0) mesh.quads.push_back(mesh.quads.back());
        AddFace(mesh, {{x, 0, 0}, {x + 1 / 60.0, 0, 0}, {x + 1 / 60.0, 1, 0}, {x, 1, 0}});
    }
    return mesh;
}

inline Mesh Moved(Mesh mesh, double by_m) {
    for (Vec3f& p : mesh.vertices_m) {
        p = (p.cast<double>() + by_m * Vec3(1, -0.7, 0.4)).cast<float>();
    }
    return mesh;
}

/// From within and around the box of `mesh`: at random points of faces, at their edges and
/// corners, and anywhere; some parallel to an axis, some short.
inline std::vector<Ray> RaysAt(const Mesh& mesh, int count, std::uint64_t seed) {
    Vec3 low = Vec3::Constant(1e30), high = -low;
    for (const Vec3f& p : mesh.vertices_m) {
        low = low.cwiseMin(p.cast<double>());
        high = high.cwiseMax(p.cast<double>());
    }
    const Vec3 thick = Vec3::Constant(0.2 * (high - low).maxCoeff());
    low -= thick;
    high += thick;
    std::vector<Ray> rays;
    for (std::uint64_t i = 0; i < std::uint64_t(count); ++i) {
        // Groups of 64 start near one another and go the same way, as pixels do.
        const std::uint64_t group = i / 64;
        const bool together = group % 2 == 0;
        const Vec3 spread =
            together ? Vec3(RandomPoint(seed, group, 1) + 0.01 * RandomPoint(seed, i, 1))
                     : RandomPoint(seed, i, 1);
        const Vec3 origin = low + spread.cwiseProduct(high - low);
        const std::uint64_t face_bits = RandomBits(seed, together ? group : i, 2, 0);
        const std::array<std::uint32_t, 4>& face = mesh.quads[face_bits % mesh.quads.size()];
        const Vec3 p = mesh.vertices_m[face[0]].cast<double>();
        const Vec3 q = mesh.vertices_m[face[1]].cast<double>();
        const Vec3 r = mesh.vertices_m[face[3]].cast<double>();
        const double u = RandomUnit(seed, i, 3, 0), v = RandomUnit(seed, i, 3, 1);
        const Vec3 target = i % 5 == 0   ? p
                            : i % 5 == 1 ? Vec3(p + u * (q - p))
                            : i % 5 == 2 ? Vec3(q + u * (r - q))
                                         : Vec3(p + u * (q - p) + v * (r - p));
        Ray ray;
        ray.origin_m = origin.cast<float>();
        ray.direction = (target - ray.origin_m.cast<double>()).cast<float>();
        if (i % 11 == 3) {
            // Along an axis through a vertex's own coordinates: in a plane of splits.
            const int axis = int(i / 11 % 3);
            ray.direction = Vec3f::Zero();
            ray.direction[axis] = i % 2 == 0 ? 2.0f : -0.5f;
            const float keep = ray.origin_m[axis];
            ray.origin_m = p.cast<float>();
            ray.origin_m[axis] = keep;
        }
        if (i % 7 == 0) ray.far = 0.9f;
        if (i % 13 == 0) ray.near = 0.05f;
        rays.push_back(ray);
    }
    return rays;
}

}  // namespace plumb
