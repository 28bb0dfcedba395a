// Texture coordinates, textures, holes and shading normals of the G-buffer, against primary rays
// of truth/ and against the closed form of a textured plane.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/surface.h"
#include "rays/embree/embree_caster.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/seen_triangle.h"
#include "tests/screen_space/flat_scenes.h"
#include "truth/pixels.h"

namespace plumb {
namespace {

// Smooth, with holes in about half of it.
Texture Lattice() {
    constexpr int kSize = 64;
    Texture texture;
    texture.albedo = Image<Rgb>(kSize, kSize);
    texture.opacity = Image<float>(kSize, kSize);
    for (int j = 0; j < kSize; ++j) {
        for (int i = 0; i < kSize; ++i) {
            const double a = 2 * std::numbers::pi * (i + 0.5) / kSize;
            const double b = 2 * std::numbers::pi * (j + 0.5) / kSize;
            texture.opacity(i, j) = float(0.5 + 0.45 * std::sin(3 * a) * std::cos(2 * b));
            texture.albedo(i, j) = {float(0.5 + 0.4 * std::sin(a)),
                                    float(0.5 + 0.4 * std::cos(b)), 0.25f};
        }
    }
    return texture;
}

// Two slanted boards behind each other over a corner of sky, both with the lattice; seen partly
// from their fronts and partly from their backs.
Scene Boards() {
    Scene scene;
    scene.mesh.vertices_m = {{-2, 2, -1}, {2, 4, -1.2f}, {2.2f, 5, 1.5f}, {-2, 2.2f, 1},
                             {2, 6, -2},  {-4, 6, -2},   {-4, 9, 3},      {1.5f, 8, 3}};
    scene.mesh.uvs = {{0, 0}, {2, 0}, {2, 1}, {0, 1.5f}, {0, 0}, {3, 0}, {3, 3}, {0, 3}};
    for (int k = 0; k < 8; ++k) {
        const double phi = 0.4 * k;
        scene.mesh.normals.push_back(
            Vec3(0.5 * std::cos(phi), -1, 0.5 * std::sin(phi)).normalized().cast<float>());
    }
    scene.mesh.quads = {{0, 1, 2, 3}, {4, 5, 6, 7}};
    scene.textures = {Lattice()};
    scene.materials = {
        {.name = "lattice", .albedo = {0.5f, 0.75f, 1.f}, .texture = 0, .alpha_tested = true}};
    scene.material_of_face = {0, 0};
    return scene;
}

// Expected: what primary rays see. Left out: pixels where either sees the next surface because
// the opacity there is within what float coordinates can tell of 1/2. Tolerance: float
// barycentrics of the caster, 1e-6, times the steepest change of the texture across a triangle:
// 2 pi x 3 x 3 repeats x 0.45 = 25; bilinear slopes are no steeper.
TEST(RasterTextures, HolesTexturesAndNormalsAreThoseThatRaysSee) {
    const Scene scene = Boards();
    const Camera camera = PixelCamera(120, 100);
    const EmbreeCaster caster(scene);
    const PixelGeometry truth = LookThrough(caster, scene, camera);
    const GBuffer drawn = DrawGBuffer(scene, camera);
    int same = 0, differ = 0, through = 0;
    for (int j = 0; j < 100; ++j) {
        for (int i = 0; i < 120; ++i) {
            if (truth.triangle(i, j) != drawn.triangle(i, j)) {
                ++differ;
                continue;
            }
            if (drawn.triangle(i, j) == GBuffer::kSky) continue;
            ++same;
            through += drawn.triangle(i, j) / 2 == 1;
            for (std::size_t c = 0; c < 3; ++c) {
                ASSERT_NEAR(drawn.albedo(i, j)[c], truth.albedo(i, j)[c], 25e-6);
            }
            ASSERT_LT((drawn.face_normal(i, j) - truth.normal(i, j)).norm(), 1e-6);
            ASSERT_NEAR(drawn.z_m(i, j), -truth.depth_m(i, j), 1e-5);
            ASSERT_GE(drawn.shading_normal(i, j).dot(drawn.face_normal(i, j)), 0);
            ASSERT_NEAR(drawn.shading_normal(i, j).norm(), 1, 1e-6);
        }
    }
    EXPECT_GT(same, 2500);
    EXPECT_GT(through, 500);  // Or the holes are shut.
    // Edges and rims: 120 x 100 pixels within 1e-6 of a rim are none or a few.
    EXPECT_LE(differ, 3);
}

// Expected: by definition, of surfaces at one depth the first in the mesh is seen, whichever of
// them may have holes.
TEST(RasterTextures, HolesDoNotChangeTheOrder) {
    Scene scene = Boards();
    scene.mesh.quads = {{0, 1, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 3}};
    scene.materials.push_back({.name = "whole"});
    const Camera camera = PixelCamera(120, 100);
    for (const std::vector<std::uint16_t>& materials :
         {std::vector<std::uint16_t>{1, 0, 1}, {0, 1, 1}, {0, 0, 1}}) {
        scene.material_of_face = materials;
        const GBuffer g = DrawGBuffer(scene, camera);
        RasterOptions options;
        options.texture_coordinates = true;
        const GBuffer again = DrawGBuffer(scene, camera, options);
        int seen[3] = {};
        for (std::size_t p = 0; p < g.triangle.Pixels().size(); ++p) {
            if (g.triangle.Pixels()[p] == GBuffer::kSky) continue;
            const float opacity = SampleOpacity(scene.textures[0], again.uv.Pixels()[p]);
            if (std::abs(opacity - 0.5f) < 1e-4f) continue;
            std::uint32_t first = 0;
            while (materials[first] == 0 && opacity < 0.5f) ++first;
            ASSERT_EQ(g.triangle.Pixels()[p] / 2, first);
            ++seen[first];
        }
        EXPECT_GT(seen[0], 100);
    }
}

// Expected: by definition, holes are only where the opacity is below 1/2.
TEST(RasterTextures, WithoutTheTestTheBoardIsWhole) {
    Scene scene = Boards();
    const Camera camera = PixelCamera(120, 100);
    const GBuffer holes = DrawGBuffer(scene, camera);
    scene.materials[0].alpha_tested = false;
    RasterOptions options;
    options.texture_coordinates = true;
    const GBuffer whole = DrawGBuffer(scene, camera, options);
    int open = 0, solid = 0;
    for (int j = 0; j < 100; ++j) {
        for (int i = 0; i < 120; ++i) {
            if (whole.triangle(i, j) / 2 != 0) continue;
            const float opacity = SampleOpacity(scene.textures[0], whole.uv(i, j));
            if (std::abs(opacity - 0.5f) < 1e-4f) continue;
            ASSERT_EQ(holes.triangle(i, j) / 2 == 0, opacity > 0.5f) << i << " " << j;
            ++(opacity > 0.5f ? solid : open);
        }
    }
    EXPECT_GT(open, 500);
    EXPECT_GT(solid, 500);
}

// Expected: a pixel that rounding gave to a triangle gets a point of the triangle, not of its plane
// beyond it, and an edge-on triangle its middle.
TEST(SeenTriangle, WeightsStayInTheTriangle) {
    const View view{.width_px = 100, .height_px = 100};
    const SeenTriangle triangle({Vec3(-1, -1, -2), Vec3(1, -1, -5), Vec3(-0.5, 1.5, -2.5)});
    for (double y = 0; y <= 100; y += 5) {
        for (double x = 0; x <= 100; x += 5) {
            const Vec3 b = triangle.Weights(view, x, y);
            EXPECT_NEAR(b.sum(), 1, 1e-15);
            EXPECT_GE(b.minCoeff(), 0) << x << " " << y;
        }
    }
    const SeenTriangle edge_on({Vec3(0, 0, -1), Vec3(1, 0, -2), Vec3(0.5, 0, -3)});
    EXPECT_NEAR((edge_on.Weights(view, 50, 50) - Vec3::Constant(1.0 / 3)).norm(), 0, 1e-15);
}

// Expected: on the floor z = -1 with uv = (x, y) / 2 the coordinates and their derivatives by
// hand: x = t X, y = t with t = -1 / Y at the direction (X, 1, Y), steps of 1/64 a pixel.
// Tolerance: float.
TEST(RasterTextures, CoordinatesAndDerivativesOfAFloorByHand) {
    const Camera camera = PixelCamera(96, 96);
    Scene scene = GreyScene({});
    for (const Vec2f& p : {Vec2f(-80, -2), Vec2f(80, -2), Vec2f(80, 100), Vec2f(-80, 100)}) {
        scene.mesh.vertices_m.push_back({p.x(), p.y(), -1});
        scene.mesh.uvs.push_back(p / 2);
    }
    scene.mesh.quads = {{0, 1, 2, 3}};
    scene.material_of_face = {0};
    RasterOptions options;
    options.texture_coordinates = true;
    const GBuffer g = DrawGBuffer(scene, camera, options);
    int seen = 0;
    for (int j = 50; j < 96; ++j) {
        for (int i = 0; i < 96; ++i) {
            ASSERT_NE(g.triangle(i, j), GBuffer::kSky);
            const double X = (i + 0.5 - 48) / 64, Y = (48 - j - 0.5) / 64, step = 1.0 / 64;
            const double t = -1 / Y;
            EXPECT_NEAR(g.uv(i, j).x(), t * X / 2, 1e-6 * t);
            EXPECT_NEAR(g.uv(i, j).y(), t / 2, 1e-6 * t);
            EXPECT_NEAR(g.uv_per_x_px(i, j).x(), t * step / 2, 1e-6 * t);
            EXPECT_NEAR(g.uv_per_x_px(i, j).y(), 0, 1e-6 * t);
            // Downwards Y falls by a step: dt/dj = -step t^2.
            EXPECT_NEAR(g.uv_per_y_px(i, j).x(), -step * t * t * X / 2, 1e-6 * t * t);
            EXPECT_NEAR(g.uv_per_y_px(i, j).y(), -step * t * t / 2, 1e-6 * t * t);
            ++seen;
        }
    }
    EXPECT_EQ(seen, 46 * 96);
}

}  // namespace
}  // namespace plumb
