// Triangles placed by their picture coordinates, for tests of the rasterizer.
#pragma once

#include "core/scene.h"
#include "screen_space/raster/raster_options.h"

namespace plumb {

/// A camera at the origin that looks along +y with x to the right and z up, and whose pixels
/// are 1/64 wide at the distance 1: coordinates up to 2^17 px in steps of 1/64 are floats.
inline Camera PixelCamera(int width_px, int height_px) {
    return {.position_m = {0, 0, 0},
            .target_m = {0, 1, 0},
            .up = {0, 0, 1},
            .fov_rad = 2 * std::atan(height_px / 128.0),
            .width_px = width_px,
            .height_px = height_px};
}

/// The point that PixelCamera sees at (x_px, y_px), `t_m` away from its plane.
inline Vec3f AtPixel(const Camera& camera, double x_px, double y_px, double t_m = 1) {
    return Vec3(t_m * (x_px - 0.5 * camera.width_px) / 64, t_m,
                t_m * (0.5 * camera.height_px - y_px) / 64)
        .cast<float>();
}

inline Mesh OneTriangle(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    Mesh mesh;
    mesh.vertices_m = {a, b, c};
    mesh.quads = {{0, 1, 2, 2}};
    return mesh;
}

inline Scene GreyScene(Mesh mesh) {
    Scene scene;
    scene.material_of_face.assign(mesh.quads.size(), 0);
    scene.mesh = std::move(mesh);
    scene.materials = {{.name = "grey"}};
    return scene;
}

}  // namespace plumb
