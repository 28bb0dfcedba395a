// Figures of the studies that are made again here, from the pictures that they are of.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/sobol.h"
#include "jobs/pictures.h"
#include "jobs/screen_space/find_closest.h"
#include "jobs/screen_space/layered_obscurance.h"
#include "jobs/screen_space/score_technique.h"
#include "rays/embree/embree_caster.h"
#include "score/errors.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/near_plane.h"
#include "screen_space/sao/rotation_hash.h"
#include "techniques/filter_knobs.h"
#include "techniques/ray_traced_visibility.h"
#include "tests/jobs/made_scenes.h"
#include "tests/jobs/plain_scores.h"
#include "tests/jobs/read_results.h"

namespace plumb {
namespace {

struct Seen {
    Scene scene;
    const Camera& camera;
    EmbreeCaster caster;
    ViewTruth truth;
    GBuffer gbuffer;
    Image<int> pixels;

    Seen(Scene made, int guard_px)
        : scene(std::move(made)),
          camera(scene.cameras.front()),
          caster(scene),
          truth(MeasureViewTruth(caster, scene, camera,
                                 std::vector{Falloff::kHard, Falloff::kSao},
                                 {.radius_m = 1, .spp = 64, .far = false})),
          gbuffer(DrawGBuffer(scene, camera, SuitedTo(scene, camera, guard_px))),
          pixels(SeenPixels(truth)) {}

