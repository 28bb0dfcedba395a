#include "scenes/simple.h"

#include <cmath>

#include "scenes/builder.h"

namespace plumb {
namespace {

constexpr Rgb kGrey{0.6f, 0.6f, 0.6f};
constexpr Rgb kWhite{0.75f, 0.75f, 0.75f};

void Ground(SceneBuilder& build) {
    build.Use("ground", kGrey);
    build.Rectangle({-10, -10, 0}, {20, 0, 0}, {0, 20, 0}, 20, 20);
}

// A block on the floor, turned about the vertical, from its four footprint corners.
void Block(SceneBuilder& build, const Vec3& centre, double half_m, double height_m,
           double turn_rad) {
    const Vec3 a(half_m * std::cos(turn_rad), half_m * std::sin(turn_rad), 0);
    const Vec3 b(-a.y(), a.x(), 0), up(0, 0, height_m);
    const Vec3 corners[] = {centre - a - b, centre + a - b, centre + a + b, centre - a + b};
    for (int k = 0; k < 4; ++k) {
        const Vec3 side = corners[(k + 1) % 4] - corners[k];
        build.Rectangle(corners[k], side, up);
    }
    build.Rectangle(corners[0] + up, 2 * a, 2 * b);
}

}  // namespace

Scene BoxOnPlane() {
    SceneBuilder build("box_on_plane");
    Ground(build);
    build.Use("box", kWhite);
    build.Box({-0.5, -0.5, 0}, {0.5, 0.5, 1});
    build.AddCamera("main", {1.8, -2.6, 1.7}, {0, 0, 0.4}, 45);
    return build.Finish();
}

Scene BallOverPlane() {
    SceneBuilder build("ball_over_plane");
    Ground(build);
    build.Use("ball", kWhite);
    build.Ball({0, 0, 1}, 0.8, 96);
    build.AddCamera("main", {0, -4, 1.5}, {0, 0, 0.6}, 45);
    return build.Finish();
}

Scene CornellBox() {
    SceneBuilder build("cornell_box");
    build.Use("white", kWhite);
    build.Rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    build.Rectangle({0, 0, 1}, {0, 1, 0}, {1, 0, 0});
    build.Rectangle({0, 1, 0}, {1, 0, 0}, {0, 0, 1});
    Block(build, {0.33, 0.66, 0}, 0.15, 0.6, 0.3);
    Block(build, {0.68, 0.31, 0}, 0.15, 0.3, -0.3);
    build.Use("red", {0.63f, 0.06f, 0.04f});
    build.Rectangle({0, 0, 0}, {0, 1, 0}, {0, 0, 1});
    build.Use("green", {0.14f, 0.45f, 0.09f});
    build.Rectangle({1, 0, 0}, {0, 0, 1}, {0, 1, 0});
    build.AddCamera("main", {0.5, -1.4, 0.5}, {0.5, 0.5, 0.5}, 40);
    return build.Finish();
}

Scene Wedge() {
    SceneBuilder build("wedge");
    build.Use("grey", kGrey);
    build.Rectangle({0, -20, 0}, {40, 0, 0}, {0, 40, 0}, 40, 40);
    build.Rectangle({0, -20, 0}, {0, 40, 0}, {0, 0, 40}, 40, 40);
    build.AddCamera("main", {3, -4, 2}, {0.5, 0, 0.5}, 45);
    return build.Finish();
}

Scene TrenchScene() {
    SceneBuilder build("trench");
    build.Use("grey", kGrey);
    build.Rectangle({0, -20, -1}, {1, 0, 0}, {0, 40, 0}, 2, 40);
    build.Rectangle({0, -20, -1}, {0, 40, 0}, {0, 0, 1}, 40, 2);
    build.Rectangle({1, -20, -1}, {0, 0, 1}, {0, 40, 0}, 2, 40);
    build.Rectangle({-10, -20, 0}, {10, 0, 0}, {0, 40, 0}, 10, 40);
    build.Rectangle({1, -20, 0}, {10, 0, 0}, {0, 40, 0}, 10, 40);
    build.AddCamera("main", {0.5, -2, 1.2}, {0.5, 0.5, -0.8}, 50);
    return build.Finish();
}

}  // namespace plumb
