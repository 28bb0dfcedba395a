// Enlarged G-buffers: against the rasterizer's ordinary ones, against areas, and through shading.
#include "screen_space/antialiasing/wide_gbuffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"
#include "scenes/atrium.h"
#include "screen_space/antialiasing/deferred_shader.h"
#include "screen_space/antialiasing/sample_count.h"
#include "screen_space/raster/draw_gbuffer.h"

namespace plumb {
namespace {

/// Looks down on the plane z = 0 from 1 m: a picture of n x n pixels shows [-1, 1]^2.
Camera FromAbove(int n) {
    return {.position_m = {0, 0, 1},
            .target_m = {0, 0, 0},
            .up = {0, 1, 0},
            .fov_rad = std::numbers::pi / 2,
            .width_px = n,
            .height_px = n};
}

/// A textured, bent board over a part of the view.
Scene Board() {
    Scene scene;
    scene.mesh.vertices_m = {{-2, -2, 0}, {2, -2, -0.1f}, {2, 0.583f, 0}, {-2, -0.417f, 0}};
    scene.mesh.uvs = {{-1, 0}, {2, 0}, {2, 1.5f}, {0, 1}};
    scene.mesh.normals = {{0, 0, 1}, {0.6f, 0, 0.8f}, {0, 0.6f, 0.8f}, {0, 0, 1}};
    scene.mesh.quads = {{0, 1, 2, 3}};
    scene.material_of_face = {1};
    Texture texture;
    texture.albedo = Image<Rgb>(16, 8);
    for (std::uint64_t i = 0; i < texture.albedo.Pixels().size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            texture.albedo.Pixels()[i][c] = float(RandomUnit(1, i, 0, c));
        }
    }
    scene.textures = {texture};
    scene.materials = {{.name = "unused"},
                       {.name = "board", .albedo = {0.5f, 0.25f, 1}, .texture = 0}};
    return scene;
}

// A sky of 1 and no lights: a surface looks like its albedo. Expected: the albedo that the
// rasterizer reads when it draws, to the bit.
TEST(DeferredShader, ReadsTheAlbedoThatTheRasterizerReads) {
    const Scene scene = Board();
    const GBuffer at_once = DrawGBuffer(scene, FromAbove(40));
    const WideGBuffer wide = DrawWideGBuffer(scene, FromAbove(40), {.m = 1});
    const Image<Rgb> late = ShadeAll(40, 40, 1, DeferredShader(scene, FromAbove(40), wide));
    int board = 0;
    for (std::size_t i = 0; i < late.Pixels().size(); ++i) {
        const bool sky = at_once.triangle.Pixels()[i] == GBuffer::kSky;
        EXPECT_EQ(late.Pixels()[i], sky ? (Rgb{1, 1, 1}) : at_once.albedo.Pixels()[i]);
        EXPECT_EQ(wide.material.Pixels()[i], sky ? WideGBuffer::kNoMaterial : 1);
        board += !sky;
    }
    EXPECT_GT(board, 400);
    EXPECT_LT(board, 1200);
    EXPECT_TRUE(wide.samples.albedo.Empty());
    EXPECT_EQ(wide.samples.z_m, at_once.z_m);
    EXPECT_EQ(wide.samples.shading_normal, at_once.shading_normal);
}

// A plain board of albedo 0.2 covers y < 0.083 + x / 4: a pixel of which it covers C has 1 - 0.8 C.
// A column of m samples of a pixel is off by 1/(2m) of C at most, so is their mean; plus 1/256 of
// a sample, to which corners are rounded.
TEST(DeferredShader, FullGridTendsToTheAreaOfAnEdge) {
    Scene scene;
    scene.mesh.vertices_m = {{-2, -2, 0}, {2, -2, 0}, {2, 0.583f, 0}, {-2, -0.417f, 0}};
    scene.mesh.quads = {{0, 1, 2, 3}};
    scene.material_of_face = {0};
    scene.materials = {{.name = "board", .albedo = {0.2f, 0.2f, 0.2f}}};
    const int n = 16;
    for (const int m : {1, 2, 5, 8}) {
        const WideGBuffer wide = DrawWideGBuffer(scene, FromAbove(n), {.m = m});
        EXPECT_EQ(wide.WidthPx(), n);
        const Image<Rgb> full = ShadeAll(n, n, m, DeferredShader(scene, FromAbove(n), wide));
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                double covered = 0;
                for (int s = 0; s < 1000; ++s) {
                    const double x = 2 * (i + (s + 0.5) / 1000) / n - 1;
                    const double bottom = 1 - 2.0 * (j + 1) / n, top = 1 - 2.0 * j / n;
                    covered += std::clamp((0.083 + x / 4 - bottom) / (top - bottom), 0.0, 1.0);
                }
                EXPECT_NEAR(full(i, j)[0], 1 - 0.8 * covered / 1000,
                            0.8 * (0.5 + 1.0 / 128) / m + 1e-5)
                    << i << " " << j << " " << m;
            }
        }
    }
}

