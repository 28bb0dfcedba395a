// The rasterizer where rounding, overflow and wild input could lead it out of its range.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "tests/screen_space/flat_scenes.h"

namespace plumb {
namespace {

// Expected: by definition. Along the cut a pixel may belong to the triangle although its centre is up
// to 1/256 pixel beyond the cut; the plane there is nearer than the near plane.
TEST(RasterRobustness, NothingIsNearerThanTheNearPlane) {
    const Camera camera = PixelCamera(80, 80);
    int beyond = 0;
    for (int k = 0; k < 100; ++k) {
        const Vec3 u = Vec3(1, 0.3 * std::sin(k), 0.4 * std::cos(2 * k)).normalized();
        const Vec3 v =
            Vec3(0.2 * std::cos(3 * k), 1, -0.3 - 0.2 * std::sin(5 * k)).normalized();
        const Vec3 foot(0, 0.7, -0.2);
        const Mesh mesh =
            OneTriangle((foot - 40 * u - 9 * v).cast<float>(),
                        (foot + 40 * u - 9 * v).cast<float>(), (foot + 70 * v).cast<float>());
        const GBuffer g =
            DrawGBuffer(GreyScene(mesh), camera, {.range = {.near_m = 1}, .guard_px = 0});
        for (int j = 0; j < 80; ++j) {
            for (int i = 0; i < 80; ++i) {
                if (g.triangle(i, j) == GBuffer::kSky) continue;
                ASSERT_LE(g.z_m(i, j), -1) << k;
                const Vec3 n = g.face_normal(i, j).cast<double>();
                const Vec3 w = g.view.Point(i + 0.5, j + 0.5, -1);
                beyond += n.dot(Vec3(foot.x(), foot.z(), -foot.y())) / n.dot(w) < 1 - 1e-6;
            }
        }
    }
    EXPECT_GT(beyond, 0);  // Or nothing was tried.
}

// Expected: the double path's picture, but for pixels that the float path's rounding of vertices
// moves across an edge. One corner is beside the camera, where float overflows.
TEST(RasterRobustness, FloatVerticesBesideTheCamera) {
    const Camera camera = PixelCamera(80, 80);
    const Scene scene = GreyScene(OneTriangle({-1, 3, -1}, {-1, 3, 1}, {3e8f, 1e-32f, 0.1f}));
    RasterOptions options;
    const GBuffer in_double = DrawGBuffer(scene, camera, options);
    options.vertices = VertexPath::kFloat;
    const GBuffer in_float = DrawGBuffer(scene, camera, options);
    int drawn = 0, differ = 0;
    for (std::size_t p = 0; p < in_float.triangle.Pixels().size(); ++p) {
        drawn += in_double.triangle.Pixels()[p] != GBuffer::kSky;
        differ += in_float.triangle.Pixels()[p] != in_double.triangle.Pixels()[p];
    }
    EXPECT_GT(drawn, 1000);
    EXPECT_LE(differ, 3);
}

// Triangles of every size that a mesh may have, from 1e-12 to 1e15 m, about and through the camera.
Mesh WildTriangles(std::uint64_t seed) {
    Mesh mesh;
    const auto random = [&](std::uint64_t t, std::uint64_t k) {
        return RandomUnit(seed, t, 0, k);
    };
    for (std::uint32_t t = 0; t < 60; ++t) {
        const double away = std::pow(10, -3 + 15 * random(t, 0) * random(t, 1));
        const double size = std::pow(10, -12 + 26 * random(t, 2));
        for (std::uint64_t k = 0; k < 3; ++k) {
            const auto axis = [&](std::uint64_t a) {
                return 2 * random(t, 10 + 3 * k + a) - 1;
            };
            const auto centre = [&](std::uint64_t a) { return 2 * random(t, 3 + a) - 1; };
            Vec3 v = away * Vec3(centre(0), centre(1), centre(2)) +
                     std::min(size, 5e14) * Vec3(axis(0), axis(1), axis(2));
            // In the camera's plane, or before it by too little for float to divide by.
            if (random(t, 30 + k) < 0.2) v.y() = random(t, 40 + k) < 0.5 ? 0 : 1e-30;
            mesh.vertices_m.push_back(v.cast<float>());
        }
        mesh.quads.push_back({3 * t, 3 * t + 1, 3 * t + 2, 3 * t + 2});
    }
    return mesh;
}

// Expected: by GBuffer's own words, whatever the input.
TEST(RasterRobustness, NothingIsNotANumber) {
    std::int64_t drawn = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const Camera camera = PixelCamera(70, 66);
        const Scene scene = GreyScene(WildTriangles(seed));
        RasterOptions options;
        options.depth = DepthFormat(seed % 4);
        options.vertices = seed % 8 < 4 ? VertexPath::kDouble : VertexPath::kFloat;
        options.z = seed % 3 == 0 ? ZSource::kStored : ZSource::kSurface;
        options.range.near_m = std::pow(10, -6 + double(seed % 7));
        if (seed % 5 == 0) options.range.far_m = 1e4 * options.range.near_m;
        const GBuffer g = DrawGBuffer(scene, camera, options);
        for (std::size_t p = 0; p < g.z_m.Pixels().size(); ++p) {
            if (g.triangle.Pixels()[p] == GBuffer::kSky) continue;
            ++drawn;
            ASSERT_LT(g.triangle.Pixels()[p] / 2, 60u) << seed;
            ASSERT_TRUE(std::isfinite(g.z_m.Pixels()[p])) << seed;
            // Eq. 2 may round to a hair before the near plane.
            const double most = options.z == ZSource::kStored ? 0.9999 : 1;
            ASSERT_LE(g.z_m.Pixels()[p], -float(most * options.range.near_m)) << seed;
            ASSERT_NEAR(g.face_normal.Pixels()[p].norm(), 1, 1e-6) << seed;
            ASSERT_NEAR(g.shading_normal.Pixels()[p].norm(), 1, 1e-6) << seed;
        }
    }
    EXPECT_GT(drawn, 10000);
}

}  // namespace
}  // namespace plumb
