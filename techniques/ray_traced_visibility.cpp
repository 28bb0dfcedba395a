#include "techniques/ray_traced_visibility.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "core/camera.h"
#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/sobol.h"
#include "core/warp.h"
#include "rays/leave_surface.h"
#include "rays/triangle.h"
#include "screen_space/pixel_rect.h"

namespace plumb {
namespace {

// b_1, b_2 of where the ray `eye + t w` meets the triangle's plane, kept within the triangle: a
// pixel's centre may lie outside it by the rasterizer's 1/256 pixel.
Vec2 Barycentrics(const Triangle& triangle, const Vec3& eye, const Vec3& w) {
    const Vec3 e_1 = triangle.corners_m[1] - triangle.corners_m[0];
    const Vec3 e_2 = triangle.corners_m[2] - triangle.corners_m[0];
    const Vec3 p = w.cross(e_2), s = eye - triangle.corners_m[0];
    const double determinant = e_1.dot(p);
    if (determinant == 0) return {1.0 / 3, 1.0 / 3};
    const double b_1 = std::max(0.0, s.dot(p) / determinant);
    const double b_2 = std::max(0.0, w.dot(s.cross(e_1)) / determinant);
    const double sum = std::max(1.0, b_1 + b_2);
    return {b_1 / sum, b_2 / sum};
}

}  // namespace

void Validate(const RayTracedOptions& o) {
    if (!(o.radius_m > 0 && std::isfinite(o.radius_m))) {
        throw Error(MustBe("RayTracedOptions::radius_m", o.radius_m, "in (0, infinity)"));
    }
    if (o.rays < 1 || o.rays > 4096) {
        throw Error(MustBe("RayTracedOptions::rays", o.rays, "in [1, 4096]"));
    }
    if (o.margin_px < 0) {
        throw Error(MustBe("RayTracedOptions::margin_px", o.margin_px, ">= 0"));
    }
}

Image<float> RayTracedVisibility(const RayCaster& caster, const Scene& scene,
                                 const Camera& camera, const GBuffer& gbuffer,
                                 const RayTracedOptions& options) {
    Validate(options);
    const View& view = gbuffer.view;
    const CameraFrame frame(camera);
    Image<float> A(view.DrawnWidth(), view.DrawnHeight(), 1);
    const PixelRect made = ShownAndMargin(view, options.margin_px);
    ParallelFor(made.Height(), 4, [&](std::int64_t begin, std::int64_t end) {
        std::vector<Vec3f> directions(std::size_t(options.rays));
        std::vector<std::uint64_t> met(BitWords(directions.size()));
        for (int j = made.y0 + int(begin); j < made.y0 + int(end); ++j) {
            for (int i = made.x0; i < made.x1; ++i) {
                const std::uint32_t number = gbuffer.triangle(i, j);
                if (number == GBuffer::kSky) continue;
                const Triangle triangle = TriangleOf(scene.mesh, number);
                const Vec3 w =
                    frame.Direction(camera, i + 0.5 - view.guard_px, j + 0.5 - view.guard_px);
                const Vec2 b = Barycentrics(triangle, camera.position_m, w);
                Vec3 n = triangle.Normal();
                if (n.dot(w) > 0) n = -n;
                Ray start = LeaveSurface(triangle, b.x(), b.y(), n);
                start.far = float(options.radius_m);
                const Basis basis(n);
                const std::uint64_t net =
                    Absorb(options.seed, std::uint64_t(j) * std::uint64_t(A.Width()) + i);
                for (std::size_t s = 0; s < directions.size(); ++s) {
                    directions[s] = basis
                                        .ToWorld(SampleCosineHemisphere(
                                            SobolOwenPair(std::uint32_t(s), 0, net)))
                                        .cast<float>();
                }
                caster.AnyFromPoint(start, directions, met);
                int closed = 0;
                for (const std::uint64_t word : met) closed += std::popcount(word);
                A(i, j) = 1 - float(closed) / float(options.rays);
            }
        }
    });
    return A;
}

}  // namespace plumb
