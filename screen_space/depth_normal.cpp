#include "screen_space/depth_normal.h"

namespace plumb {

DepthNormal NormalFromDepth(const View& view, const Image<float>& z_m, int x, int y) {
    const int dx = StepToPartner(x, z_m.Width(), [&](int i) { return z_m(i, y); });
    const int dy = StepToPartner(y, z_m.Height(), [&](int j) { return z_m(x, j); });
    const double z = z_m(x, y);
    const Vec3 C = view.Point(x + 0.5, y + 0.5, z);
    if (dx == 0 || dy == 0) return {.n = -C.normalized(), .area = 0};
    // [McGuire12 eq. 4]
    const Vec3 along_x = dx * (view.Point(x + dx + 0.5, y + 0.5, z_m(x + dx, y)) - C);
    const Vec3 along_y = dy * (view.Point(x + 0.5, y + dy + 0.5, z_m(x, y + dy)) - C);
    const Vec3 normal = along_y.cross(along_x);
    return {.n = normal.normalized(), .area = normal.norm() / (z * z)};
}

}  // namespace plumb