// By hand: irradiance 2 from 60 degrees off the vertical on a white floor: 1, plus a sky of 0.25.
// Where the caller says that the light does not reach, only the sky is left. Right of x = 1/2 the
// floor is another face, of albedo 1/2.
TEST(DeferredShader, AsksForShadowsAtThePointInTheScene) {
    Scene scene;
    scene.mesh.vertices_m = {{-4, -4, 0}, {0.5f, -4, 0}, {0.5f, 4, 0},
                             {-4, 4, 0},  {4, -4, 0},    {4, 4, 0}};
    scene.mesh.quads = {{0, 1, 2, 3}, {1, 4, 5, 2}};
    scene.material_of_face = {0, 1};
    scene.materials = {{.name = "white", .albedo = {1, 1, 1}},
                       {.name = "grey", .albedo = {0.5f, 0.5f, 0.5f}}};
    scene.light.sky = {0.25f, 0.25f, 0.25f};
    scene.light.directional = {{.towards = {std::sqrt(3.0), 0, 1}, .irradiance = {2, 2, 2}}};
    const int n = 8;
    const WideGBuffer wide = DrawWideGBuffer(scene, FromAbove(n), {.m = 2});
    const IsLit upper_left = [](const LightAt& light, const Vec3& x_m, const Vec3& face) {
        EXPECT_NEAR(light.towards.z(), 0.5, 1e-12);
        EXPECT_NEAR(x_m.z(), 0, 1e-6);
        EXPECT_NEAR(face.z(), 1, 1e-6);
        return x_m.x() < 0 && x_m.y() > 0;
    };
    const Image<Rgb> lit = ShadeAll(
        n, n, 2, DeferredShader(scene, FromAbove(n), wide, {.is_lit = upper_left, .times = 3}));
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const double rho = i < 6 ? 1 : 0.5;
            EXPECT_NEAR(lit(i, j)[1], rho * (i < 4 && j < 4 ? 1.25 : 0.25), 1e-6)
                << i << " " << j;
        }
    }
    EXPECT_NEAR(ShadeAll(n, n, 2, DeferredShader(scene, FromAbove(n), wide))(5, 3)[1], 1.25,
                1e-6);
    EXPECT_THROW(DeferredShader(scene, FromAbove(n), wide, {.is_lit = {}, .times = 0}), Error);
}

// The middle sample of an odd window is the pixel's centre. Corners are rounded to 1/256 of a sample
// there and of a pixel here, so z agrees to the slope of the surface times 1/256 px: where normals
// face the viewer by at least 0.2, slope * z / f is below 5 z / (height / 2 tan) a pixel.
TEST(WideGBuffer, MiddleSampleIsThePixelsCentre) {
    const Scene scene = Atrium(0.2);
    Camera camera = scene.cameras.front();
    camera.width_px = 96;
    camera.height_px = 64;
    const GBuffer small = DrawGBuffer(scene, camera);
    const WideGBuffer wide = DrawWideGBuffer(scene, camera, {.m = 3});
    int same = 0;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 96; ++x) {
            const int X = 3 * x + 1, Y = 3 * y + 1;
            if (small.triangle(x, y) == GBuffer::kSky) continue;
            if (wide.samples.triangle(X, Y) != small.triangle(x, y)) continue;
            if (small.face_normal(x, y).z() < 0.2f) continue;
            ++same;
            const double z = small.z_m(x, y);
            const double per_px = -5 * z / small.view.PixelsPerMetre();
            EXPECT_NEAR(wide.samples.z_m(X, Y), z, per_px / 128 + 1e-6 * -z) << x << " " << y;
        }
    }
    EXPECT_GT(same, 96 * 64 / 4);
}

