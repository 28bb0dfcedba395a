// The camera of a G-buffer: where pixels and depths are in the camera's frame.
//
//       P(x, y, z) = -z ( x_s tan_half_width, y_s tan_half_height, -1 )
//       x_s = 2 (x - guard) / width - 1,    y_s = 1 - 2 (y - guard) / height
//
// The camera's frame is right-handed, x to the right, y up, looking along -z: what is seen has
// z < 0. A picture may have a border that is drawn but not shown, so that taps just outside
// find geometry: the guard band of [McGuire12].
//
// Symbols  (x, y) a point of the drawn picture in pixels, its border included; pixel centres at
//          whole numbers + 1/2, row 0 at the top.
#pragma once

#include "core/vec.h"

namespace plumb {

struct View {
    int width_px = 1, height_px = 1;  ///< Of the picture shown. [1, 16384] with its border
    int guard_px = 0;                 ///< Border on each side. >= 0
    double tan_half_width = 1, tan_half_height = 1;  ///< Of the picture shown. > 0

    int DrawnWidth() const { return width_px + 2 * guard_px; }
    int DrawnHeight() const { return height_px + 2 * guard_px; }

    /// Pixels that 1 m, parallel to the picture, covers at a distance of 1 m.
    double PixelsPerMetre() const { return height_px / (2 * tan_half_height); }

    Vec3 Point(double x_px, double y_px, double z_m) const {
        const double x_s = 2 * (x_px - guard_px) / width_px - 1;
        const double y_s = 1 - 2 * (y_px - guard_px) / height_px;
        return {-z_m * x_s * tan_half_width, -z_m * y_s * tan_half_height, z_m};
    }

    /// The pixel coordinates of a point with z < 0.
    Vec2 Project(const Vec3& P) const {
        const double x_s = P.x() / (-P.z() * tan_half_width);
        const double y_s = P.y() / (-P.z() * tan_half_height);
        return {(x_s + 1) / 2 * width_px + guard_px, (1 - y_s) / 2 * height_px + guard_px};
    }
};

}  // namespace plumb
