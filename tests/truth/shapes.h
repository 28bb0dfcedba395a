// Meshes that tests are made of.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/conventions.h"
#include "core/mesh.h"

namespace plumb {

/// Adds one quad with corners of its own, counter-clockwise seen from its front.
inline void AddQuad(Mesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const std::uint32_t first = std::uint32_t(mesh.vertices_m.size());
    for (const Vec3& p : {a, b, c, d}) mesh.vertices_m.push_back(p.cast<float>());
    mesh.quads.push_back({first, first + 1, first + 2, first + 3});
}

inline void AddTriangle(Mesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c) {
    const std::uint32_t first = std::uint32_t(mesh.vertices_m.size());
    for (const Vec3& p : {a, b, c}) mesh.vertices_m.push_back(p.cast<float>());
    mesh.quads.push_back({first, first + 1, first + 2, first + 2});
}

/// Adds the sheet of points f(u, v), its front on the side of df/du x df/dv. Returns the number
/// of its first face; the face from us[i], vs[j] is i + j (us.size() - 1) further.
template <class F>
std::uint32_t AddSheet(Mesh& mesh, const std::vector<double>& us, const std::vector<double>& vs,
                       const F& f) {
    const std::uint32_t first = std::uint32_t(mesh.vertices_m.size());
    const std::uint32_t first_face = std::uint32_t(mesh.quads.size());
    const std::uint32_t columns = std::uint32_t(us.size());
    for (const double v : vs) {
        for (const double u : us)
            mesh.vertices_m.push_back(Vec3(f(u, v)).template cast<float>());
    }
    for (std::uint32_t j = 0; j + 1 < vs.size(); ++j) {
        for (std::uint32_t i = 0; i + 1 < columns; ++i) {
            const std::uint32_t a = first + j * columns + i;
            mesh.quads.push_back({a, a + 1, a + columns + 1, a + columns});
        }
    }
    return first_face;
}

/// n + 1 even steps from a to b.
inline std::vector<double> Steps(double a, double b, int n) {
    std::vector<double> out;
    for (int i = 0; i <= n; ++i) out.push_back(a + (b - a) * i / n);
    return out;
}

/// Steps that grow by `ratio` from `first` to past `reach` on both sides of 0; 0 is among them.
inline std::vector<double> GrowingSteps(double first, double reach, double ratio) {
    std::vector<double> out{0};
    for (double x = first;; x *= ratio) {
        out.insert(out.begin(), -x);
        out.push_back(x);
        if (x > reach) return out;
    }
}

/// The upper half of the same.
inline std::vector<double> GrowingStepsUp(double first, double reach, double ratio) {
    std::vector<double> out = GrowingSteps(first, reach, ratio);
    return {out.begin() + std::ptrdiff_t(out.size() / 2), out.end()};
}

/// A sphere of 2 `rings` segments whose front is its outside.
inline void AddSphere(Mesh& mesh, const Vec3& centre, double radius, int rings) {
    AddSheet(mesh, Steps(0, 2 * kPi, 2 * rings), Steps(-kPi / 2, kPi / 2, rings),
             [&](double phi, double latitude) -> Vec3 {
                 return centre + radius * Vec3(std::cos(latitude) * std::cos(phi),
                                               std::cos(latitude) * std::sin(phi),
                                               std::sin(latitude));
             });
}

/// The same faces seen from their other side.
inline void TurnInsideOut(Mesh& mesh) {
    for (std::array<std::uint32_t, 4>& q : mesh.quads) {
        const bool is_triangle = q[2] == q[3];
        std::swap(q[0], q[2]);
        if (is_triangle) q = {q[0], q[1], q[2], q[2]};
    }
}

}  // namespace plumb
