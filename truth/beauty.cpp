#include "truth/beauty.h"

#include <vector>

#include "core/parallel.h"
#include "core/shading.h"
#include "core/sobol.h"
#include "core/surface.h"
#include "rays/leave_surface.h"
#include "truth/direct_light.h"

namespace plumb {
namespace {

constexpr std::int64_t kPixelsPerChunk = 64;

// L at a point that the ray of direction w met.
Rgb RadianceAt(const RayCaster& caster, const Scene& scene, const ShadingModel& model,
               const Hit& hit, const Vec3& w) {
    const Triangle triangle = TriangleOf(scene.mesh, hit.triangle);
    const Vec3 front = triangle.Normal();
    const Vec3 face = front.dot(w) <= 0 ? front : Vec3(-front);
    const Vec3 n = ShadingNormalAt(scene.mesh, hit.triangle, hit.b_1, hit.b_2, face);
    const Ray start = LeaveSurface(triangle, hit.b_1, hit.b_2, face);
    return model.Shade(triangle.PointM(hit.b_1, hit.b_2), n,
                       AlbedoAt(scene, hit.triangle, hit.b_1, hit.b_2),
                       [&](const LightAt& light) {
                           if (!(face.dot(light.towards) > 0)) return false;
                           const Ray ray = ShadowRay(start, light);
                           std::uint64_t met = 0;
                           caster.Any({&ray, 1}, {&met, 1});
                           return met == 0;
                       });
}

}  // namespace

RgbSums MeasureBeauty(const RayCaster& caster, const Scene& scene, const Camera& camera,
                      const NetSampling& sampling, Monitor& monitor) {
    Validate(sampling);
    Validate(camera);
    const CameraFrame frame(camera);
    const ShadingModel model(scene.light);
    const std::size_t R = std::size_t(sampling.replicates);
    const std::int64_t pixels = std::int64_t(camera.width_px) * camera.height_px;
    RgbSums out(pixels, int(R), sampling.points);
    ParallelFor(
        pixels, kPixelsPerChunk,
        [&](std::int64_t begin, std::int64_t end) {
            std::vector<Ray> rays;
            std::vector<Hit> hits;
            const auto measure = [&](const NetSampling& part, std::int64_t p) {
                const double column = double(p % camera.width_px);
                const double row = double(p / camera.width_px);
                rays.resize(std::size_t(part.points));
                hits.resize(rays.size());
                for (std::size_t r = 0; r < R; ++r) {
                    const std::uint64_t net = NetSeed(part.seed, p, int(r));
                    for (std::size_t s = 0; s < rays.size(); ++s) {
                        const std::uint32_t index = std::uint32_t(part.first + std::int64_t(s));
                        const Vec2 x = SobolOwenPair(index, kFirstDirection, net);
                        rays[s].origin_m = camera.position_m.cast<float>();
                        rays[s].direction =
                            frame.Direction(camera, column + x.x(), row + x.y()).cast<float>();
                    }
                    caster.Closest(rays, hits);
                    std::array<double, 3>& sum = out.sum[std::size_t(p) * R + r];
                    for (std::size_t s = 0; s < rays.size(); ++s) {
                        const Vec3 w = rays[s].direction.cast<double>();
                        const Rgb L = hits[s].Met()
                                          ? RadianceAt(caster, scene, model, hits[s], w)
                                          : SkyRadiance(scene.light, w);
                        for (std::size_t c = 0; c < 3; ++c) {
                            sum[c] += L[c];
                            out.spread[std::size_t(p)][c].Add(L[c]);
                        }
                    }
                }
            };
            InParts(sampling, monitor, [&](const NetSampling& part) {
                for (std::int64_t p = begin; p < end; ++p) measure(part, p);
            });
        },
        monitor, "beauty");
    out.FindCeiling();
    return out;
}

}  // namespace plumb
