#include "truth/leave_surface.h"

#include <algorithm>

namespace plumb {

Ray LeaveSurface(const Triangle& triangle, const Vec3& point_m, const Vec3& n) {
    double extent_m = 0;
    for (const Vec3& corner_m : triangle.corners_m) {
        extent_m = std::max(extent_m, (corner_m - point_m).cwiseAbs().maxCoeff());
    }
    const double h = 0x1p-23 * (32 * point_m.cwiseAbs().maxCoeff() + 4 * extent_m);
    Ray ray;
    ray.origin_m = (point_m + h * n).cast<float>();
    ray.near = float(h);
    return ray;
}

}  // namespace plumb