    TechniqueInput In() const { return {gbuffer, scene, camera, caster}; }
    const TruthImage& Near() const { return truth.near.at(Falloff::kHard); }
};

// With a shipped border of 4 px and one of 14 px (a quarter of 54 px) in the first rows. Expected:
// their pictures made here, the pattern of taps held to the frame; few taps, so that the pattern tells.
TEST(ErrorBudgetFigures, ChangeTheBorderInTheStepOfThatName) {
    Scene scene = FloorAndWall(96, 54);
    // So near that the corner runs out of the frame on both sides.
    scene.cameras.front().position_m = {0.4, 0.1, 0.7};
    scene.cameras.front().target_m = {0, 1.5, 0.2};
    const Seen m(std::move(scene), 4);
    const SaoOptions shipped = SaoWith("supplement2012", {.radius_m = 1});
    const ResultTable budget =
        BudgetTable(shipped, m.scene, m.camera, m.caster, m.truth,
                    {.many_taps = 8, .stride_px = 1, .guard_px = 4, .rounds = 1}, Ticking());
    SaoOptions few = shipped;
    few.sampling.taps.samples = 8;
    few.sampling.taps.turns = 0;
    few.sampling.taps.phi = PhiArithmetic::kExact;
    few.sampling.taps.coarsest_level = 0;
    few.sampling.normals = NormalSource::kFace;
    few.quad_filter = few.pack_rgb8 = few.blur_x = few.blur_y = false;
    SaoOptions aligned = few;
    aligned.sampling.taps.hash_shift_px = 4 - 14;
    const GBuffer wide = DrawGBuffer(m.scene, m.camera, SuitedTo(m.scene, m.camera, 14));
    const Image<float> pictures[] = {
        LayeredObscurance({wide, m.scene, m.camera, m.caster}, aligned, {.stride_px = 1}),
        Shown(SaoObscurance(wide, aligned), wide.view),
        Shown(SaoObscurance(m.gbuffer, few), m.gbuffer.view)};
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(NumberAt(budget, k + 1, "mse"),
                    PlainScore(pictures[k], m.Near(), m.pixels).mse, 3e-4)
            << TextAt(budget, k + 1, "step");
        if (k == 0) continue;
        EXPECT_NEAR(NumberAt(budget, k + 1, "rms_change"),
                    PlainRms(pictures[k], pictures[k - 1], m.pixels), 1e-3)
            << TextAt(budget, k + 1, "step");
    }
    EXPECT_EQ(TextAt(budget, 3, "step"), "border");
    EXPECT_GT(NumberAt(budget, 3, "rms_change"), 0.01);  // Else the above says nothing.
}

// Line of sight against the floor and the wall of FloorAndWall, by hand: where it meets them, in depths.
std::vector<Vec3> Met(const Vec3& eye, const Vec3& w, double near, double far) {
    std::vector<Vec3> points;
    const double floor = -eye.z() / w.z(), wall = (1.5 - eye.y()) / w.y();
    for (const double t : {floor, wall}) {
        if (!(t >= near && t <= far)) continue;
        const Vec3 p = eye + t * w;
        const bool on_floor = t == floor && std::max(std::abs(p.x()), std::abs(p.y())) <= 4;
        const bool on_wall = t == wall && std::abs(p.x()) <= 3 && p.z() >= 0 && p.z() <= 0.8;
        if (on_floor || on_wall) points.push_back(p);
    }
    return points;
}

// Expected: the estimator's equation B with both planes met by hand. Tolerance: floats, and one
// pixel of a hundred where a tap grazes the end of the wall.
TEST(LayeredObscurance, IsTheEquationOverPlanesMetByHand) {
    const Seen m(FloorAndWall(96, 54), 16);
    SaoOptions options = SaoWith("supplement2012", {.radius_m = 1});
    options.sampling.taps.phi = PhiArithmetic::kExact;
    const SaoParams& sao = options.sampling.sao;
    const TapOptions& taps = options.sampling.taps;
    const Image<float> all = LayeredObscurance(m.In(), options, {.stride_px = 1});
    const Vec3 eye = m.camera.position_m;
    const Vec3 forward = (m.camera.target_m - eye).normalized();
    const Vec3 right = forward.cross(m.camera.up).normalized(), up = right.cross(forward);
    const double pixels_a_unit = 27 / std::tan(m.camera.fov_rad / 2);
    const auto direction = [&](double x_px, double y_px) {
        return Vec3(forward + (x_px - 48) / pixels_a_unit * right -
                    (y_px - 27) / pixels_a_unit * up);
    };
    int judged = 0, off = 0;
    for (int j = 0; j < 54; ++j) {
        for (int i = 0; i < 96; ++i) {
            if (m.pixels(i, j) == 0) continue;
            const double depth = -m.gbuffer.z_m(i + 16, j + 16);
            const Vec3 C = eye + depth * direction(i + 0.5, j + 0.5);
            const bool on_wall = m.gbuffer.triangle(i + 16, j + 16) >= 2;
            const Vec3 n = on_wall ? Vec3(0, -1, 0) : Vec3(0, 0, 1);
            const double disc_px = pixels_a_unit / depth;
            double sum = 0;
            for (int s = 0; s < taps.samples; ++s) {
                const UnitTap tap = TapOf(taps, s);
                const double theta =
                    TurnedAngle(tap.angle_rad, RotationHash(i + 16, j + 16, taps.hash),
                                PhiArithmetic::kExact);
                double most = 0;
                for (const Vec3& Q :
                     Met(eye,
                         direction(i + 0.5 + tap.alpha * disc_px * std::cos(theta),
                                   j + 0.5 + tap.alpha * disc_px * std::sin(theta)),
                         depth - 1, depth + 1)) {
                    const Vec3 v = Q - C;
                    const double v2 = v.dot(v);
                    const double f = std::pow(std::max(0.0, 1 - v2), 3) *
                                     std::max(0.0, v.dot(n) - sao.bias_m) /
                                     (v2 + sao.epsilon_m2);
                    most = std::max(most, f);
                }
                sum += most;
            }
            const double A = std::max(0.0, 1 - 5 * sao.intensity / taps.samples * sum);
            ++judged;
            off += std::abs(A - all(i, j)) > 1e-3;
        }
    }
    EXPECT_GT(judged, 2000);
    EXPECT_LE(off, judged / 100);
}

// Expected: rays within 4 taps of 2 px of the frame too, since the filter reads them.
TEST(RayTechniques, FilterOverTheFrame) {
    const Seen m(FloorAndWall(64, 36), 12);
    const Technique technique = TechniqueNamed("rays-2", {.radius_m = 1});
    const Image<float> A = Shown(technique.run(m.In(), Ticking()).back().A, m.gbuffer.view);
    Image<float> by_hand;
    RunFilter(m.gbuffer, CommonFilter(),
              RayTracedVisibility(m.caster, m.scene, m.camera, m.gbuffer,
                                  {.radius_m = 1, .rays = 2, .margin_px = 8}),
              [&](std::string_view, const Image<float>& a) { by_hand = a; });
    EXPECT_EQ(A.Pixels(), Shown(by_hand, m.gbuffer.view).Pixels());
}

// Expected: of the sum over the views, not of one. Errors of two pictures, of two views: 0.3 and 0.1,
// 0.1 and 0.15: mean squares of 0.05 and 0.016.
TEST(FindClosest, CountsEveryView) {
    const TruthImage truth{Image<float>(32, 32, 0.5f), Image<float>(32, 32, 0.0f)};
    const Mask all(32, 32, 1);
    const auto off = [&](float by) { return Image<float>(32, 32, 0.5f + by); };
    const std::vector<Contestant> contestants{{"a", {off(0.3f), off(0.1f)}},
                                              {"b", {off(0.1f), off(0.15f)}}};
    const std::vector<ComparedView> views{{&truth, &all}, {&truth, &all}};
    EXPECT_EQ(FindClosest(contestants, views).name, "b");
    const std::vector<Contestant> turned{{"a", {off(0.1f), off(0.3f)}},
                                         {"b", {off(0.15f), off(0.1f)}}};
    EXPECT_EQ(FindClosest(turned, views).name, "b");
}

// The settings of a sweep by their names.
class SweepByHand : public testing::Test {
  protected:
    Seen m{FloorAndWall(64, 36), 8};
    const std::vector<ChosenTechnique> chosen{{"sao-supplement2012", {.radius_m = 0.8}},
                                              {"rays-1", {.radius_m = 1}}};

