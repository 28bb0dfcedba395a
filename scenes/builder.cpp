#include "scenes/builder.h"

#include <cassert>
#include <cmath>
#include <utility>

#include "core/conventions.h"

namespace plumb {

void SceneBuilder::Use(const std::string& name, const Rgb& albedo) {
    scene_.materials.push_back({.name = name, .albedo = albedo});
}

std::uint32_t SceneBuilder::AddVertex(const Vec3& p) {
    scene_.mesh.vertices_m.push_back(p.cast<float>());
    return std::uint32_t(scene_.mesh.vertices_m.size() - 1);
}

void SceneBuilder::AddFace(const std::array<std::uint32_t, 4>& face) {
    assert(!scene_.materials.empty());
    scene_.mesh.quads.push_back(face);
    scene_.material_of_face.push_back(std::uint16_t(scene_.materials.size() - 1));
}

void SceneBuilder::Quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const std::uint32_t first = AddVertex(a);
    AddVertex(b);
    AddVertex(c);
    AddVertex(d);
    AddFace({first, first + 1, first + 2, first + 3});
}

void SceneBuilder::Triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const std::uint32_t first = AddVertex(a);
    AddVertex(b);
    AddVertex(c);
    AddFace({first, first + 1, first + 2, first + 2});
}

void SceneBuilder::Sheet(int n, int m, const std::function<Vec3(double u, double v)>& f) {
    assert(n > 0 && m > 0);
    const std::uint32_t first = std::uint32_t(scene_.mesh.vertices_m.size());
    const std::uint32_t columns = std::uint32_t(n) + 1;
    for (int j = 0; j <= m; ++j) {
        for (int i = 0; i <= n; ++i) AddVertex(f(double(i) / n, double(j) / m));
    }
    for (std::uint32_t j = 0; j < std::uint32_t(m); ++j) {
        for (std::uint32_t i = 0; i < std::uint32_t(n); ++i) {
            const std::uint32_t a = first + j * columns + i;
            AddFace({a, a + 1, a + columns + 1, a + columns});
        }
    }
}

void SceneBuilder::Rectangle(const Vec3& corner, const Vec3& u, const Vec3& v, int n, int m) {
    Sheet(n, m, [&](double s, double t) -> Vec3 { return corner + s * u + t * v; });
}

void SceneBuilder::Box(const Vec3& low, const Vec3& high) {
    const Vec3 x(high.x() - low.x(), 0, 0), y(0, high.y() - low.y(), 0),
        z(0, 0, high.z() - low.z());
    Rectangle(low, y, x);
    Rectangle(low + z, x, y);
    Rectangle(low, x, z);
    Rectangle(low + y, z, x);
    Rectangle(low, z, y);
    Rectangle(low + x, y, z);
}

void SceneBuilder::Revolve(const Vec3& foot, int segments, int rings,
                           const std::function<double(double v)>& radius,
                           const std::function<double(double v)>& height) {
    Sheet(segments, rings, [&](double u, double v) -> Vec3 {
        const double phi = 2 * kPi * u;
        return foot + Vec3(radius(v) * std::cos(phi), radius(v) * std::sin(phi), height(v));
    });
}

void SceneBuilder::Ball(const Vec3& centre, double radius_m, int rings) {
    Revolve(
        centre, 2 * rings, rings, [&](double v) { return radius_m * std::sin(kPi * v); },
        [&](double v) { return -radius_m * std::cos(kPi * v); });
}

void SceneBuilder::AddCamera(const std::string& name, const Vec3& position_m,
                             const Vec3& target_m, double fov_deg) {
    scene_.cameras.push_back({.name = name,
                              .position_m = position_m,
                              .target_m = target_m,
                              .fov_rad = fov_deg * kPi / 180});
}

Scene SceneBuilder::Finish() {
    Validate(scene_);
    return std::exchange(scene_, {});
}

}  // namespace plumb
