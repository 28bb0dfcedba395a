#include "rays/packets/projected_test.h"

#include <cmath>

#include "core/vec.h"

namespace plumb {

TriangleRecord RecordOfPlanes(const Corners& corners_m) {
    const auto corner = [&](std::size_t c) {
        return Vec3(double(corners_m[c][0]), double(corners_m[c][1]), double(corners_m[c][2]));
    };
    const Vec3 a = corner(0), e = corner(1) - a, f = corner(2) - a, N = e.cross(f);
    int k = 0;
    N.cwiseAbs().maxCoeff(&k);
    const int u = (k + 1) % 3, v = (k + 2) % 3;
    const Vec3 n = N / N[k];
    const double per = 1 / (e[u] * f[v] - e[v] * f[u]);
    TriangleRecord record;
    record.axis = std::uint32_t(k);
    record.numbers = {
        float(n[u]),        float(n[v]),        float(n.dot(a)),
        float(f[v] * per),  float(-f[u] * per), float((a[v] * f[u] - a[u] * f[v]) * per),
        float(-e[v] * per), float(e[u] * per),  float((a[u] * e[v] - a[v] * e[u]) * per)};
    return record;
}

}  // namespace plumb
