// The rasterizer's pixels against primary rays of truth/, which shares nothing with it but core/.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scenes/atrium.h"
#include "scenes/dense.h"
#include "scenes/simple.h"
#include "screen_space/draw_gbuffer.h"
#include "truth/embree_caster.h"
#include "truth/pixels.h"
#include "truth/triangle.h"

namespace plumb {
namespace {

struct Agreement {
    int pixels = 0;  // That both see as a surface or both as the sky, and that may be judged.
    int near_edge = 0;  // Differ, but within 1/256 pixel of an edge of one of the two.
    int as_deep = 0;    // Differ, but both are met within float rounding of the ray caster.
    int wrong = 0;
    double worst_z = 0;  // Of |z - z_truth| / (1e-6 (1 + slope)), same triangle.
};

// Distance in pixels of the centre of (i, j) from the nearest edge of the projected triangle;
// infinite for no triangle, 0 for one that reaches behind the camera.
double FromEdge(const Scene& scene, const Camera& camera, const View& view,
                std::uint32_t number, int i, int j) {
    if (number == GBuffer::kSky) return std::numeric_limits<double>::infinity();
    const CameraFrame frame(camera);
    std::array<Vec2, 3> p;
    const Triangle triangle = TriangleOf(scene.mesh, number);
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 v = triangle.corners_m[k] - camera.position_m;
        const Vec3 P(v.dot(frame.right), v.dot(frame.up), v.dot(frame.backward));
        if (P.z() > -0.01) return 0;
        p[k] = view.Project(P);
    }
    double nearest = std::numeric_limits<double>::infinity();
    const Vec2 c(i + 0.5, j + 0.5);
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2 a = p[k], ab = p[(k + 1) % 3] - a;
        const double along = std::clamp((c - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (c - a - along * ab).norm());
    }
    return nearest;
}

Agreement Compare(const Scene& scene, const Camera& camera, const RasterOptions& options = {}) {
    const EmbreeCaster caster(scene.mesh);
    const PixelGeometry truth = LookThrough(caster, scene, camera);
    const GBuffer drawn = DrawGBuffer(scene, camera, options);
    Agreement out;
    for (int j = 0; j < camera.height_px; ++j) {
        for (int i = 0; i < camera.width_px; ++i) {
            const std::uint32_t a = truth.triangle(i, j), b = drawn.triangle(i, j);
            const double z_truth = -double(truth.depth_m(i, j)), z = drawn.z_m(i, j);
            ++out.pixels;
            if (a == b) {
                if (a == GBuffer::kSky) continue;
                const Vec3 n = drawn.face_normal(i, j).cast<double>();
                const Vec3 w = drawn.view.Point(i + 0.5, j + 0.5, -1);
                // The caster's float ray and barycentrics are off by some 1e-7 of the distance
                // sideways: seen at a slant that is more depth.
                const double slant = w.norm() / std::abs(n.dot(w));
                out.worst_z =
                    std::max(out.worst_z, std::abs(z - z_truth) / (1e-6 * -z_truth * slant));
                continue;
            }
            const double edge = std::min(FromEdge(scene, camera, drawn.view, a, i, j),
                                         FromEdge(scene, camera, drawn.view, b, i, j));
            if (edge <= 1.0 / 256) {
                ++out.near_edge;
            } else if (std::abs(z - z_truth) <= 1e-5 * -z_truth) {
                ++out.as_deep;
            } else {
                ++out.wrong;
            }
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
// move by at most 1/512 pixel in x and in y).
TEST(RasterAgainstTruth, SeesTheSameTriangles) {
    for (const Scene& scene :
         {CornellBox(), BoxOnPlane(), BallOverPlane(), TrenchScene(), Fence(), Atrium(0.5)}) {
        for (const Camera& camera : scene.cameras) {
            const Agreement a = Compare(scene, Sized(camera, 480, 270));
            EXPECT_EQ(a.wrong, 0) << scene.name << " " << camera.name;
            EXPECT_EQ(a.as_deep, 0) << scene.name << " " << camera.name;
            EXPECT_LT(a.near_edge, a.pixels / 100) << scene.name << " " << camera.name;
        }
    }
}

}  // namespace
}  // namespace plumb
