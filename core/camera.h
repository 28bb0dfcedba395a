// A pinhole camera: which ray belongs to which pixel.
//
//       w(i, j) = forward + x tan(fov/2) (W/H) right + y tan(fov/2) up
//       x = 2 (i + 1/2) / W - 1,    y = 1 - 2 (j + 1/2) / H
//
// Pixel (i, j) is column i of row j, row 0 at the top. w is not a unit vector: its part along
// `forward` is 1, so that t along a ray is the depth, the distance from the camera's plane.
#pragma once

#include <cmath>
#include <string>

#include "core/vec.h"

namespace plumb {

struct Camera {
    std::string name = "camera";
    Vec3 position_m{0, -3, 1};
    Vec3 target_m{0, 0, 0};  ///< In the middle of the picture; not the position.
    Vec3 up{0, 0, 1};        ///< Points up in the picture; not along the line of sight.
    double fov_rad = 1;      ///< Of the picture's height. (0, pi)
    int width_px = 960;      ///< [1, 65536]
    int height_px = 540;     ///< [1, 65536]
};

/// Throws Error, naming field, value and rule; `name` is what the message calls the camera.
void Validate(const Camera& camera, const std::string& name = "camera");

/// The camera's own axes: right-handed, looking along -backward.
struct CameraFrame {
    Vec3 right, up, backward;
    double tan_half_width = 1, tan_half_height = 1;

    explicit CameraFrame(const Camera& camera) : tan_half_height(std::tan(camera.fov_rad / 2)) {
        backward = (camera.position_m - camera.target_m).normalized();
        right = camera.up.cross(backward).normalized();
        this->up = backward.cross(right);
        tan_half_width = tan_half_height * camera.width_px / camera.height_px;
    }

    /// w at the point (x_px, y_px) of the picture; pixel centres are at whole numbers + 1/2.
    Vec3 Direction(const Camera& camera, double x_px, double y_px) const {
        const double x = 2 * x_px / camera.width_px - 1, y = 1 - 2 * y_px / camera.height_px;
        return x * tan_half_width * right + y * tan_half_height * up - backward;
    }
};

}  // namespace plumb
