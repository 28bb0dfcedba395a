// Averages over pixels against areas that are known exactly.
#include "truth/beauty.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.h"
#include "rays/embree/embree_caster.h"
#include "tests/truth/shapes.h"
#include "tests/truth/significance.h"

namespace plumb {
namespace {

constexpr int kNets = 16;

// Looks down on the plane z = 0 from 1 m: at 90 degrees of height, a picture of n x n pixels
// shows [-1, 1]^2, x to the right and y up.
Camera FromAbove(int n) {
    return {.position_m = {0, 0, 1},
            .target_m = {0, 0, 0},
            .up = {0, 1, 0},
            .fov_rad = std::numbers::pi / 2,
            .width_px = n,
            .height_px = n};
}

Scene OfMesh(const Mesh& mesh, float albedo) {
    Scene scene;
    scene.mesh = mesh;
    scene.material_of_face.assign(mesh.quads.size(), 0);
    scene.materials = {{.name = "all", .albedo = {albedo, albedo / 2, 0}}};
    return scene;
}

// Expected: a board of albedo 0.2 covers y < y_0 + x / 4 of the picture; the model gives it
// 0.2 of the sky's radiance, so a pixel of which it covers the share C has 1 - 0.8 C. C is
// integrated along x by the midpoint rule (4000 steps of a piecewise linear function: 1e-7).
TEST(Beauty, OfAStraightEdgeIsItsArea) {
    constexpr int n = 8;
    const double y_0 = 0.083;
    Mesh mesh;
    AddQuad(mesh, {-2, -2, 0}, {2, -2, 0}, {2, y_0 + 0.5, 0}, {-2, y_0 - 0.5, 0});
    const Scene scene = OfMesh(mesh, 0.2f);
    const EmbreeCaster caster(scene);
    const RgbSums sums =
        MeasureBeauty(caster, scene, FromAbove(n), {.replicates = kNets, .points = 256});
    int partly = 0;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            double covered = 0;
            for (int s = 0; s < 4000; ++s) {
                const double x = 2 * (i + (s + 0.5) / 4000) / n - 1;
                const double bottom = 1 - 2.0 * (j + 1) / n, top = 1 - 2.0 * j / n;
                covered += std::clamp((y_0 + x / 4 - bottom) / (top - bottom), 0.0, 1.0) / 4000;
            }
            for (std::size_t c = 0; c < 3; ++c) {
                const double rho = std::array{0.2, 0.1, 0.0}[c];
                const Measured L = sums.Of(j * n + i, c);
                EXPECT_NEAR(L.value, 1 - (1 - rho) * covered,
                            1e-6 + Sigmas(kNets) * L.standard_error)
                    << i << " " << j;
                EXPECT_LT(L.standard_error, 2e-3);
            }
            partly += covered > 0.05 && covered < 0.95;
        }
    }
    EXPECT_GE(partly, n - 1);
}

