// The rasterizer at its limits: bad input, the near and the far plane, huge and tiny triangles.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/parallel.h"
#include "scenes/simple.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "tests/screen_space/flat_scenes.h"

namespace plumb {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

// A wall that faces the camera and fills its picture, `t_m` away.
Mesh Wall(const Camera& camera, double t_m) {
    Mesh mesh;
    const double w = camera.width_px + 10, h = camera.height_px + 10;
    for (const auto& [x, y] : {std::pair{-10.0, -10.0}, {w, -10.0}, {w, h}, {-10.0, h}}) {
        mesh.vertices_m.push_back(AtPixel(camera, x, y, t_m));
    }
    mesh.quads = {{0, 1, 2, 3}};
    return mesh;
}

int Drawn(const GBuffer& g) {
    int drawn = 0;
    for (const std::uint32_t t : g.triangle.Pixels()) drawn += t != GBuffer::kSky;
    return drawn;
}

std::string WhyNot(const Scene& scene, const Camera& camera, const RasterOptions& options) {
    try {
        DrawGBuffer(scene, camera, options);
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

TEST(RasterLimits, NamesWhatIsWrong) {
    const Camera camera = PixelCamera(8, 8);
    const Scene scene = GreyScene(Wall(camera, 1));
    Camera empty = camera;
    empty.width_px = 0;
    EXPECT_EQ(WhyNot(scene, empty, {}), "camera.width_px = 0, must be in [1, 65536]");
    EXPECT_EQ(WhyNot(scene, camera, {.range = {.near_m = 0}}),
              "near_m = 0, must be > 0 and finite");
    EXPECT_EQ(WhyNot(scene, camera, {.range = {.near_m = -1}}),
              "near_m = -1, must be > 0 and finite");
    EXPECT_EQ(WhyNot(scene, camera, {.range = {.near_m = 1, .far_m = 0.5}}),
              "far_m = 0.5, must be > near_m");
    EXPECT_EQ(WhyNot(scene, camera, {.range = {}, .guard_px = -1}),
              "guard_px = -1, must be in [0, 16384]");
    EXPECT_EQ(WhyNot(scene, camera, {.range = {}, .guard_px = 8190}),
              "width_px with its border = 16388, must be at most 16384");
    Scene nan = scene;
    nan.mesh.vertices_m[2].y() = std::nanf("");
    EXPECT_EQ(WhyNot(nan, camera, {}),
              "mesh: vertices_m[2].y = nan, must be finite and at most 1e15 from 0");
    Scene lost = scene;
    lost.mesh.quads[0][1] = 4;
    EXPECT_EQ(WhyNot(lost, camera, {}), "mesh: quads[0][1] = 4, must be < 4, the vertices");
}

TEST(RasterLimits, NoFacesAreASky) {
    const GBuffer g = DrawGBuffer(GreyScene({}), PixelCamera(5, 3));
    EXPECT_EQ(g.triangle.Width(), 5);
    EXPECT_EQ(Drawn(g), 0);
    EXPECT_EQ(g.z_m(2, 1), GBuffer::kSkyZ);
    EXPECT_EQ(g.face_normal(2, 1), Vec3f::Zero());
}

TEST(RasterLimits, OnePixel) {
    const Camera camera = PixelCamera(1, 1);
    const GBuffer g = DrawGBuffer(GreyScene(Wall(camera, 2)), camera);
    EXPECT_EQ(Drawn(g), 1);
    EXPECT_EQ(g.z_m(0, 0), -2);
    EXPECT_EQ(g.face_normal(0, 0), Vec3f(0, 0, 1));
}

// Expected: e(n) = 1 exactly for a power of two; nothing of what is nearer.
TEST(RasterLimits, ThingsAtTheNearPlaneAreDrawnThingsBeforeItAreNot) {
    const Camera camera = PixelCamera(8, 8);
    for (const DepthFormat format : {DepthFormat::kD16, DepthFormat::kD24, DepthFormat::kD32F,
                                     DepthFormat::kD32FReversed}) {
        const RasterOptions options{.depth = format, .range = {.near_m = 0.25}};
        const GBuffer at = DrawGBuffer(GreyScene(Wall(camera, 0.25)), camera, options);
        EXPECT_EQ(Drawn(at), 64);
        EXPECT_EQ(DecodeDepth(format, at.depth(3, 3)),
                  format == DepthFormat::kD32FReversed ? 1 : 0);
        EXPECT_EQ(at.z_m(3, 3), -0.25f);
        EXPECT_EQ(Drawn(DrawGBuffer(GreyScene(Wall(camera, 0.2499)), camera, options)), 0);
    }
}

TEST(RasterLimits, NothingAtOrBeyondTheFarPlaneIsDrawn) {
    const Camera camera = PixelCamera(8, 8);
    const RasterOptions options{.range = {.near_m = 0.25, .far_m = 4}};
    EXPECT_EQ(Drawn(DrawGBuffer(GreyScene(Wall(camera, 3.99)), camera, options)), 64);
    EXPECT_EQ(Drawn(DrawGBuffer(GreyScene(Wall(camera, 4)), camera, options)), 0);
    EXPECT_EQ(Drawn(DrawGBuffer(GreyScene(Wall(camera, 5)), camera, options)), 0);
}

// Expected: the wall's two faces are both nearer than the near plane, so the camera sees through
// it to what stands behind; a camera in the plane of a face sees nothing of that face.
TEST(RasterLimits, CameraInsideAWall) {
    const Camera camera = PixelCamera(16, 16);
    Mesh mesh = Wall(camera, 0.005);
    Mesh behind = Wall(camera, 3);
    for (const Vec3f& v : behind.vertices_m) mesh.vertices_m.push_back(v);
    mesh.quads.push_back({4, 5, 6, 7});
    // In the camera's own plane, and edge-on through its eye.
    for (const Vec3f& v :
         {Vec3f(-1, 0, -1), Vec3f(1, 0, -1), Vec3f(1, 0, 1), Vec3f(-1, 0, 1), Vec3f(0, -1, -1),
          Vec3f(0, 5, -1), Vec3f(0, 5, 1), Vec3f(0, -1, 1)}) {
        mesh.vertices_m.push_back(v);
    }
    mesh.quads.push_back({8, 9, 10, 11});
    mesh.quads.push_back({12, 13, 14, 15});
    const GBuffer g = DrawGBuffer(GreyScene(mesh), camera);
    for (int j = 0; j < 16; ++j) {
        for (int i = 0; i < 16; ++i) {
            EXPECT_EQ(g.triangle(i, j) / 2, 1u);
            EXPECT_EQ(g.z_m(i, j), -3);
        }
    }
}

// Expected: the plane z = -1 (world) at 1.5 m below the eye, by hand: t = 1 / |w_y| of the
// pixel's direction; a triangle as large as floats allow, and one of a million metres through
// the camera's plane.
TEST(RasterLimits, HugeTrianglesAreCutRight) {
    const Camera camera = PixelCamera(64, 64);
    for (const float reach : {30.f, 1e6f, 1e12f}) {
        Mesh mesh = OneTriangle({-reach, -reach, -1}, {reach, -reach, -1}, {0, 2 * reach, -1});
        const GBuffer g = DrawGBuffer(GreyScene(mesh), camera);
        for (int j = 33; j < 64; ++j) {
            for (int i = 0; i < 64; ++i) {
                const Vec3 w = g.view.Point(i + 0.5, j + 0.5, -1);
                const double t = -1 / w.y();
                if (3 * t * std::abs(w.x()) + t > 0.99 * 2 * reach) continue;  // Its sides.
                ASSERT_EQ(g.triangle(i, j), 0u) << reach << " " << i << " " << j;
                // Float is what z_m is rounded to; with corners 1e12 m away, double.
                ASSERT_NEAR(g.z_m(i, j), -t, t * (0x1p-24 + 1e-15 * reach)) << reach;
                ASSERT_EQ(g.face_normal(i, j), Vec3f(0, 1, 0));
            }
        }
        for (int i = 0; i < 64; ++i) EXPECT_EQ(g.triangle(i, 31), GBuffer::kSky);
    }
}

// Expected: the analytic plane. Tolerance of the stored depth: half a step of the format, half
// an ulp of e, and the tile's float slope, 64 pixels x 2^-23 of it, as e; dz/de = t^2 / a.
TEST(RasterLimits, DepthOfASlantedPlane) {
    const Camera camera = PixelCamera(150, 130);
    const Vec3 n = Vec3(0.1, -1, 0.07).normalized();
    const double c = n.y() * 5;  // Through (0, 5, 0).
    const auto at = [&](double x_px, double y_px) -> Vec3f {
        const Vec3 d = AtPixel(camera, x_px, y_px).cast<double>();
        return (c / n.dot(d) * d).cast<float>();
    };
    const Mesh mesh = OneTriangle(at(-40, -30), at(400, -30), at(-40, 380));
    const Vec3 n_camera(n.x(), n.z(), -n.y());
    for (const double far : {40.0, kEndless}) {
        for (const VertexPath path : {VertexPath::kDouble, VertexPath::kFloat}) {
            for (const DepthFormat format : {DepthFormat::kD16, DepthFormat::kD24,
                                             DepthFormat::kD32F, DepthFormat::kD32FReversed}) {
                RasterOptions options{.depth = format, .range = {0.5, far}, .vertices = path};
                const GBuffer direct = DrawGBuffer(GreyScene(mesh), camera, options);
                options.z = ZSource::kStored;
                const GBuffer stored = DrawGBuffer(GreyScene(mesh), camera, options);
                const DepthCurve curve(options.range);
                for (int j = 0; j < 130; j += 3) {
                    for (int i = 0; i < 150; i += 3) {
                        const Vec3 w = direct.view.Point(i + 0.5, j + 0.5, -1);
                        const double t = c / n_camera.dot(w);
                        // Corners are floats up to 10 m away: 1e-6 m; the float path rounds
                        // x, y and e of each corner once more.
                        const double corners_m = path == VertexPath::kDouble ? 2e-6 : 1e-5;
                        ASSERT_NEAR(direct.z_m(i, j), -t, corners_m * t);
                        const double e = curve.E(t);
                        const double step = format == DepthFormat::kD16    ? 1 / 65535.0
                                            : format == DepthFormat::kD24  ? 0x1p-24
                                            : format == DepthFormat::kD32F ? 0x1p-24
                                                                           : e * 0x1p-24;
                        const double slope_e = std::max(std::abs(n.x()), std::abs(n.z())) /
                                               std::abs(c) * curve.a / 64;
                        const double off_e = step + e * 0x1p-23 + slope_e * 64 * 0x1p-22;
                        // Eq. 2 in float: three roundings of numbers near d, c_1 d and c_2.
                        const double shader_e =
                            format == DepthFormat::kD32FReversed && std::isinf(far)
                                ? e * 0x1p-23
                                : 0x1p-22;
                        ASSERT_NEAR(stored.z_m(i, j), -t,
                                    corners_m * t + (off_e + shader_e) * 1.1 * t * t / curve.a)
                            << NameOf(format) << " " << far << " " << t;
                    }
                }
            }
        }
    }
}

// Expected: by GBuffer's own words. With a near plane of 1e-4 m and a far one of 1e5 m eq. 2
// subtracts floats that are all but equal: z is coarse, but on the right side of the camera.
TEST(RasterLimits, StoredDepthIsNeverBeforeTheCamera) {
    const Camera camera = PixelCamera(8, 8);
    for (const DepthFormat format : {DepthFormat::kD24, DepthFormat::kD32F}) {
        for (const double t : {10.0, 300.0, 1000.0, 1500.0}) {
            const GBuffer g =
                DrawGBuffer(GreyScene(Wall(camera, t)), camera,
                            {.depth = format, .range = {1e-4, 1e5}, .z = ZSource::kStored});
            for (std::size_t p = 0; p < 64; ++p) {
                ASSERT_NE(g.triangle.Pixels()[p], GBuffer::kSky) << t;
                ASSERT_LT(g.z_m.Pixels()[p], 0) << t;
            }
        }
    }
}

TEST(RasterLimits, ThreadsChangeNoBit) {
    const Scene scene = BallOverPlane();
    const Camera& camera = scene.cameras[0];
    SetThreadCount(1);
    const GBuffer one = DrawGBuffer(scene, camera, {.range = {}, .guard_px = 32});
    SetThreadCount(2);
    const GBuffer two = DrawGBuffer(scene, camera, {.range = {}, .guard_px = 32});
    SetThreadCount(0);
    EXPECT_EQ(one.depth, two.depth);
    EXPECT_EQ(one.triangle, two.triangle);
    EXPECT_EQ(one.z_m, two.z_m);
    EXPECT_EQ(one.face_normal, two.face_normal);
    EXPECT_EQ(one.shading_normal, two.shading_normal);
}

// Expected: what was in the memory before does not show.
TEST(RasterLimits, AnOlderPictureLeavesNothingBehind) {
    Scene scene = BallOverPlane();
    scene.mesh.uvs.assign(scene.mesh.vertices_m.size(), Vec2f(0.25f, 0.5f));
    const Camera camera = PixelCamera(70, 50);
    RasterOptions options;
    options.texture_coordinates = true;
    Rasterizer rasterizer;
    GBuffer used;
    DrawGBuffer(rasterizer, GreyScene(Wall(camera, 2)), camera, {}, used);
    DrawGBuffer(rasterizer, scene, camera, options, used);
    Camera away = camera;
    away.position_m = {0, -4, 1.5};
    away.target_m = {0, 0, 2.5};
    DrawGBuffer(rasterizer, scene, away, options, used);
    const GBuffer fresh = DrawGBuffer(scene, away, options);
    EXPECT_GT(Drawn(fresh), 300);
    EXPECT_LT(Drawn(fresh), 3000);
    EXPECT_EQ(used.z_m, fresh.z_m);
    EXPECT_EQ(used.depth, fresh.depth);
    EXPECT_EQ(used.triangle, fresh.triangle);
    EXPECT_EQ(used.face_normal, fresh.face_normal);
    EXPECT_EQ(used.shading_normal, fresh.shading_normal);
    EXPECT_EQ(used.albedo, fresh.albedo);
    EXPECT_EQ(used.uv, fresh.uv);
    EXPECT_EQ(used.uv_per_x_px, fresh.uv_per_x_px);
    DrawGBuffer(rasterizer, scene, away, {}, used);
    EXPECT_TRUE(used.uv.Empty());
}

// Expected: the picture without a border is the middle of the picture with one.
TEST(RasterLimits, ABorderAddsPixelsAroundAndChangesNoneInside) {
    const Scene scene = BallOverPlane();
    Camera camera = scene.cameras[0];
    camera.width_px = 200;
    camera.height_px = 120;
    const GBuffer plain = DrawGBuffer(scene, camera);
    const GBuffer wide = DrawGBuffer(scene, camera, {.range = {}, .guard_px = 19});
    ASSERT_EQ(wide.triangle.Width(), 238);
    int beyond = 0;
    for (int j = 0; j < 120; ++j) {
        for (int i = 0; i < 200; ++i) {
            ASSERT_EQ(plain.triangle(i, j), wide.triangle(i + 19, j + 19)) << i << " " << j;
            if (plain.triangle(i, j) == GBuffer::kSky) continue;
            ASSERT_NEAR(plain.z_m(i, j), wide.z_m(i + 19, j + 19), 1e-6);
        }
        beyond += wide.triangle(5, j + 19) != GBuffer::kSky;
    }
    EXPECT_GT(beyond, 0);
}

}  // namespace
}  // namespace plumb