TEST(WideGBuffer, EightBitsAreNearAndTheSkyStays) {
    const Scene scene = Board();
    const WideGBuffer exact = DrawWideGBuffer(scene, FromAbove(20), {.m = 2});
    const WideGBuffer bytes =
        DrawWideGBuffer(scene, FromAbove(20), {.m = 2, .format = GBufferFormat::k8Bit});
    int sky = 0;
    for (std::size_t i = 0; i < exact.material.Pixels().size(); ++i) {
        const Vec3f& n = exact.samples.shading_normal.Pixels()[i];
        const Vec3f& b = bytes.samples.shading_normal.Pixels()[i];
        sky += n.isZero(0);
        EXPECT_EQ(b.isZero(0), n.isZero(0));
        EXPECT_LE((n - b).cwiseAbs().maxCoeff(), 1.0 / 255 + 1e-6);
        const Vec2f &u = exact.samples.uv.Pixels()[i], &v = bytes.samples.uv.Pixels()[i];
        for (int axis = 0; axis < 2; ++axis) {
            const double off = std::remainder(double(u[axis]) - v[axis], 1);
            EXPECT_LE(std::abs(off), 0.5 / 65535 + 1e-6);
            EXPECT_LE(v[axis], 1);
            EXPECT_GE(v[axis], 0);
        }
    }
    EXPECT_GT(sky, 100);
    // 127.5 + 0.5 is rounded up: no byte stands for 0.
    EXPECT_FLOAT_EQ(ByteNormal({0, 0, 1}).x(), float(2.0 * 128 / 255 - 1));
    EXPECT_FLOAT_EQ(ByteNormal({0, -1, 0}).y(), -1);
}

// The whole way: an empty sky asks for one sample a pixel and stays what it is.
TEST(WideGBuffer, AllSkyIsOneSampleAPixel) {
    const Scene scene = Board();
    Camera away = FromAbove(12);
    away.target_m = {0, 0, 2};
    const WideGBuffer wide = DrawWideGBuffer(scene, away, {.m = 4});
    const SampleShader shader = DeferredShader(scene, away, wide);
    const Image<Rgb> S = ShadeFirst(12, 12, 4, shader);
    const Image<std::uint8_t> counts =
        SampleCounts({wide.samples.z_m, wide.samples.shading_normal, S}, 4, {});
    EXPECT_EQ(SamplesUsed(counts, 4), 1.0 / 16);
    EXPECT_EQ(ShadeRest(S, counts, 4, shader), Image<Rgb>(12, 12, Rgb{1, 1, 1}));
}

// More samples where the board ends and where its texture changes; the adaptive picture is nearer
// the full grid than that of one sample, with fewer samples than the grid has.
TEST(WideGBuffer, AdaptiveIsNearerTheFullGridThanOneSample) {
    const Scene scene = Board();
    const int n = 48, m = 4;
    const WideGBuffer wide = DrawWideGBuffer(scene, FromAbove(n), {.m = m});
    const SampleShader shader = DeferredShader(scene, FromAbove(n), wide);
    const Image<Rgb> full = ShadeAll(n, n, m, shader), S = ShadeFirst(n, n, m, shader);
    const Image<std::uint8_t> counts =
        SampleCounts({wide.samples.z_m, wide.samples.shading_normal, S}, m, {});
    const auto mse = [&](const Image<Rgb>& of) {
        double sum = 0;
        for (std::size_t i = 0; i < of.Pixels().size(); ++i) {
            sum += std::pow(of.Pixels()[i][1] - full.Pixels()[i][1], 2);
        }
        return sum / double(of.Pixels().size());
    };
    const double adaptive = mse(ShadeRest(S, counts, m, shader));
    EXPECT_LT(adaptive, mse(S) / 4);
    EXPECT_GT(adaptive, 0);
    EXPECT_LT(SamplesUsed(counts, m), 0.6);
    SetThreadCount(1);
    EXPECT_EQ(mse(ShadeRest(S, counts, m, shader)), adaptive);
    SetThreadCount(0);
}

TEST(WideGBuffer, RefusesWhatCannotBe) {
    Scene scene = Board();
    EXPECT_THROW(DrawWideGBuffer(scene, FromAbove(8), {.m = 0}), Error);
    EXPECT_THROW(DrawWideGBuffer(scene, FromAbove(8), {.m = 9}), Error);
    EXPECT_THROW(DrawWideGBuffer(scene, FromAbove(2049), {.m = 8}), Error);
    scene.materials.resize(256);
    EXPECT_THROW(DrawWideGBuffer(scene, FromAbove(8), {.format = GBufferFormat::k8Bit}), Error);
    EXPECT_EQ(DrawWideGBuffer(scene, FromAbove(1), {.m = 2}).WidthPx(), 1);
}

}  // namespace
}  // namespace plumb