// By hand: ground of albedo 0.5 under a sky of 0.25, a light at 60 degrees from the vertical
// (irradiance 2: 1 on the ground) and a lamp straight above the middle. A roof at z = 0.5 over
// x > 0 is seen instead of the ground there; left of it the ground is lit or in its shadow: the
// shadow of the roof's edge lies at x = 0.5 tan 60 = -0.866.
TEST(Beauty, IsTheShadingModelWithHardShadows) {
    Mesh mesh;
    AddQuad(mesh, {-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0});
    AddQuad(mesh, {0, -4, 0.5}, {4, -4, 0.5}, {4, 4, 0.5}, {0, 4, 0.5});
    Scene scene = OfMesh(mesh, 0.5f);
    scene.light.sky = {0.25f, 0.25f, 0.25f};
    scene.light.directional = {{.towards = {std::sqrt(3.0), 0, 1}, .irradiance = {2, 2, 2}}};
    const EmbreeCaster caster(scene);
    constexpr int n = 32;
    const RgbSums sums =
        MeasureBeauty(caster, scene, FromAbove(n), {.replicates = 2, .points = 16});
    const int row = n / 2;
    const auto value = [&](int i) { return sums.Of(row * n + i, 0).value; };
    EXPECT_NEAR(value(0), 0.5 * (0.25 + 1), 1e-6);          // x in (-1, -0.94): lit.
    EXPECT_NEAR(value(8), 0.5 * 0.25, 1e-6);                // In the shadow.
    EXPECT_NEAR(value(n / 2 + 4), 0.5 * (0.25 + 1), 1e-6);  // On the roof.

    // A lamp 2 m above the ground, level with nothing: intensity / 4 straight below it, and
    // cos^3 of the angle elsewhere; here at the pixel centre, to the pixel's own spread of
    // d^2 / 24 of a second derivative of 3 at most.
    scene.mesh = {};
    AddQuad(scene.mesh, {-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0});
    scene.material_of_face = {0};
    scene.light = {};
    scene.light.sky = {0, 0, 0};
    scene.light.points = {{.position_m = {0, 0, 2}, .intensity = {4, 4, 4}}};
    const EmbreeCaster open(scene);
    const RgbSums lamp =
        MeasureBeauty(open, scene, FromAbove(n), {.replicates = 8, .points = 64});
    for (const int i : {0, 5, 16, 31}) {
        const double x = 2 * (i + 0.5) / n - 1, y = 1 - 2 * (row + 0.5) / n, d = 2.0 / n;
        const double cosine = 2 / std::sqrt(4 + x * x + y * y);
        const Measured L = lamp.Of(row * n + i, 0);
        EXPECT_NEAR(L.value, 0.5 * std::pow(cosine, 3),
                    d * d / 8 + Sigmas(8) * L.standard_error);
    }
}

// A shading normal decides the cosine; the face decides what is turned away from a light.
TEST(Beauty, ShadesWithInterpolatedNormals) {
    Mesh mesh;
    AddQuad(mesh, {-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0});
    mesh.normals.assign(4, Vec3f(0.6f, 0, 0.8f));
    Scene scene = OfMesh(mesh, 1);
    scene.light.sky = {0, 0, 0};
    scene.light.directional = {{.towards = {0.6, 0, 0.8}, .irradiance = {1, 1, 1}},
                               {.towards = {1, 0, -0.1}, .irradiance = {5, 5, 5}}};
    const EmbreeCaster caster(scene);
    const RgbSums sums =
        MeasureBeauty(caster, scene, FromAbove(2), {.replicates = 2, .points = 4});
    EXPECT_NEAR(sums.Of(0, 0).value, 1, 1e-6);
}

TEST(Beauty, SameBitsOnOneAndTwoThreadsAndAfterMerging) {
    Mesh mesh;
    AddQuad(mesh, {-2, -2, 0}, {0.3, -2, 0}, {0.1, 2, 0}, {-2, 2, 0});
    const Scene scene = OfMesh(mesh, 0.25f);  // Sums of such numbers are exact.
    const EmbreeCaster caster(scene);
    const Camera camera = FromAbove(40);
    SetThreadCount(1);
    const RgbSums one = MeasureBeauty(caster, scene, camera, {.replicates = 4, .points = 16});
    SetThreadCount(2);
    const RgbSums two = MeasureBeauty(caster, scene, camera, {.replicates = 4, .points = 16});
    SetThreadCount(0);
    EXPECT_EQ(one.sum, two.sum);
    RgbSums parts = MeasureBeauty(caster, scene, camera, {.replicates = 4, .points = 8});
    parts.Merge(
        MeasureBeauty(caster, scene, camera, {.replicates = 4, .first = 8, .points = 8}));
    EXPECT_EQ(one.sum, parts.sum);
    EXPECT_EQ(one.points, parts.points);
}

}  // namespace
}  // namespace plumb
