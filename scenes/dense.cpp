#include "scenes/dense.h"

#include <cmath>

#include "core/conventions.h"
#include "core/error.h"
#include "core/random.h"
#include "scenes/builder.h"

namespace plumb {
namespace {

void Check(const char* thing, int value) {
    if (value < 1 || value > 100'000'000) throw Error(MustBe(thing, value, "in [1, 1e8]"));
}

}  // namespace

Scene Fence(int bars) {
    Check("fence: bars", bars);
    constexpr double kPitch = 0.06, kThick = 0.004;
    SceneBuilder build("fence");
    build.Use("ground", {0.5f, 0.5f, 0.5f});
    build.Rectangle({-10, -10, 0}, {20, 0, 0}, {0, 20, 0}, 20, 20);
    build.Use("bars", {0.7f, 0.7f, 0.7f});
    const double first = -0.5 * kPitch * (bars - 1);
    for (int i = 0; i < bars; ++i) {
        const double x = first + kPitch * i;
        build.Box({x - kThick / 2, -kThick / 2, 0}, {x + kThick / 2, kThick / 2, 1});
    }
    for (const double z : {0.2, 0.85}) {
        build.Box({first, -kThick, z}, {first + kPitch * (bars - 1), -kThick / 2, z + 0.03});
    }
    build.AddCamera("main", {1.5, -3, 1.2}, {0, 0, 0.5}, 45);
    return build.Finish();
}

Scene Slivers(int count) {
    Check("slivers: count", count);
    SceneBuilder build("slivers");
    build.Use("plate", {0.6f, 0.6f, 0.6f});
    build.Sheet(1, (count + 1) / 2, [](double u, double v) {
        return Vec3(2 * u - 1, 2 * v - 1,
                    0.05 * std::sin(40 * v) + 0.02 * u * std::sin(90 * v));
    });
    build.AddCamera("main", {0.8, -1.8, 1.2}, {0, 0, 0}, 45);
    return build.Finish();
}

Scene Forest(int triangles, std::uint64_t seed) {
    Check("forest: triangles", triangles);
    SceneBuilder build("forest");
    build.Use("ground", {0.3f, 0.25f, 0.2f});
    build.Rectangle({-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, 10, 10);
    build.Use("leaves", {0.3f, 0.5f, 0.2f});
    for (int i = 0; i < triangles; ++i) {
        const auto random = [&](int k) { return RandomUnit(seed, i, 0, k); };
        const Vec3 foot(10 * random(0) - 5, 10 * random(1) - 5, 0.4 * random(2));
        const double size = 0.03 + 0.03 * random(3), phi = 2 * kPi * random(4);
        const Vec3 across(size * std::cos(phi), size * std::sin(phi), 0);
        const Vec3 top = size * Vec3(random(5) - 0.5, random(6) - 0.5, 1);
        build.Triangle(foot - across / 2, foot + across / 2, foot + top);
    }
    build.AddCamera("main", {3, -6, 2.5}, {0, 0, 0.2}, 45);
    return build.Finish();
}

}  // namespace plumb
