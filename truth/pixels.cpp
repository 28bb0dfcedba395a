#include "truth/pixels.h"

#include <cmath>

#include "core/parallel.h"
#include "core/surface.h"
#include "rays/triangle.h"

namespace plumb {

double ShareOfBacksAround(const RayCaster& caster, const Mesh& mesh, const Vec3& point_m) {
    constexpr int kDirections = 256;
    constexpr double kGoldenAngle = 2.399963229728653;  // pi (3 - sqrt 5): Fibonacci's lattice.
    std::vector<Ray> rays(kDirections);
    std::vector<Hit> hits(rays.size());
    for (int i = 0; i < kDirections; ++i) {
        const double z = 1 - (2 * i + 1.0) / kDirections, r = std::sqrt(1 - z * z);
        rays[std::size_t(i)].origin_m = point_m.cast<float>();
        rays[std::size_t(i)].direction =
            Vec3(r * std::cos(i * kGoldenAngle), r * std::sin(i * kGoldenAngle), z)
                .cast<float>();
    }
    caster.Closest(rays, hits);
    double backs = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!hits[i].Met()) continue;
        const Vec3 front = TriangleOf(mesh, hits[i].triangle).Cross();
        backs += front.dot(rays[i].direction.cast<double>()) > 0;
    }
    return backs / kDirections;
}

PixelGeometry LookThrough(const RayCaster& caster, const Scene& scene, const Camera& camera) {
    Validate(camera);
    const int w = camera.width_px, h = camera.height_px;
    const CameraFrame frame(camera);
    PixelGeometry out;
    out.depth_m = Image<float>(w, h, std::numeric_limits<float>::infinity());
    out.position_m = out.normal = Image<Vec3f>(w, h, Vec3f::Zero());
    out.albedo = Image<Rgb>(w, h);
    out.triangle = Image<std::uint32_t>(w, h, Hit::kNone);
    Image<Receiver> receivers(w, h);
    const auto to_camera = [&](const Vec3& v) -> Vec3f {
        return Vec3(v.dot(frame.right), v.dot(frame.up), v.dot(frame.backward)).cast<float>();
    };
    ParallelFor(h, 1, [&](std::int64_t begin, std::int64_t end) {
        std::vector<Ray> rays(static_cast<std::size_t>(w));
        std::vector<Hit> hits(rays.size());
        for (int j = int(begin); j < int(end); ++j) {
            for (int i = 0; i < w; ++i) {
                Ray& ray = rays[std::size_t(i)];
                ray.origin_m = camera.position_m.cast<float>();
                ray.direction = frame.Direction(camera, i + 0.5, j + 0.5).cast<float>();
            }
            caster.Closest(rays, hits);
            for (int i = 0; i < w; ++i) {
                const Hit& hit = hits[std::size_t(i)];
                if (!hit.Met()) continue;
                const Triangle triangle = TriangleOf(scene.mesh, hit.triangle);
                const Vec3 point_m = triangle.PointM(hit.b_1, hit.b_2);
                const Vec3 from_camera = point_m - camera.position_m;
                const Vec3 front = triangle.Normal();
                const bool back = front.dot(from_camera) > 0;
                out.position_m(i, j) = to_camera(from_camera);
                out.depth_m(i, j) = -out.position_m(i, j).z();
                out.normal(i, j) = to_camera(back ? Vec3(-front) : front);
                out.albedo(i, j) = AlbedoAt(scene, hit.triangle, hit.b_1, hit.b_2);
                out.triangle(i, j) = hit.triangle;
                receivers(i, j) = {.triangle = hit.triangle,
                                   .spread = false,
                                   .back = back,
                                   .b_1 = hit.b_1,
                                   .b_2 = hit.b_2};
            }
        }
    });
    for (std::size_t p = 0; p < receivers.Pixels().size(); ++p) {
        if (out.triangle.Pixels()[p] == Hit::kNone) continue;
        out.receivers.push_back(receivers.Pixels()[p]);
        out.pixel_of_receiver.push_back(std::uint32_t(p));
        out.seen_from_behind += receivers.Pixels()[p].back;
    }
    return out;
}

}  // namespace plumb
