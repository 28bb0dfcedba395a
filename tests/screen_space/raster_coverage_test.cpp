// Which pixels triangles cover: the published examples, and each pixel of a surface once.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/surface.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/rasterizer.h"
#include "tests/screen_space/flat_scenes.h"

namespace plumb {
namespace {

using Pixels = std::set<std::pair<int, int>>;

Pixels Covered(const Mesh& mesh, const Camera& camera, const RasterOptions& options = {}) {
    Rasterizer rasterizer;
    const VisibilityBuffer& seen = rasterizer.Draw(mesh, camera, options);
    Pixels out;
    for (int j = 0; j < seen.triangle.Height(); ++j) {
        for (int i = 0; i < seen.triangle.Width(); ++i) {
            if (seen.triangle(i, j) != GBuffer::kSky) out.insert({i, j});
        }
    }
    return out;
}

// Expected: facts/screen_space.md 5, the example of Direct3D's documentation: 15 and 10 pixels,
// no overlap. The diagonal passes through five pixel centres; it is a left edge of the first
// triangle only.
TEST(RasterCoverage, Direct3DExampleTriangles) {
    const Camera camera = PixelCamera(8, 8);
    const auto at = [&](double x, double y) { return AtPixel(camera, x, y); };
    const Pixels upper = Covered(OneTriangle(at(0, 0), at(5, 0), at(5, 5)), camera);
    const Pixels lower = Covered(OneTriangle(at(0, 5), at(0, 0), at(5, 5)), camera);
    Pixels all = upper;
    all.insert(lower.begin(), lower.end());
    EXPECT_EQ(upper.size(), 15u);
    EXPECT_EQ(lower.size(), 10u);
    EXPECT_EQ(all.size(), 25u);
    EXPECT_TRUE(upper.contains({0, 0}));
    EXPECT_TRUE(upper.contains({4, 4}));
    // Turned over: the same pixels.
    EXPECT_EQ(Covered(OneTriangle(at(5, 0), at(0, 0), at(5, 5)), camera), upper);
}

// Every triangle of a mesh drawn alone, counted.
Image<int> Counts(const Mesh& mesh, const Camera& camera, const RasterOptions& options = {}) {
    Rasterizer rasterizer;
    Image<int> counts(camera.width_px, camera.height_px);
    Mesh one;
    one.vertices_m = mesh.vertices_m;
    for (std::uint32_t t = 0; t < 2 * mesh.quads.size(); ++t) {
        if (t % 2 == 1 && mesh.quads[t / 2][2] == mesh.quads[t / 2][3]) continue;
        const auto [a, b, c] = CornersOf(mesh, t);
        one.quads = {{a, b, c, c}};
        const VisibilityBuffer& seen = rasterizer.Draw(one, camera, options);
        for (std::size_t p = 0; p < counts.Pixels().size(); ++p) {
            counts.Pixels()[p] += seen.triangle.Pixels()[p] != GBuffer::kSky;
        }
    }
    return counts;
}

// A sheet over the whole picture and beyond, its vertices thrown about at random, some of them
// exactly onto pixel centres and corners.
Mesh RandomSheet(const Camera& camera, int n, double margin_px, std::uint64_t seed) {
    Mesh mesh;
    const double w = camera.width_px + 2 * margin_px, h = camera.height_px + 2 * margin_px;
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            const auto random = [&](int k) { return RandomUnit(seed, j * (n + 1) + i, 0, k); };
            double x = w * i / n - margin_px, y = h * j / n - margin_px;
            if (i > 0 && i < n && j > 0 && j < n) {
                x += 0.24 * w / n * (2 * random(0) - 1);
                y += 0.24 * h / n * (2 * random(1) - 1);
                const double grid = random(2) < 0.3 ? 0.5 : random(2) < 0.5 ? 1 : 1.0 / 1024;
                x = std::round(x / grid) * grid;
                y = std::round(y / grid) * grid;
            }
            mesh.vertices_m.push_back(AtPixel(camera, x, y, 1 + random(3)));
        }
    }
    const std::uint32_t row = std::uint32_t(n) + 1;
    for (std::uint32_t j = 0; j + 1 < row; ++j) {
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t a = j * row + i;
            mesh.quads.push_back({a, a + 1, a + row + 1, a + row});
        }
    }
    return mesh;
}

// Expected: 1 everywhere, by the definition of a fill rule: a sheet without folds covers each
// centre once. Corners thrown by less than 1/4 of a quad keep every quad convex.
TEST(RasterCoverage, EverySharedEdgeIsDrawnOnce) {
    for (const double margin : {3.0, 40.0, 6000.0, 90000.0, 5e6}) {
        const Camera camera = PixelCamera(96, 80);
        const Image<int> counts = Counts(RandomSheet(camera, 9, margin, 7), camera);
        for (const int count : counts.Pixels()) ASSERT_EQ(count, 1) << margin;
    }
    for (const Camera& camera : {PixelCamera(16384, 9), PixelCamera(9, 16384)}) {
        const Image<int> counts = Counts(RandomSheet(camera, 6, 50, 8), camera);
        for (const int count : counts.Pixels()) ASSERT_EQ(count, 1) << camera.width_px;
    }
}

