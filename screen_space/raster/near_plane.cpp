#include "screen_space/raster/near_plane.h"

#include <algorithm>

#include "screen_space/raster/depth_format.h"

namespace plumb {

double NearPlaneM(const Mesh& mesh, const Camera& camera) {
    double near_m =
        std::min(DepthRange{}.near_m, (camera.target_m - camera.position_m).norm() / 256);
    Eigen::AlignedBox3f box;
    for (const Vec3f& v : mesh.vertices_m) box.extend(v);
    if (!box.isEmpty()) {
        const double diagonal_m = (box.max().cast<double>() - box.min().cast<double>()).norm();
        if (diagonal_m > 0) near_m = std::min(near_m, diagonal_m / 4096);
    }
    return near_m;
}

RasterOptions SuitedTo(const Scene& scene, const Camera& camera, int guard_px) {
    RasterOptions options;
    options.guard_px = guard_px;
    options.range.near_m = NearPlaneM(scene.mesh, camera);
    return options;
}

}  // namespace plumb
