#include "rays/leave_surface.h"

#include <algorithm>

namespace plumb {

Ray LeaveSurface(const Triangle& triangle, double b_1, double b_2, const Vec3& n,
                 double margin) {
    const auto& [p_0, p_1, p_2] = triangle.corners_m;
    const Vec3 point_m = triangle.PointM(b_1, b_2);
    double extent_m = 0;
    for (const Vec3& corner_m : triangle.corners_m) {
        extent_m = std::max(extent_m, (corner_m - point_m).cwiseAbs().maxCoeff());
    }
    const double h = 0x1p-23 * (2 * point_m.cwiseAbs().maxCoeff() + 3 * extent_m);

    // 1 / altitude_k = (length of the side across from corner k) / (2 area).
    const Vec3 across((p_2 - p_1).norm(), (p_0 - p_2).norm(), (p_1 - p_0).norm());
    const Vec3 m = margin * h / triangle.Cross().norm() * across;
    const double taken = m.sum();
    const double left = std::max(0.0, 1 - taken), part = taken > 1 ? 1 / taken : 1;

    Ray ray;
    ray.origin_m = (triangle.PointM(part * m[1] + left * b_1, part * m[2] + left * b_2) + h * n)
                       .cast<float>();
    return ray;
}

}  // namespace plumb
