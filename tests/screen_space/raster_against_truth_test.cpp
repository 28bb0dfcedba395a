// The rasterizer's pixels against primary rays of truth/, which shares nothing with it but core/.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "rays/embree/embree_caster.h"
#include "rays/triangle.h"
#include "scenes/atrium.h"
#include "scenes/dense.h"
#include "scenes/simple.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "truth/pixels.h"

namespace plumb {
namespace {

// A triangle in the camera's frame, by the test's own arithmetic.
struct Projected {
    std::array<Vec3, 3> P;

    Projected(const Scene& scene, const Camera& camera, std::uint32_t number) {
        const CameraFrame frame(camera);
        const Triangle triangle = TriangleOf(scene.mesh, number);
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 v = triangle.corners_m[k] - camera.position_m;
            P[k] = {v.dot(frame.right), v.dot(frame.up), v.dot(frame.backward)};
        }
    }

    Vec3 Normal() const { return (P[1] - P[0]).cross(P[2] - P[0]); }

    // Where the ray w meets the plane: t w.
    double T(const Vec3& w) const { return Normal().dot(P[0]) / Normal().dot(w); }

    // Distance in pixels from the nearest edge, each cut off at the near plane.
    double FromEdge(const View& view, const Vec2& c, double near_m) const {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < 3; ++k) {
            Vec3 p = P[k], q = P[(k + 1) % 3];
            if (p.z() > q.z()) std::swap(p, q);  // p is the farther one.
            if (p.z() > -near_m) continue;
            if (q.z() > -near_m) q = p + (-near_m - p.z()) / (q.z() - p.z()) * (q - p);
            const Vec2 a = view.Project(p), ab = view.Project(q) - a;
            const double along =
                std::clamp((c - a).dot(ab) / std::max(ab.squaredNorm(), 1e-300), 0.0, 1.0);
            nearest = std::min(nearest, (c - a - along * ab).norm());
        }
        return nearest;
    }
};

struct Agreement {
    int pixels = 0, same = 0;  // All; those that show the same surface, off its edges.
    int near_edge = 0;         // Differ, but within 1/256 pixel of an edge of one of the two.
    int as_deep = 0;           // Differ, but the format cannot tell which is nearer.
    int wrong = 0;
    int z_off = 0;  // z_m is not the exact plane's, rounded to float.
    int stored_off =
        0;  // The stored depth is off by more than screen_space/raster/draw_in_tile.h states.
};

// Two surfaces may be told from each other if their e differ by more than this.
double FormatStep(DepthFormat format) {
    return format == DepthFormat::kD16    ? 1.0 / 65535
           : format == DepthFormat::kD24  ? 2.0 / 16777215
           : format == DepthFormat::kD32F ? 0x1p-24
                                          : 0;
}

// By what e may be off: the tile's float plane, and the format.
double DepthBound(const DepthCurve& curve, DepthFormat format, const Projected& triangle,
                  const View& view, double e) {
    const Vec3 n = triangle.Normal();
    const double scale = curve.a / std::abs(n.dot(triangle.P[0]));
    const double slope = scale * (std::abs(n.x()) * 2 * view.tan_half_width / view.width_px +
                                  std::abs(n.y()) * 2 * view.tan_half_height / view.height_px);
    const double plane = 0x1p-24 * (3 * e + 320 * slope);
    switch (format) {
        case DepthFormat::kD16:
            return plane + 0.51 / 65535;
        case DepthFormat::kD24:
            return plane + 1.01 / 16777215;  // The product with 2^24 - 1 is rounded too.
        case DepthFormat::kD32F:
            return plane + 0x1p-25;
        case DepthFormat::kD32FReversed:
            break;
    }
    return plane;
}

