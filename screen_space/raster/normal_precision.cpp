#include "screen_space/raster/normal_precision.h"

#include <cmath>
#include <limits>

#include "core/parallel.h"
#include "screen_space/depth_normal.h"

namespace plumb {
namespace {

bool IsWithinAFace(const GBuffer& g, int i, int j) {
    const std::uint32_t triangle = g.triangle(i, j);
    if (triangle == GBuffer::kSky) return false;
    const int across = StepToPartner(i, g.z_m.Width(), [&](int k) { return g.z_m(k, j); });
    const int down = StepToPartner(j, g.z_m.Height(), [&](int k) { return g.z_m(i, k); });
    return across != 0 && down != 0 && g.triangle(i + across, j) == triangle &&
           g.triangle(i, j + down) == triangle;
}

}  // namespace

Image<float> NormalErrorRad(const GBuffer& g) {
    Image<float> angle(g.z_m.Width(), g.z_m.Height(), std::numeric_limits<float>::quiet_NaN());
    ParallelFor(angle.Height(), 8, [&](std::int64_t begin, std::int64_t end) {
        for (int j = int(begin); j < int(end); ++j) {
            for (int i = 0; i < angle.Width(); ++i) {
                if (!IsWithinAFace(g, i, j)) continue;
                const Vec3 n = NormalFromDepth(g.view, g.z_m, i, j).n;
                const Vec3 exact = g.face_normal(i, j).cast<double>().normalized();
                angle(i, j) = float(std::atan2(n.cross(exact).norm(), n.dot(exact)));
            }
        }
    });
    return angle;
}

}  // namespace plumb
