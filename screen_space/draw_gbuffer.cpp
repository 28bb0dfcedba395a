#include "screen_space/draw_gbuffer.h"

#include <algorithm>
#include <optional>

#include "core/parallel.h"
#include "screen_space/seen_triangle.h"

namespace plumb {
namespace {

constexpr std::int64_t kRowsAtATime = 8;

// What all pixels of a triangle share.
struct Surface {
    std::uint32_t triangle;
    std::array<std::uint32_t, 3> corners;
    SeenTriangle seen;
    Vec3 normal;

    Surface(std::uint32_t number, const Mesh& mesh, const std::vector<ScreenVertex>& vertices)
        : triangle(number),
          corners(CornersOfTriangle(mesh, number)),
          seen({vertices[corners[0]].P, vertices[corners[1]].P, vertices[corners[2]].P}),
          normal(seen.Normal()) {}
};

Vec3f ShadingNormal(const Mesh& mesh, const CameraFrame& frame, const Surface& surface,
                    const Vec3& b) {
    Vec3 n = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        n += b[k] * mesh.normals[surface.corners[std::size_t(k)]].cast<double>();
    }
    const Vec3 in_camera(n.dot(frame.right), n.dot(frame.up), n.dot(frame.backward));
    const double length = in_camera.norm();
    if (!(length > 0)) return surface.normal.cast<float>();
    const double side = in_camera.dot(surface.normal) < 0 ? -1 : 1;
    return Vec3(side / length * in_camera).cast<float>();
}

}  // namespace

GBuffer DrawGBuffer(const Scene& scene, const Camera& camera, const RasterOptions& options) {
    Rasterizer rasterizer;
    return DrawGBuffer(rasterizer, scene, camera, options);
}

GBuffer DrawGBuffer(Rasterizer& rasterizer, const Scene& scene, const Camera& camera,
                    const RasterOptions& options) {
    const Mesh& mesh = scene.mesh;
    const VisibilityBuffer& seen = rasterizer.Draw(mesh, camera, options);
    const CameraFrame frame(camera);
    const int width = seen.view.DrawnWidth(), height = seen.view.DrawnHeight();
    GBuffer out;
    out.view = seen.view;
    out.format = seen.format;
    out.range = seen.range;
    out.depth = seen.depth;
    out.triangle = seen.triangle;
    out.z_m = Image<float>(width, height, GBuffer::kSkyZ);
    out.face_normal = out.shading_normal = Image<Vec3f>(width, height, Vec3f::Zero());
    out.albedo = Image<Rgb>(width, height);
    ParallelFor(height, kRowsAtATime, [&](std::int64_t begin, std::int64_t end) {
        std::optional<Surface> here;
        for (int j = int(begin); j < int(end); ++j) {
            for (int i = 0; i < width; ++i) {
                const std::uint32_t triangle = seen.triangle(i, j);
                if (triangle == GBuffer::kSky) continue;
                if (!here || triangle != here->triangle) {
                    here.emplace(triangle, mesh, rasterizer.Vertices());
                }
                const Surface& surface = *here;
                const Vec3 b = surface.seen.Weights(seen.view, i + 0.5, j + 0.5);
                if (options.z == ZSource::kStored) {
                    out.z_m(i, j) =
                        ReconstructZ(seen.format, seen.range,
                                     float(DecodeDepth(seen.format, seen.depth(i, j))));
                } else {
                    const double z = surface.seen.PointM(b).z();
                    out.z_m(i, j) = float(std::min(z, -options.range.near_m));
                }
                out.face_normal(i, j) = surface.normal.cast<float>();
                out.shading_normal(i, j) = mesh.normals.empty()
                                               ? out.face_normal(i, j)
                                               : ShadingNormal(mesh, frame, surface, b);
                out.albedo(i, j) = scene.AlbedoOfTriangle(triangle);
            }
        }
    });
    return out;
}

}  // namespace plumb
