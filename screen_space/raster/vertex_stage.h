// The vertices of a mesh in the camera's frame and in the picture.
//
//       x_px = k_x x / t + c_x,    y_px = c_y - k_y y / t,    t = -z
//       k_x = width / (2 tan_half_width),   c_x = width / 2 + guard;   k_y, c_y alike
//
// Pictures coordinates are fixed-point with 8 bits after the point: a vertex is moved by at most
// 1/512 pixel in each direction, to the same place in every triangle that shares it.
//
// Symbols  (x, y, z) in the camera's frame (m).
#pragma once

#include <cstdint>
#include <vector>

#include "core/camera.h"
#include "core/mesh.h"
#include "screen_space/raster/raster_options.h"
#include "screen_space/view.h"

namespace plumb {

inline constexpr int kSubPixels = 256;  ///< Steps of the fixed point a pixel.

/// How far outside the picture fixed-point coordinates reach; what lies further is clipped.
inline constexpr int kReachPx = 8192;

/// The picture as the affine map of the header. Coordinates as in View, border included.
struct PictureMap {
    double k_x, k_y, c_x, c_y;
    int width_px, height_px;  ///< Drawn.

    explicit PictureMap(const View& view)
        : k_x(view.width_px / (2 * view.tan_half_width)),
          k_y(view.height_px / (2 * view.tan_half_height)),
          c_x(0.5 * view.width_px + view.guard_px),
          c_y(0.5 * view.height_px + view.guard_px),
          width_px(view.DrawnWidth()),
          height_px(view.DrawnHeight()) {}
};

struct FixedPoint {
    std::int32_t x = 0, y = 0;  ///< In 1/256 pixel.
};

/// Where a point with t > 0 within the reach is in the picture, rounded to nearest.
FixedPoint ToFixed(const PictureMap& map, const Vec3& P);

/// The same, moved to the border of the reach if rounding of huge coordinates left it beyond.
FixedPoint ToFixedWithinReach(const PictureMap& map, const Vec3& P);

/// Where a vertex lies, as bits that can be joined over a triangle.
namespace outcode {
inline constexpr std::uint32_t kLeft = 1, kRight = 2, kAbove = 4,
                               kBelow = 8;  ///< Of the picture.
inline constexpr std::uint32_t kBeforeNear = 16;
inline constexpr std::uint32_t kBeyondReach =
    32;  ///< Of fixed point, or before the near plane.
}  // namespace outcode

struct ScreenVertex {
    Vec3 P;         ///< In the camera's frame (m).
    FixedPoint at;  ///< Unless kBeyondReach.
    std::uint32_t outcode = 0;
};

/// One a vertex of the mesh, written over `out`. Throws Error if a vertex is not finite or
/// beyond 1e15 m. On the float path P is the point that the float results stand for.
void TransformVertices(const Mesh& mesh, const Camera& camera, const View& view,
                       const RasterOptions& options, std::vector<ScreenVertex>& out);

}  // namespace plumb
