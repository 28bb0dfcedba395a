// Small scenes for the jobs on scenes: a few faces, one camera.
#pragma once

#include <array>

#include "core/scene.h"

namespace plumb {

inline void AddFace(Scene& scene, const std::array<Vec3f, 4>& corners_m) {
    const auto first = std::uint32_t(scene.mesh.vertices_m.size());
    for (const Vec3f& corner : corners_m) scene.mesh.vertices_m.push_back(corner);
    scene.mesh.quads.push_back({first, first + 1, first + 2, first + 3});
    scene.material_of_face.push_back(0);
}

/// A floor of 8 m x 8 m, and at y = 1.5 a wall 0.8 m high and 6 m wide; sky above.
inline Scene FloorAndWall(int width_px, int height_px) {
    Scene scene;
    scene.name = "floor and wall";
    scene.materials.push_back({});
    AddFace(scene, {Vec3f(-4, -4, 0), Vec3f(4, -4, 0), Vec3f(4, 4, 0), Vec3f(-4, 4, 0)});
    AddFace(scene, {Vec3f(-3, 1.5F, 0), Vec3f(3, 1.5F, 0), Vec3f(3, 1.5F, 0.8F),
                    Vec3f(-3, 1.5F, 0.8F)});
    scene.cameras.push_back({.name = "front",
                             .position_m = {0.3, -3, 1.6},
                             .target_m = {0, 1.5, 0.5},
                             .up = {0, 0, 1},
                             .fov_rad = 0.9,
                             .width_px = width_px,
                             .height_px = height_px});
    return scene;
}

/// A post on a floor, and halfway to the eye a screen that hides all of the post but none of the
/// floor beside it.
inline Scene FloorWithHiddenPost(int width_px, int height_px) {
    Scene scene;
    scene.name = "hidden post";
    scene.materials.push_back({});
    AddFace(scene, {Vec3f(-4, -4, 0), Vec3f(4, -4, 0), Vec3f(4, 4, 0), Vec3f(-4, 4, 0)});
    AddFace(scene, {Vec3f(-0.3F, 0.4F, 0), Vec3f(0.3F, 0.4F, 0), Vec3f(0.3F, 0.4F, 0.6F),
                    Vec3f(-0.3F, 0.4F, 0.6F)});
    // 1.5 / 3.4 of the way: 0.132 m to each side, 0.782 to 1.047 m high, and a little more.
    AddFace(scene, {Vec3f(-0.14F, -1.5F, 0.775F), Vec3f(0.14F, -1.5F, 0.775F),
                    Vec3f(0.14F, -1.5F, 1.06F), Vec3f(-0.14F, -1.5F, 1.06F)});
    scene.cameras.push_back({.name = "front",
                             .position_m = {0, -3, 1.4},
                             .target_m = {0, 0.4, 0.2},
                             .up = {0, 0, 1},
                             .fov_rad = 0.6,
                             .width_px = width_px,
                             .height_px = height_px});
    return scene;
}

}  // namespace plumb