Agreement Compare(const Scene& scene, const Camera& camera, const RasterOptions& options = {}) {
    const EmbreeCaster caster(scene.mesh);
    const PixelGeometry truth = LookThrough(caster, scene, camera);
    const GBuffer drawn = DrawGBuffer(scene, camera, options);
    const DepthCurve curve(options.range);
    const double near_m = options.range.near_m;
    Agreement out;
    for (int j = 0; j < camera.height_px; ++j) {
        for (int i = 0; i < camera.width_px; ++i) {
            const std::uint32_t a = truth.triangle(i, j), b = drawn.triangle(i, j);
            const Vec2 centre(i + 0.5, j + 0.5);
            ++out.pixels;
            double edge = std::numeric_limits<double>::infinity();
            for (const std::uint32_t number : {a, b}) {
                if (number == GBuffer::kSky) continue;
                edge = std::min(
                    edge,
                    Projected(scene, camera, number).FromEdge(drawn.view, centre, near_m));
            }
            if (a != b) {
                const double t_truth = truth.depth_m(i, j), t = -double(drawn.z_m(i, j));
                if (edge <= 1.0 / 256) {
                    ++out.near_edge;
                } else if (std::abs(t - t_truth) <=
                           1e-6 * t_truth + FormatStep(options.depth) * t * t / curve.a) {
                    ++out.as_deep;
                } else {
                    ++out.wrong;
                }
                continue;
            }
            if (a == GBuffer::kSky || edge <= 1.0 / 256) continue;
            ++out.same;
            const Projected triangle(scene, camera, a);
            const Vec3 w = drawn.view.Point(centre.x(), centre.y(), -1);
            const double t = triangle.T(w), e = curve.E(t);
            // 1e-13: double, seen at a slant.
            const double slant =
                triangle.Normal().norm() * w.norm() / std::abs(triangle.Normal().dot(w));
            out.z_off += !(std::abs(drawn.z_m(i, j) + t) <= t * (0x1p-24 + 1e-13 * slant));
            const double d = DecodeDepth(options.depth, drawn.depth(i, j));
            const double stored = options.depth == DepthFormat::kD32FReversed ? d : 1 - d;
            out.stored_off +=
                !(std::abs(stored - e) <=
                  DepthBound(curve, options.depth, triangle, drawn.view, e) + 1e-14 * slant);
        }
    }
    return out;
}

Camera Sized(Camera camera, int width, int height) {
    camera.width_px = width;
    camera.height_px = height;
    return camera;
}

// Expected: the same triangle wherever the centre is more than 1/256 pixel from an edge (vertices
// move by at most 1/512 pixel in x and in y), the exact plane's depth there.
void ExpectAgreement(const Scene& scene, const Camera& camera,
                     const RasterOptions& options = {}) {
    const Agreement a = Compare(scene, camera, options);
    const std::string name =
        scene.name + " " + camera.name + " " + std::string(NameOf(options.depth));
    EXPECT_EQ(a.wrong, 0) << name;
    EXPECT_LE(a.as_deep, options.depth == DepthFormat::kD32FReversed ? 0 : a.pixels / 1000)
        << name;
    EXPECT_LT(a.near_edge, a.pixels / 100) << name;
    EXPECT_GT(a.same, a.pixels / 3) << name;
    EXPECT_EQ(a.z_off, 0) << name;
    EXPECT_EQ(a.stored_off, 0) << name;
}

TEST(RasterAgainstTruth, SeesTheSameTriangles) {
    for (const Scene& scene :
         {CornellBox(), BoxOnPlane(), BallOverPlane(), TrenchScene(), Fence(), Atrium(0.5)}) {
        for (const Camera& camera : scene.cameras) {
            ExpectAgreement(scene, Sized(camera, 480, 270));
        }
    }
}

TEST(RasterAgainstTruth, StoresEveryFormatWithinItsRounding) {
    const Scene scene = BoxOnPlane();
    for (const DepthFormat format : {DepthFormat::kD16, DepthFormat::kD24, DepthFormat::kD32F,
                                     DepthFormat::kD32FReversed}) {
        for (const double far_m : {100.0, std::numeric_limits<double>::infinity()}) {
            RasterOptions options;
            options.depth = format;
            options.range = {0.1, far_m};
            ExpectAgreement(scene, Sized(scene.cameras[0], 300, 200), options);
        }
    }
}

// Floor, walls and ceiling of a hall in a few large triangles, from inside and near the floor:
// every surface reaches behind the camera and far beyond the picture.
TEST(RasterAgainstTruth, CutsWhatReachesBehindTheCamera) {
    Scene hall = BoxOnPlane();
    hall.mesh.vertices_m = {{-3, -500, 0}, {3, -500, 0}, {3, 900, 0}, {-3, 900, 0},
                            {-3, -500, 4}, {3, -500, 4}, {3, 900, 4}, {-3, 900, 4}};
    hall.mesh.quads = {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 3, 7, 4}, {1, 5, 6, 2}, {3, 2, 6, 7}};
    hall.material_of_face.assign(hall.mesh.quads.size(), 0);
    hall.name = "hall";
    for (const double height : {0.012, 1.7, 3.9}) {
        for (const double turn : {0.0, 0.9, 2.5}) {
            const Vec3 eye(0.4, 1, height);
            ExpectAgreement(hall, {.position_m = eye,
                                   .target_m = eye + Vec3(std::sin(turn), std::cos(turn), -0.1),
                                   .fov_rad = 1.4,
                                   .width_px = 320,
                                   .height_px = 200});
        }
    }
}

}  // namespace
}  // namespace plumb
