// Textures and surface points against what bilinear interpolation must be.
#include "core/texture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "core/surface.h"

namespace plumb {
namespace {

// 8 x 4 texels, each a value of its own.
Texture Made() {
    Texture texture;
    texture.albedo = Image<Rgb>(8, 4);
    texture.opacity = Image<float>(8, 4);
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 8; ++i) {
            const float x = float(RandomUnit(1, std::uint64_t(i), std::uint64_t(j), 0));
            texture.albedo(i, j) = {x, x / 2, 1 - x};
            texture.opacity(i, j) = 1 - x;
        }
    }
    return texture;
}

// Definition: at the centre of texel (i, j), u = (i + 1/2) / W and v = 1 - (j + 1/2) / H.
// Tolerance: float rounding of numbers up to 1; the weights are exact at these places.
TEST(Texture, IsItsTexelsAtTheirCentres) {
    const Texture texture = Made();
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 8; ++i) {
            const Vec2f uv((float(i) + 0.5f) / 8, 1 - (float(j) + 0.5f) / 4);
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_FLOAT_EQ(SampleAlbedo(texture, uv)[c], texture.albedo(i, j)[c]);
            }
            EXPECT_FLOAT_EQ(SampleOpacity(texture, uv), texture.opacity(i, j));
        }
    }
}

// Definition: a quarter of the way from texel (2, 1) to its right neighbour and half the way to
// the one below, the weights are 3/4 1/4 and 1/2 1/2.
TEST(Texture, MixesItsFourNeighbours) {
    const Texture texture = Made();
    const Vec2f uv(2.75f / 8, 1 - 2.0f / 4);
    const Image<float>& o = texture.opacity;
    EXPECT_NEAR(SampleOpacity(texture, uv),
                0.375 * o(2, 1) + 0.125 * o(3, 1) + 0.375 * o(2, 2) + 0.125 * o(3, 2), 1e-6);
    EXPECT_NEAR(SampleAlbedo(texture, uv)[1],
                0.375 * texture.albedo(2, 1)[1] + 0.125 * texture.albedo(3, 1)[1] +
                    0.375 * texture.albedo(2, 2)[1] + 0.125 * texture.albedo(3, 2)[1],
                1e-6);
}

// Law: period 1 in both directions, across borders too. u and v are multiples of 2^-10, so that
// adding whole numbers is exact.
TEST(Texture, Repeats) {
    const Texture texture = Made();
    for (int k = 0; k < 1000; ++k) {
        const auto random = [&](std::uint64_t d) {
            return float(RandomBits(2, std::uint64_t(k), 0, d) % 1024) / 1024;
        };
        const Vec2f uv(random(0), random(1));
        for (const Vec2f& moved : {Vec2f(uv + Vec2f(3, -7)), Vec2f(uv + Vec2f(-1, 100))}) {
            EXPECT_EQ(SampleAlbedo(texture, uv), SampleAlbedo(texture, moved));
            EXPECT_EQ(SampleOpacity(texture, uv), SampleOpacity(texture, moved));
        }
    }
}

// Law: every texel has the same weight over one period. The mean over the centres of 16 x 16
// even parts of each texel is exact for a piecewise bilinear function (its parts are symmetric
// about the creases). Tolerance: float rounding of 2^13 terms below 1.
TEST(Texture, MeanIsTheMeanOfItsTexels) {
    const Texture texture = Made();
    double sampled = 0, texels = 0;
    for (int j = 0; j < 64; ++j) {
        for (int i = 0; i < 128; ++i) {
            sampled +=
                SampleAlbedo(texture, {(float(i) + 0.5f) / 128, (float(j) + 0.5f) / 64})[0];
        }
    }
    for (const Rgb& texel : texture.albedo.Pixels()) texels += texel[0];
    EXPECT_NEAR(sampled / (64 * 128), texels / 32, 1e-6);
}

TEST(Texture, StaysWithinItsTexelsForAnyCoordinate) {
    const Texture texture = Made();
    for (const float u : {1e30f, -1e30f, 16777217.0f, -1e-30f, 1e-30f, 0.99999994f}) {
        const float o = SampleOpacity(texture, {u, -u});
        EXPECT_GE(o, 0) << u;
        EXPECT_LE(o, 1) << u;
    }
    Texture one;
    one.albedo = Image<Rgb>(1, 1, Rgb{0.25f, 0.5f, 0.75f});
    EXPECT_EQ(SampleAlbedo(one, {0.3f, 0.9f}), (Rgb{0.25f, 0.5f, 0.75f}));
    EXPECT_EQ(SampleOpacity(one, {0.3f, 0.9f}), 1);
}

