// GTAO and the cosine bitmask against ray-traced V, on a surface that the eye sees whole:
// there one layer of depth is all there is, and what is left is the pixels' size.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/statistics.h"
#include "rays/embree/embree_caster.h"
#include "screen_space/horizon/gtao.h"
#include "screen_space/horizon/visibility_bitmask.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "tests/screen_space/flat_scenes.h"
#include "truth/near_visibility.h"
#include "truth/pixels.h"

namespace plumb {
namespace {

/// Bumps and hollows 0.3 m high over [-1, 1]^2, of 48 x 48 quads; no slope hides another part
/// from the eye, 4 m above.
Scene Bumps() {
    constexpr int kQuads = 48;
    Mesh mesh;
    for (int j = 0; j <= kQuads; ++j) {
        for (int i = 0; i <= kQuads; ++i) {
            const double x = 2.0 * i / kQuads - 1, y = 2.0 * j / kQuads - 1;
            const double z = 0.15 * std::cos(5.5 * x + 0.4) * std::cos(4.3 * y - 0.7);
            mesh.vertices_m.push_back(Vec3(x, y, z).cast<float>());
        }
    }
    for (std::uint32_t j = 0; j < kQuads; ++j) {
        for (std::uint32_t i = 0; i < kQuads; ++i) {
            const std::uint32_t a = j * (kQuads + 1) + i;
            mesh.quads.push_back({a, a + 1, a + kQuads + 2, a + kQuads + 1});
        }
    }
    return GreyScene(std::move(mesh));
}

Camera FromAbove(int side_px) {
    return {.position_m = {0, 0, 4},
            .target_m = {0, 0, 0},
            .up = {0, 1, 0},
            .fov_rad = 2 * std::atan(0.3),
            .width_px = side_px,
            .height_px = side_px};
}

struct Errors {
    Moments gtao, mask, occlusion;
    double noise = 0;  ///< Root mean square of the truth's standard errors.
};

Errors ErrorsAt(int side_px) {
    const Scene scene = Bumps();
    const Camera camera = FromAbove(side_px);
    const EmbreeCaster caster(scene);
    const PixelGeometry pixels = LookThrough(caster, scene, camera);
    const GBuffer g = DrawGBuffer(scene, camera);
    // Each receiver of a lattice of 15 x 15 pixels.
    std::vector<Receiver> receivers;
    std::vector<std::pair<int, int>> at;
    for (std::size_t k = 0; k < pixels.receivers.size(); ++k) {
        const int x = int(pixels.pixel_of_receiver[k]) % side_px;
        const int y = int(pixels.pixel_of_receiver[k]) / side_px;
        const int step = side_px / 15;
        if (x % step != step / 2 || y % step != step / 2) continue;
        if (g.triangle(x, y) != pixels.triangle(x, y)) continue;  // On an edge, just so.
        receivers.push_back(pixels.receivers[k]);
        at.push_back({x, y});
    }
    const NearSums sums = MeasureNear(caster, scene.mesh, receivers,
                                      {.sampling = {.points = 512}, .reach_m = 100});
    const SliceSampling s{.radius_m = 4,
                          .slices = 64,
                          .steps = 2048,
                          .step_power = 1,
                          .spread = SliceSpread::kLineOfSight,
                          .jitter = false};
    const GtaoOptions gtao{.sampling = s, .falloff_start = 1};
    const BitmaskOptions mask{.sampling = s,
                              .thickness_m = std::numeric_limits<double>::infinity(),
                              .sectors = 64,
                              .measure = SectorMeasure::kCosine,
                              .rounding = SectorRounding::kRound};
    Errors errors;
    double noise2 = 0;
    for (std::size_t k = 0; k < receivers.size(); ++k) {
        const Measured V = sums.Of(std::int64_t(k));
        const auto [x, y] = at[k];
        errors.gtao.Add(GtaoOfPixel(g, gtao, x, y) - V.value);
        errors.mask.Add(VisibilityBitmaskOfPixel(g, mask, x, y) - V.value);
        errors.occlusion.Add(1 - V.value);
        noise2 += V.standard_error * V.standard_error / double(receivers.size());
    }
    errors.noise = std::sqrt(noise2);
    return errors;
}

// Expected: V. Tolerance: over a pixel of p m the surface turns by at most curvature p = 0.15
// 5.5^2 p; by so much the horizon of what lies next to the receiver is misjudged, where the
// cosine weight is as small: (4.5 p)^2 a pixel. The truth's own errors add, as squares; kRound
// errs by at most half a sector of 64 at both ends.
TEST(PeersAgainstTruth, TendToVAsPixelsShrink) {
    for (const int side : {121, 241}) {
        const Errors e = ErrorsAt(side);
        const double p = 2.4 / side, tolerance = std::pow(0.15 * 5.5 * 5.5 * p, 2);
        ASSERT_GT(e.gtao.Count(), 100);
        EXPECT_GT(e.occlusion.Mean(), 0.05);
        EXPECT_NEAR(e.gtao.Mean(), 0, tolerance);
        EXPECT_LT(std::sqrt(e.gtao.Variance()), std::hypot(tolerance, e.noise));
        EXPECT_NEAR(e.mask.Mean(), 0, tolerance + 1.0 / 64);
        EXPECT_LT(std::sqrt(e.mask.Variance()), std::hypot(tolerance, e.noise) + 1.0 / 64);
    }
}

}  // namespace
}  // namespace plumb
