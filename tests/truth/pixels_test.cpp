// What pixels show and what lies near them, against closed forms.
#include "truth/pixels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "core/error.h"
#include "rays/embree/embree_caster.h"
#include "tests/truth/half_hidden_caster.h"
#include "tests/truth/shapes.h"
#include "tests/truth/significance.h"
#include "truth/near_visibility.h"
#include "truth/open_sky.h"

namespace plumb {
namespace {

// Level ground whose front is up, and a tilted board over it whose front faces away from the
// camera.
Scene GroundAndBoard() {
    Scene scene;
    AddSheet(scene.mesh, Steps(-10, 10, 20), Steps(-10, 10, 20),
             [](double x, double y) { return Vec3(x, y, 0); });
    AddQuad(scene.mesh, {-1, 1, 1}, {-1, 0, 2}, {1, 0, 2}, {1, 1, 1});
    scene.materials = {{.name = "ground", .albedo = {0.5f, 0.5f, 0.5f}},
                       {.name = "board", .albedo = {0.1f, 0.2f, 0.3f}}};
    scene.material_of_face.assign(scene.mesh.quads.size(), 0);
    scene.material_of_face.back() = 1;
    scene.cameras = {{.position_m = {0.3, -4, 2},
                      .target_m = {0, 0, 1},
                      .fov_rad = 1.2,
                      .width_px = 64,
                      .height_px = 48}};
    return scene;
}

// Expected: by hand for each pixel, from the two planes z = 0 and y + z = 2: the depth along
// w of truth/pixels.h is the ray's own t. Tolerance: float of numbers up to 30.
TEST(LookThrough, ShowsTwoPlanesWhereTheyAre) {
    const Scene scene = GroundAndBoard();
    const EmbreeCaster caster(scene.mesh);
    const Camera& camera = scene.cameras[0];
    const PixelGeometry pixels = LookThrough(caster, scene, camera);
    const CameraFrame frame(camera);
    int ground = 0, board = 0, sky = 0;
    for (int j = 0; j < camera.height_px; ++j) {
        for (int i = 0; i < camera.width_px; ++i) {
            const Vec3 w = frame.Direction(camera, i + 0.5, j + 0.5), o = camera.position_m;
            double t = std::numeric_limits<double>::infinity();
            Vec3 n(0, 0, 0);
            const double t_ground = -o.z() / w.z();
            const Vec3 p = o + t_ground * w;
            const double off_edge = 10 - p.head<2>().cwiseAbs().maxCoeff();
            if (t_ground > 0 && off_edge > 0) t = t_ground, n = {0, 0, 1};
            const double t_board = (2 - o.y() - o.z()) / (w.y() + w.z());
            const Vec3 q = o + t_board * w;
            const double inside = std::min(1 - std::abs(q.x()), 0.5 - std::abs(q.z() - 1.5));
            if (t_board > 0 && inside > 0 && t_board < t) {
                t = t_board;
                n = Vec3(0, 1, 1).normalized();
                if (n.dot(w) > 0) n = -n;
            }
            if (std::abs(inside) < 1e-3 || (t_ground > 0 && std::abs(off_edge) < 1e-2))
                continue;
            if (std::isinf(t)) {
                ++sky;
                EXPECT_EQ(pixels.depth_m(i, j), std::numeric_limits<float>::infinity());
                EXPECT_EQ(pixels.triangle(i, j), Hit::kNone);
                continue;
            }
            EXPECT_NEAR(pixels.depth_m(i, j), t, 1e-5 * t) << i << " " << j;
            const Vec3f local = pixels.normal(i, j);
            const Vec3 normal =
                local.x() * frame.right + local.y() * frame.up + local.z() * frame.backward;
            EXPECT_LT((normal - n).norm(), 1e-5) << i << " " << j;
            const bool is_board = std::abs(n.y()) > 0.1;
            EXPECT_EQ(pixels.albedo(i, j)[2], is_board ? 0.3f : 0.5f);
            (is_board ? board : ground) += 1;
        }
    }
    EXPECT_GT(ground, 500);
    EXPECT_GT(board, 100);
    EXPECT_GT(sky, 100);
    EXPECT_EQ(pixels.receivers.size(), pixels.pixel_of_receiver.size());
    EXPECT_GE(pixels.seen_from_behind, board);
}

// By hand: the camera looks straight down on a square whose texture has a red left and a blue
// right half (two texels: beyond their centres, at 1/4 and 3/4, the colours are pure only at
// the centres themselves), times the material's albedo.
TEST(LookThrough, AlbedoIsThatOfTheTextureThere) {
    Scene scene;
    AddQuad(scene.mesh, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
    scene.mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    scene.material_of_face = {0};
    scene.materials = {{.name = "m", .albedo = {0.5f, 1, 1}, .texture = 0}};
    Texture texture{.name = "", .albedo = Image<Rgb>(2, 1), .opacity = {}};
    texture.albedo(0, 0) = {1, 0, 0};
    texture.albedo(1, 0) = {0, 0, 1};
    scene.textures = {texture};
    scene.cameras = {{.position_m = {0, 0, 1},
                      .target_m = {0, 0, 0},
                      .up = {0, 1, 0},
                      .fov_rad = kPi / 2,
                      .width_px = 2,
                      .height_px = 2}};
    const EmbreeCaster caster(scene);
    const PixelGeometry pixels = LookThrough(caster, scene, scene.cameras[0]);
    EXPECT_NEAR(pixels.albedo(0, 0)[0], 0.5, 1e-5);
    EXPECT_NEAR(pixels.albedo(0, 0)[2], 0, 1e-5);
    EXPECT_NEAR(pixels.albedo(1, 1)[0], 0, 1e-5);
    EXPECT_NEAR(pixels.albedo(1, 1)[2], 1, 1e-5);
}

// Expected: a lone plane tilted by 60 degrees sees, of a sky that ends at the horizon, the
// cosine-weighted share (1 + cos 60) / 2 = 3/4 and the solid angle 2/3; the rest is counted.
TEST(OpenSky, EndsAtTheHorizonIfToldSo) {
    Mesh mesh;
    const double c = 0.5, s = std::sqrt(3) / 2;
    AddQuad(mesh, {-1, -c, -s}, {1, -c, -s}, {1, c, s}, {-1, c, s});
    const EmbreeCaster caster(mesh);
    const Receiver receiver{.triangle = 0};
    for (const auto& [weighting, exact] : {std::pair{HemisphereWeight::kCosine, 0.75},
                                           std::pair{HemisphereWeight::kUniform, 2.0 / 3}}) {
        const OpenCounts counts = CountOpenSky(caster, mesh, std::span(&receiver, 1),
                                               {.sampling = {.replicates = 16, .points = 1024},
                                                .weighting = weighting,
                                                .sky = Sky::kAbove});
        const Measured V = counts.Of(0);
        EXPECT_NEAR(V.value, exact, Sigmas(16) * V.standard_error);
        EXPECT_LT(V.standard_error, 1e-3);
        EXPECT_EQ(counts.lost.All(), std::int64_t(std::llround((1 - V.value) * 16 * 1024)));
    }
}

// Expected: of an endless wall at the distance x, with c = x / r and s = sqrt(1 - c^2), in the
// unit disk of (w_x, w_y), where d = x / w_x:
//   hard    1 - (acos c - c s) / pi
//   linear  the same + 2 c / pi (acosh(1 / c) - s)
//   others  1 - 2 / pi Int_c^1 (1 - g(c / u)) sqrt(1 - u^2) du, by Simpson's rule, with
//           1 - g(t) = (1 - t^2)^3 for SAO, 1 - t^2 for HBAO, and min(1, (1 - t) / 0.615) for
//           GTAO, which has a kink: Simpson's rule is off there by (1/20000)^2 at most.
TEST(NearVisibility, OfAWallIsKnownForEveryFalloff) {
    const double x = 1;
    Mesh mesh;
    AddQuad(mesh, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
    AddSheet(mesh, GrowingSteps(1, 100, 4), GrowingStepsUp(1, 100, 4),
             [&](double y, double z) { return Vec3(x, y, z); });
    const EmbreeCaster caster(mesh);
    const Receiver middle{.triangle = 0, .spread = false, .b_1 = 0.5, .b_2 = 0.5};
    for (const double reach : {0.5, 1.3, 2.5, 6.0}) {
        const double c = std::min(1.0, x / reach), s = std::sqrt((1 - c) * (1 + c));
        const double hard = 1 - (std::acos(c) - c * s) / kPi;
        const double linear = hard + 2 * c / kPi * (std::acosh(1 / c) - s);
        const auto simpson = [&](const std::function<double(double)>& occlusion) {
            double sum = 1;
            constexpr int kSteps = 20000;
            for (int k = 0; k <= kSteps; ++k) {
                const double u = c + (1 - c) * k / kSteps;
                const double weight = k == 0 || k == kSteps ? 1 : k % 2 == 1 ? 4 : 2;
                sum -= weight * (1 - c) / kSteps / 3 * 2 / kPi * occlusion(c / u) *
                       std::sqrt((1 - u) * (1 + u));
            }
            return sum;
        };
        const double sao = simpson([](double t) { return std::pow(1 - t * t, 3); });
        const double quadratic = simpson([](double t) { return 1 - t * t; });
        const double far_end = simpson([](double t) { return std::min(1.0, (1 - t) / 0.615); });
        for (const auto& [falloff, exact] :
             {std::pair{Falloff::kHard, hard}, std::pair{Falloff::kLinear, linear},
              std::pair{Falloff::kSao, sao}, std::pair{Falloff::kQuadratic, quadratic},
              std::pair{Falloff::kFarEnd, far_end}}) {
            const Measured measured =
                MeasureNear(caster, mesh, std::span(&middle, 1),
                            {.sampling = {.replicates = 32, .points = 1024},
                             .reach_m = reach,
                             .falloff = falloff})
                    .Of(0);
            EXPECT_NEAR(measured.value, exact, 1e-5 + Sigmas(32) * measured.standard_error)
                << reach << " " << int(falloff);
            EXPECT_LT(measured.standard_error, 1e-3);
        }
    }
}

// Expected: a hard edge asks what occlusion rays with a limit ask, in the same directions.
TEST(NearVisibility, HardIsTheVisibilityOfOcclusionRaysWithinReach) {
    const Scene scene = GroundAndBoard();
    const EmbreeCaster caster(scene.mesh);
    const PixelGeometry pixels = LookThrough(caster, scene, scene.cameras[0]);
    const NetSampling sampling{.replicates = 4, .points = 32};
    const NearSums near = MeasureNear(caster, scene.mesh, pixels.receivers,
                                      {.sampling = sampling, .reach_m = 1.5});
    const OpenCounts open = CountOpenSky(caster, scene.mesh, pixels.receivers,
                                         {.sampling = sampling, .reach_m = 1.5});
    int differ = 0;
    for (std::size_t i = 0; i < near.sum.size(); ++i) differ += near.sum[i] != open.open[i];
    // Rays of one receiver are cast in another way: a hit at the very end of the reach may
    // round to either side.
    EXPECT_LE(differ, int(near.sum.size() / 1000));
}

// Expected: several falloffs over one set of rays are what each is alone, to the bit.
TEST(NearVisibility, OfSeveralFalloffsIsThatOfEach) {
    const Scene scene = GroundAndBoard();
    const EmbreeCaster caster(scene.mesh);
    const PixelGeometry pixels = LookThrough(caster, scene, scene.cameras[0]);
    NearOptions options{.sampling = {.replicates = 2, .points = 8}, .reach_m = 1.5};
    const std::vector<Falloff> falloffs{Falloff::kFarEnd, Falloff::kHard, Falloff::kSao};
    const std::vector<NearSums> all =
        MeasureNearEach(caster, scene.mesh, pixels.receivers, options, falloffs);
    ASSERT_EQ(all.size(), 3u);
    EXPECT_NE(all[0].sum, all[1].sum);
    for (std::size_t k = 0; k < falloffs.size(); ++k) {
        options.falloff = falloffs[k];
        EXPECT_EQ(all[k].sum, MeasureNear(caster, scene.mesh, pixels.receivers, options).sum);
    }
}

TEST(NearVisibility, RefusesAReachThatIsNone) {
    EXPECT_THROW(Validate(NearOptions{.sampling = {}, .reach_m = 0}), Error);
    EXPECT_THROW(Validate(NearOptions{.sampling = {}, .reach_m = std::nan("")}), Error);
    EXPECT_THROW(Validate(NearOptions{.sampling = {}, .reach_m = 1.0 / 0.0}), Error);
}

}  // namespace
}  // namespace plumb