// Of triangles at one and the same depth the first stays; so a pixel shows the same triangle in
// both orders of drawing exactly if one triangle covers it, and no pixel is empty if there is
// no crack.
void ExpectEachPixelOnce(const Mesh& mesh, const Camera& camera) {
    Mesh reversed = mesh;
    std::reverse(reversed.quads.begin(), reversed.quads.end());
    Rasterizer rasterizer;
    const Image<std::uint32_t> forth = rasterizer.Draw(mesh, camera, {}).triangle;
    const Image<std::uint32_t>& back = rasterizer.Draw(reversed, camera, {}).triangle;
    const std::uint32_t last = std::uint32_t(mesh.quads.size()) - 1;
    int empty = 0, twice = 0;
    for (std::size_t p = 0; p < back.Pixels().size(); ++p) {
        const std::uint32_t a = forth.Pixels()[p], b = back.Pixels()[p];
        empty += a == GBuffer::kSky;
        twice += a / 2 != last - b / 2;
    }
    EXPECT_EQ(empty, 0);
    EXPECT_EQ(twice, 0);
}

Mesh Triangles(std::vector<Vec3f> vertices, std::uint32_t count,
               std::array<std::uint32_t, 3> (*corners)(std::uint32_t)) {
    Mesh mesh;
    mesh.vertices_m = std::move(vertices);
    for (std::uint32_t t = 0; t < count; ++t) {
        const auto [a, b, c] = corners(t);
        mesh.quads.push_back({a, b, c, c});
    }
    return mesh;
}

// A million slivers, far thinner than a pixel: a strip that zigzags between two slanted sides,
// and a fan about a point that is no pixel centre.
TEST(RasterCoverage, AMillionSliversLeaveNoCrack) {
    const Camera camera = PixelCamera(320, 200);
    constexpr std::uint32_t kCount = 1'000'000;
    std::vector<Vec3f> strip, fan{AtPixel(camera, 160.3, 99.7)};
    for (std::uint32_t k = 0; k < kCount + 2; ++k) {
        const double y = -20 + 240.0 * k / (kCount + 1);
        strip.push_back(AtPixel(camera, k % 2 == 0 ? -5 - y / 40 : 330 + y / 50, y));
        const double phi = 2 * 3.14159265358979 * k / (kCount - 1);
        fan.push_back(AtPixel(camera, 160.3 + 400 * std::cos(phi), 99.7 + 400 * std::sin(phi)));
    }
    fan[kCount] = fan[1];
    ExpectEachPixelOnce(Triangles(strip, kCount,
                                  [](std::uint32_t t) {
                                      return std::array{t, t + 1, t + 2};
                                  }),
                        camera);
    ExpectEachPixelOnce(Triangles(fan, kCount - 1,
                                  [](std::uint32_t t) {
                                      return std::array{0u, t + 1, t + 2};
                                  }),
                        camera);
}

// Fans from one side of the picture far out of the other: their edges are the longest that fixed
// point must hold, or are cut, one side at a time.
TEST(RasterCoverage, FansToEachSideLeaveNoCrack) {
    const Camera camera = PixelCamera(150, 150);
    for (const double far_px : {8000.0, 20000.0, 200000.0}) {
        for (int side = 0; side < 4; ++side) {
            const auto turned = [&](double x, double y) {
                const double c = side % 2 == 0 ? 1 - side : 0, s = side % 2 == 0 ? 0 : 2 - side;
                return AtPixel(camera, 75.3 + c * x - s * y, 75.2 + s * x + c * y);
            };
            std::vector<Vec3f> fan{turned(-900, 0)};
            for (int k = 0; k <= 40; ++k) {
                fan.push_back(turned(far_px, (k - 20) * (far_px + 900) / 90));
            }
            ExpectEachPixelOnce(Triangles(fan, 40,
                                          [](std::uint32_t t) {
                                              return std::array{0u, t + 1, t + 2};
                                          }),
                                camera);
        }
    }
}

// The same where triangles are cut at the near plane and at the reach of fixed point: a fan that
// stretches far beyond both, in the plane of a floor.
TEST(RasterCoverage, CutTrianglesLeaveNoCrack) {
    const Camera camera = PixelCamera(320, 200);
    Mesh mesh;
    constexpr std::uint32_t kCount = 997;
    mesh.vertices_m = {{0.1f, 2.f, -1}};
    for (std::uint32_t k = 0; k <= kCount; ++k) {
        const double phi = 2 * 3.14159265358979 * (k % kCount) / kCount;
        mesh.vertices_m.push_back(
            Vec3(3e6 * std::cos(phi), 3e6 * std::sin(phi), -1).cast<float>());
    }
    for (std::uint32_t t = 0; t < kCount; ++t) mesh.quads.push_back({0, t + 1, t + 2, t + 2});
    Mesh reversed = mesh;
    std::reverse(reversed.quads.begin(), reversed.quads.end());
    Rasterizer rasterizer;
    const Image<std::uint32_t> forth = rasterizer.Draw(mesh, camera, {}).triangle;
    const Image<std::uint32_t>& back = rasterizer.Draw(reversed, camera, {}).triangle;
    int differ = 0;
    // The horizon, 3e6 m away and 1 m below the eye, is 2e-5 pixels below the middle.
    for (int j = 100; j < 200; ++j) {
        for (int i = 0; i < 320; ++i) {
            ASSERT_NE(forth(i, j), GBuffer::kSky) << i << " " << j;
            // One plane, but each triangle's own arithmetic: where two triangles cover a pixel
            // the same one may win twice, so this alone would not see a pixel drawn twice.
            differ += forth(i, j) / 2 != kCount - 1 - back(i, j) / 2;
        }
    }
    EXPECT_EQ(differ, 0);
}

}  // namespace
}  // namespace plumb