// A quad with one texture coordinate and one normal a corner.
Scene OneQuad() {
    Scene scene;
    scene.mesh.vertices_m = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    scene.mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    scene.mesh.normals = {
        Vec3f(1, 0, 1).normalized(), {0, 0, 1}, Vec3f(-1, 0, 1).normalized(), {0, 0, 1}};
    scene.mesh.quads = {{0, 1, 2, 3}};
    scene.material_of_face = {0};
    scene.materials = {{.name = "m", .albedo = {0.5f, 1, 0.25f}, .texture = 0}};
    scene.textures = {Made()};
    return scene;
}

// Definition: the first half is (a, b, d), the second (c, d, b); uv = xy here by construction.
TEST(Surface, CoordinatesAreThoseOfThePlace) {
    const Scene scene = OneQuad();
    for (std::uint32_t triangle : {0u, 1u}) {
        const auto corners = CornersOf(scene.mesh, triangle);
        const double b_1 = 0.2, b_2 = 0.5;
        const Vec3f p = 0.3f * scene.mesh.vertices_m[corners[0]] +
                        0.2f * scene.mesh.vertices_m[corners[1]] +
                        0.5f * scene.mesh.vertices_m[corners[2]];
        EXPECT_LT((UvAt(scene.mesh, triangle, b_1, b_2) - p.head<2>()).norm(), 1e-6f);
        const Rgb texture = SampleAlbedo(scene.textures[0], p.head<2>());
        const Rgb albedo = AlbedoAt(scene, triangle, b_1, b_2);
        EXPECT_NEAR(albedo[0], 0.5f * texture[0], 1e-5);
        EXPECT_NEAR(albedo[1], texture[1], 1e-5);
        EXPECT_NEAR(albedo[2], 0.25f * texture[2], 1e-5);
    }
    EXPECT_EQ(CornersOf(scene.mesh, 0), (std::array<std::uint32_t, 3>{0, 1, 3}));
    EXPECT_EQ(CornersOf(scene.mesh, 1), (std::array<std::uint32_t, 3>{2, 3, 1}));
}

TEST(Surface, HasHolesOnlyWhereAlphaTestedAndThin) {
    Scene scene = OneQuad();
    EXPECT_FALSE(IsAlphaTested(scene, 0));
    EXPECT_TRUE(IsSolidAt(scene, 0, 0.2, 0.5));
    scene.materials[0].alpha_tested = true;
    EXPECT_TRUE(IsAlphaTested(scene, 0));
    int solid = 0, holes = 0;
    for (int k = 0; k < 100; ++k) {
        const double b_1 = 0.009 * k, b_2 = 0.1;
        const bool expected =
            SampleOpacity(scene.textures[0], UvAt(scene.mesh, 1, b_1, b_2)) >= 0.5f;
        EXPECT_EQ(IsSolidAt(scene, 1, b_1, b_2), expected);
        (expected ? solid : holes) += 1;
    }
    EXPECT_GT(solid, 10);
    EXPECT_GT(holes, 10);
    scene.textures[0].opacity = {};
    EXPECT_FALSE(IsAlphaTested(scene, 0));
}

// By hand: in the middle of the edge from vertex 1 to vertex 3 all normals are +z; at corner 0
// it is (1, 0, 1) / sqrt 2, and minus that seen from below.
TEST(Surface, ShadingNormalIsInterpolatedOnTheSideSeen) {
    Scene scene = OneQuad();
    const Vec3 up(0, 0, 1), slanted = Vec3(1, 0, 1).normalized();
    EXPECT_LT((ShadingNormalAt(scene.mesh, 0, 0.5, 0.5, up) - up).norm(), 1e-6);
    EXPECT_LT((ShadingNormalAt(scene.mesh, 0, 0, 0, up) - slanted).norm(), 1e-6);
    EXPECT_LT((ShadingNormalAt(scene.mesh, 0, 0, 0, -up) + slanted).norm(), 1e-6);
    scene.mesh.normals.assign(4, Vec3f::Zero());
    EXPECT_EQ(ShadingNormalAt(scene.mesh, 0, 0.2, 0.2, up), up);
    scene.mesh.normals.clear();
    EXPECT_EQ(ShadingNormalAt(scene.mesh, 0, 0.2, 0.2, -up), Vec3(-up));
}

}  // namespace
}  // namespace plumb