    Image<float> PictureOf(const std::string& name, const std::string& setting) const {
        const ChosenTechnique& c = name == chosen[0].name ? chosen[0] : chosen[1];
        TechniqueSettings settings = c.settings;
        if (setting == "half the radius") settings.radius_m /= 2;
        if (setting == "twice the radius") settings.radius_m *= 2;
        if (setting == "no filter") settings.filter = false;
        if (setting.ends_with(" lookups")) settings.samples = std::stoi(setting);
        if (setting == "no pyramid") settings.knobs["pyramid"] = 0;
        if (setting == "no packing") settings.knobs["packing"] = 0;
        if (setting == "no quads") settings.knobs["quads"] = 0;
        Technique technique = TechniqueNamed(name, settings);
        if (setting != "half resolution") {
            return Shown(technique.run(m.In(), Ticking()).back().A, m.gbuffer.view);
        }
        Camera half = m.camera;
        half.width_px = 32;
        half.height_px = 18;
        const GBuffer g = DrawGBuffer(m.scene, half, SuitedTo(m.scene, half, 4));
        return Doubled(
            Shown(technique.run({g, m.scene, half, m.caster}, Ticking()).back().A, g.view), 64,
            36);
    }
};

// Expected: the error of every setting from its picture made here; of tolerances from none to a lot
// the cheapest by its definition; its ties: those of the front whose mean square error is not told
// apart from its own, pair by pair.
TEST_F(SweepByHand, HasTheErrorsTheCheapestAndItsTies) {
    const Mask seen = RegionsOf(m.truth).seen;
    std::vector<std::string> winners;
    std::size_t ties = 0;
    for (const double tolerance : {0.0, 0.05, 0.5, 3.0}) {
        const SweepResults sweep = SweepTable(m.In(), m.truth, chosen, 1, tolerance, Ticking());
        const ResultTable& points = sweep.points;
        ASSERT_EQ(points.rows.size(), 5u + 5 + 3 + 5);
        double least = 1;
        std::vector<Image<float>> pictures;
        for (std::size_t k = 0; k < points.rows.size(); ++k) {
            pictures.push_back(
                PictureOf(TextAt(points, k, "technique"), TextAt(points, k, "setting")));
            const double rmse = NumberAt(points, k, "rmse");
            EXPECT_NEAR(rmse * rmse, PlainScore(pictures[k], m.Near(), m.pixels).mse, 1e-6)
                << TextAt(points, k, "setting");
            least = std::min(least, rmse);
        }
        std::size_t cheapest = points.rows.size();
        const auto key = [&](std::size_t k) {
            return std::pair(std::round(1e6 * NumberAt(points, k, "ms")),
                             NumberAt(points, k, "rmse"));
        };
        for (std::size_t k = 0; k < points.rows.size(); ++k) {
            if (NumberAt(points, k, "rmse") > (1 + tolerance) * least) continue;
            if (cheapest == points.rows.size() || key(k) < key(cheapest)) cheapest = k;
        }
        const auto name = [&](std::size_t k) {
            return TextAt(points, k, "technique") + ", " + TextAt(points, k, "setting");
        };
        EXPECT_EQ(sweep.cheapest.name, name(cheapest)) << tolerance;
        winners.push_back(name(cheapest));
        std::vector<std::string> expected;
        for (std::size_t k = 0; k < points.rows.size(); ++k) {
            if (k == cheapest || TextAt(points, k, "pareto") != "yes") continue;
            const Measured difference =
                CompareMse(pictures[k], pictures[cheapest], m.Near().value,
                           m.Near().standard_error, seen, {.truth_dof = 7});
            if (difference.interval.low <= 0 && difference.interval.high >= 0) {
                expected.push_back(name(k));
            }
        }
        std::vector<std::string> told = sweep.cheapest.ties;
        std::ranges::sort(told);
        std::ranges::sort(expected);
        EXPECT_EQ(told, expected) << tolerance;
        ties += told.size();
    }
    EXPECT_NE(winners.front(), winners.back());  // Else the tolerance would say nothing.
    EXPECT_GT(ties, 0u);
}

// Expected: everything made here: cameras that look so many pixels aside, truths of a seed of their own,
// variances by plain loops.
TEST(StudyFlickerFigures, AreThoseOfTheFramesMadeByHand) {
    const Scene scene = FloorAndWall(64, 36);
    const EmbreeCaster caster(scene);
    const std::vector<ChosenTechnique> chosen{{"rays-2", {.radius_m = 1}},
                                              {"hbao", {.radius_m = 1}}};
    const TemporalOptions options{.frames = 4,
                                  .width_px = 64,
                                  .height_px = 36,
                                  .guard_px = 8,
                                  .spp = 16,
                                  .radius_m = 0.8,
                                  .seed = 3};
    const ResultTable flicker =
        FlickerTable(scene, scene.cameras.front(), caster, chosen, options, Ticking());
    const std::vector<Falloff> hard{Falloff::kHard};
    std::vector<TruthImage> truths;
    std::vector<std::vector<Image<float>>> pictures(2);
    Image<int> seen(64, 36, 1);
    for (int frame = 0; frame < 4; ++frame) {
        Camera camera = scene.cameras.front();
        const Vec3 forward = (camera.target_m - camera.position_m).normalized();
        const Vec3 right = forward.cross(camera.up).normalized(), up = right.cross(forward);
        const double a_pixel = std::tan(camera.fov_rad / 2) / 18;
        const Vec2 shift = SobolOwenPair(std::uint32_t(frame), 0, 3) - Vec2(0.5, 0.5);
        camera.target_m = camera.position_m + forward + shift.x() * a_pixel * right -
                          shift.y() * a_pixel * up;
        const ViewTruth truth = MeasureViewTruth(
            caster, scene, camera, hard,
            {.radius_m = 0.8, .spp = 16, .seed = std::uint64_t(4 + frame), .far = false});
        const Image<int> now = SeenPixels(truth);
        for (std::size_t p = 0; p < now.Pixels().size(); ++p) {
            seen.Pixels()[p] = seen.Pixels()[p] && now.Pixels()[p];
        }
        truths.push_back(truth.near.at(Falloff::kHard));
        const GBuffer g = DrawGBuffer(scene, camera, SuitedTo(scene, camera, 8));
        for (std::size_t t = 0; t < 2; ++t) {
            pictures[t].push_back(Shown(
                chosen[t].Made().run({g, scene, camera, caster}, Ticking()).back().A, g.view));
        }
    }
    const auto variance = [&](const auto& of_frame) {
        double mean = 0, squares = 0;
        for (std::size_t f = 0; f < 4; ++f) mean += of_frame(f) / 4;
        for (std::size_t f = 0; f < 4; ++f) squares += std::pow(of_frame(f) - mean, 2) / 3;
        return squares;
    };
    for (std::size_t t = 0; t < 2; ++t) {
        double candidate = 0, of_truth = 0, error = 0, n = 0;
        for (std::size_t p = 0; p < seen.Pixels().size(); ++p) {
            if (seen.Pixels()[p] == 0) continue;
            const auto c = [&](std::size_t f) { return double(pictures[t][f].Pixels()[p]); };
            const auto v = [&](std::size_t f) { return double(truths[f].value.Pixels()[p]); };
            double noise = 0;
            for (const TruthImage& truth : truths) {
                noise += std::pow(truth.standard_error.Pixels()[p], 2) / 4;
            }
            candidate += variance(c);
            of_truth += variance(v) - noise;
            error += variance([&](std::size_t f) { return c(f) - v(f); }) - noise;
            ++n;
        }
        ASSERT_GT(n, 1000);
        // The target is kept at its distance: other roundings, a tap here and there.
        EXPECT_NEAR(NumberAt(flicker, t, "candidate"), 1e6 * candidate / n,
                    0.02 * 1e6 * candidate / n);
        EXPECT_NEAR(NumberAt(flicker, t, "truth"), 1e6 * of_truth / n, 20);
        EXPECT_NEAR(NumberAt(flicker, t, "flicker"), 1e6 * error / n,
                    0.02 * 1e6 * error / n + 20);
    }
}

}  // namespace
}  // namespace plumb
