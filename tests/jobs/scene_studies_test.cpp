// The studies of a scene's report, each against what it must show or against the same made by hand.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.h"
#include "jobs/pictures.h"
#include "jobs/screen_space/ao_sweep.h"
#include "jobs/screen_space/error_budget.h"
#include "jobs/screen_space/find_closest.h"
#include "jobs/screen_space/guard_study.h"
#include "jobs/screen_space/layered_obscurance.h"
#include "jobs/screen_space/pyramid_study.h"
#include "jobs/screen_space/score_technique.h"
#include "jobs/screen_space/temporal_study.h"
#include "rays/embree/embree_caster.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "tests/jobs/made_scenes.h"
#include "tests/jobs/plain_scores.h"

namespace plumb {
namespace {

// A scene with its truth, all with a radius of 1 m.
struct Measured1m {
    Scene scene;
    EmbreeCaster caster;
    ViewTruth truth;
    Image<int> seen;

    explicit Measured1m(Scene made) : scene(std::move(made)), caster(scene) {
        const std::vector<Falloff> falloffs{Falloff::kHard, Falloff::kSao};
        truth = MeasureViewTruth(caster, scene, View(), falloffs,
                                 {.radius_m = 1, .spp = 64, .far = false});
        seen = SeenPixels(truth);
    }
    const Camera& View() const { return scene.cameras.front(); }
    const TruthImage& Near() const { return truth.near.at(Falloff::kHard); }
    const TruthImage& Weighted() const { return truth.near.at(Falloff::kSao); }
};

// Expected: the noise of a truth of 16 rays taken off, that of 4096 rays has no error against it but
// what noise leaves, for V and within r; a floor of .0026 under the variances would show.
TEST(ViewTruth, LeavesNoErrorOfItsNoise) {
    const Scene scene = FloorAndWall(96, 54);
    const EmbreeCaster caster(scene);
    const std::vector<Falloff> falloffs{Falloff::kHard, Falloff::kSao};
    const auto truth = [&](int spp, std::uint64_t seed) {
        return MeasureViewTruth(caster, scene, scene.cameras.front(), falloffs,
                                {.radius_m = 1, .spp = spp, .seed = seed});
    };
    const ViewTruth coarse = truth(16, 1), fine = truth(4096, 2);
    const Mask seen = RegionsOf(coarse).seen;
    const auto expect = [&](const TruthImage& candidate, const TruthImage& of) {
        const Measured mse = ScoreErrors(candidate.value, of.value, of.standard_error, seen,
                                         {.truth_dof = kTruthNets - 1.0})
                                 .mse;
        EXPECT_LT(mse.noise_error, 3e-4);
        EXPECT_LT(std::abs(mse.value), 4 * mse.noise_error);
    };
    expect(fine.V, coarse.V);
    for (const Falloff falloff : falloffs) {
        expect(fine.near.at(falloff), coarse.near.at(falloff));
    }
}

// Expected of every row: A made here by the same functions, scored by plain loops. 1e-6: sums of
// floats in another order; 3e-4: the pass in float against the one in double.
TEST(ErrorBudget, GoesFromTheIdealToTheShipped) {
    const Measured1m m(FloorAndWall(96, 54));
    const SaoOptions shipped = SaoWith("supplement2012", {.radius_m = 1});
    const ErrorBudget budget = MakeErrorBudget(
        shipped, m.scene, m.View(), m.caster, m.truth,
        {.many_taps = 64, .stride_px = 2, .guard_px = 16, .rounds = 1}, Ticking());
    const std::vector<BudgetRow>& rows = budget.rows;
    std::vector<std::string> steps;
    for (const BudgetRow& row : rows) steps.push_back(row.step);
    ASSERT_EQ(steps, (std::vector<std::string>{"ideal", "estimator", "one layer", "border",
                                               "normals", "taps", "pyramid", "quads", "RGB8",
                                               "filter x", "filter y"}));
    const Image<int> pixels = Strided(m.seen, 2);
    const auto drawn = [&](int guard_px) {
        return DrawGBuffer(m.scene, m.View(), {.guard_px = guard_px});
    };
    const GBuffer wide = drawn(16), none = drawn(0);  // A quarter of 54 px is less than 16.
    std::vector<Image<float>> pictures{m.Weighted().value};
    SaoOptions many = shipped;
    many.sampling.taps.samples = 64;
    many.sampling.taps.turns = 0;
    many.sampling.taps.phi = PhiArithmetic::kExact;
    many.sampling.taps.coarsest_level = 0;
    many.quad_filter = many.pack_rgb8 = many.blur_x = many.blur_y = false;
    SaoOptions face = many;
    face.sampling.normals = NormalSource::kFace;
    Image<float> layered =
        LayeredObscurance({wide, m.scene, m.View(), m.caster}, face, {.stride_px = 2});
    for (float& a : layered.Pixels()) a = std::isnan(a) ? 0.0f : a;  // None is counted.
    pictures.push_back(layered);
    const auto sao = [&](const GBuffer& gbuffer, const SaoOptions& options) {
        return Shown(SaoObscurance(gbuffer, options), gbuffer.view);
    };
    pictures.push_back(sao(wide, face));
    pictures.push_back(sao(wide, face));
    pictures.push_back(sao(wide, many));
    SaoOptions now = shipped;
    now.sampling.taps.coarsest_level = 0;
    now.quad_filter = now.pack_rgb8 = now.blur_x = now.blur_y = false;
    pictures.push_back(sao(wide, now));
    now.sampling.taps.coarsest_level = shipped.sampling.taps.coarsest_level;
    pictures.push_back(sao(wide, now));
    for (bool SaoOptions::*pass : {&SaoOptions::quad_filter, &SaoOptions::pack_rgb8,
                                   &SaoOptions::blur_x, &SaoOptions::blur_y}) {
        now.*pass = true;
        pictures.push_back(sao(wide, now));
    }
    ASSERT_EQ(pictures.size(), rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const double tolerance = k >= 2 && k <= 5 ? 3e-4 : 1e-6;
        const TruthImage near{m.Near().value,
                              k == 0 ? Image<float>() : m.Near().standard_error};
        const PlainErrors plain = PlainScore(pictures[k], near, pixels);
        EXPECT_NEAR(rows[k].score.error.mse.value, plain.mse, tolerance) << steps[k];
        EXPECT_NEAR(rows[k].score.error.bias.value, plain.bias, tolerance) << steps[k];
        EXPECT_NEAR(rows[k].weighted.error.mse.value,
                    PlainScore(pictures[k], m.Weighted(), pixels).mse, tolerance)
            << steps[k];
        EXPECT_EQ(rows[k].score.error.pixels, budget.pixels);
        EXPECT_EQ(rows[k].seconds.has_value(), k >= 5) << steps[k];
        if (k == 0) continue;
        EXPECT_NEAR(rows[k].rms_change, PlainRms(pictures[k], pictures[k - 1], pixels),
                    k <= 5 ? 1e-3 : 1e-6)
            << steps[k];
    }
    EXPECT_EQ(double(budget.pixels), PlainScore(pictures[0], m.Near(), pixels).pixels);
    EXPECT_LT(rows[8].rms_change, 1.5 / 255);  // RGB8 rounds A by 1/2 of 1/255, z's bits moved
    SaoOptions aligned = shipped;
    aligned.sampling.taps.hash_shift_px = 16;
    const Image<float> borderless = sao(none, aligned);
    EXPECT_NEAR(budget.no_border.score.error.mse.value,
                PlainScore(borderless, m.Near(), pixels).mse, 1e-6);
    EXPECT_NEAR(budget.no_border.rms_change, PlainRms(borderless, pictures.back(), pixels),
                1e-6);
    EXPECT_NEAR(budget.no_border.seconds->value, 0.001, 1e-9);
}

// Expected: on every pixel the steps lead to the very score of the technique, whole numbers of bits.
TEST(ErrorBudget, EndsAtTheTechniquesOwnScore) {
    const Measured1m m(FloorAndWall(48, 27));
    const SaoOptions shipped = SaoWith("supplement2012", {.radius_m = 1});
    const ErrorBudget budget = MakeErrorBudget(
        shipped, m.scene, m.View(), m.caster, m.truth,
        {.many_taps = 8, .stride_px = 1, .guard_px = 16, .rounds = 1}, Ticking());
    const GBuffer gbuffer = DrawGBuffer(m.scene, m.View(), {.guard_px = 16});
    const Technique technique = TechniqueNamed("sao-supplement2012", {.radius_m = 1});
    const Image<float> A =
        Shown(technique.run({gbuffer, m.scene, m.View(), m.caster}, Ticking()).back().A,
              gbuffer.view);
    const std::vector<ScoreAgainst> scores =
        ScoreAll(A, m.truth, RegionsOf(m.truth), technique.falloff);
    const ScoreAgainst& near = Against(scores, kTruthNear, "whole");
    EXPECT_EQ(budget.rows.back().score.error.rmse.value, near.error.rmse.value);
    EXPECT_EQ(budget.rows.back().score.recalibrated_rmse.value, near.recalibrated_rmse.value);
    EXPECT_EQ(budget.rows.back().weighted.error.rmse.value,
              Against(scores, kTruthWeighted, "whole").error.rmse.value);
    EXPECT_EQ(budget.pixels, near.error.pixels);
}

// Expected: five widths more than none, each by whole texels of the pyramid's coarsest level (32 px)
// or, without one, whole quads, near a twentieth of the height.
TEST(StudyGuardBand, WidensByWholeTexels) {
    SaoOptions sao = SaoWith("supplement2012", {.radius_m = 1});
    EXPECT_EQ(GuardWidths(540, sao), (std::vector<int>{0, 32, 64, 96, 128, 160}));
    EXPECT_EQ(GuardWidths(1600, sao), (std::vector<int>{0, 96, 192, 288, 384, 480}));
    EXPECT_EQ(GuardWidths(54, sao), (std::vector<int>{0, 32, 64, 96, 128, 160}));
    sao.sampling.taps.coarsest_level = 0;
    EXPECT_EQ(GuardWidths(540, sao), (std::vector<int>{0, 28, 56, 84, 112, 140}));
    EXPECT_EQ(GuardWidths(20, sao), (std::vector<int>{0, 2, 4, 6, 8, 10}));
}

// Expected: a floor with its wall that lies whole within the frame, with sky around it, so
// that no tap meets anything beyond the frame: the border changes nothing. A is kept in 255 steps on
// the way, and rounding moves a tap of a hundred: less than 0.004 / sqrt(10).
TEST(StudyGuardBand, ChangesNothingWhereNothingIsBeyondTheFrame) {
    Scene scene = FloorAndWall(192, 108);
    scene.cameras.front().position_m = {0.5, -8.5, 5};
    scene.cameras.front().target_m = {0, 0, 0};
    const Camera& camera = scene.cameras.front();
    const EmbreeCaster caster(scene);
    const std::vector<Falloff> falloffs{Falloff::kHard, Falloff::kSao};
    const ViewTruth truth = MeasureViewTruth(caster, scene, camera, falloffs,
                                             {.radius_m = 1, .spp = 16, .far = false});
    const SaoOptions sao = SaoWith("supplement2012", {.radius_m = 1});
    const std::vector<GuardRow> rows = StudyGuardBand(scene, camera, truth, sao, 1, Ticking());
    ASSERT_EQ(rows.size(), 6u);
    EXPECT_GT(rows[0].border.error.max, 0.02);  // There is something to change.
    for (const GuardRow& row : rows) {
        EXPECT_GT(row.border.error.pixels, 300);
        EXPECT_LT(row.rms_to_widest.value, 0.0013) << row.guard_px;
        EXPECT_EQ(row.share, row.guard_px / 108.0);
    }
}

// Expected: each row's picture made here, against the widest and against the truth by plain loops;
// the widest is itself.
TEST(StudyGuardBand, IsThePictureOfEachBorder) {
    const Measured1m m(FloorAndWall(96, 80));
    const SaoOptions sao = SaoWith("supplement2012", {.radius_m = 1});
    const std::vector<GuardRow> rows =
        StudyGuardBand(m.scene, m.View(), m.truth, sao, 3, Ticking());
    ASSERT_EQ(rows.size(), 6u);
    const Image<int> border = SeenAtBorder(m.truth);
    const auto picture = [&](int guard_px) {
        const GBuffer gbuffer = DrawGBuffer(m.scene, m.View(), {.guard_px = guard_px});
        SaoOptions shifted = sao;
        shifted.sampling.taps.hash_shift_px = 160 - guard_px;
        return Shown(SaoObscurance(gbuffer, shifted), gbuffer.view);
    };
    const Image<float> widest = picture(160);
    for (int k = 0; k < 6; ++k) {
        const GuardRow& row = rows[std::size_t(k)];
        ASSERT_EQ(row.guard_px, 32 * k);
        const Image<float> A = picture(row.guard_px);
        EXPECT_NEAR(row.rms_to_widest.value, PlainRms(A, widest, border), 1e-6);
        const PlainErrors plain = PlainScore(A, m.Weighted(), border);
        EXPECT_NEAR(row.border.error.mse.value, plain.mse, 1e-6);
        EXPECT_EQ(double(row.border.error.pixels), plain.pixels);
        EXPECT_NEAR(row.draw_s.value, 0.001, 1e-9);
        EXPECT_NEAR(row.sao_s.value, 0.001, 1e-9);
    }
    EXPECT_EQ(rows.back().rms_to_widest.value, 0);
    EXPECT_GT(rows.front().rms_to_widest.value, 0.005);
}

// Expected: each row's picture made here; the first is itself without a pyramid. Of nearest and
// farthest depth the nearest occludes more, so that A is smaller.
TEST(StudyPyramid, IsThePictureOfEachFilter) {
    const Measured1m m(FloorAndWall(96, 54));
    SaoOptions sao = SaoWith("supplement2012", {.radius_m = 1});
    const GBuffer gbuffer = DrawGBuffer(m.scene, m.View(), {.guard_px = 8});
    const std::vector<PyramidRow> rows =
        StudyPyramid({gbuffer, m.scene, m.View(), m.caster}, m.truth, sao);
    ASSERT_EQ(rows.size(), 7u);
    const std::vector<std::pair<std::string, ZFilter>> filters{
        {"rotated grid", ZFilter::kRotatedGrid},
        {"rotated grid, G3D 10", ZFilter::kRotatedGridG3d10},
        {"arithmetic mean", ZFilter::kMean},
        {"harmonic mean", ZFilter::kHarmonicMean},
        {"min (farthest)", ZFilter::kMin},
        {"max (nearest)", ZFilter::kMax}};
    sao.quad_filter = sao.pack_rgb8 = sao.blur_x = sao.blur_y = false;
    SaoOptions without = sao;
    without.sampling.taps.coarsest_level = 0;
    const Image<float> none = Shown(SaoObscurance(gbuffer, without), gbuffer.view);
    for (std::size_t k = 0; k < 7; ++k) {
        if (k > 0) sao.sampling.taps.filter = filters[k - 1].second;
        const Image<float> A = k == 0 ? none : Shown(SaoObscurance(gbuffer, sao), gbuffer.view);
        EXPECT_EQ(rows[k].filter, k == 0 ? "none" : filters[k - 1].first);
        EXPECT_NEAR(rows[k].rms_to_none.value, PlainRms(A, none, m.seen), 1e-6);
        EXPECT_NEAR(rows[k].bias_to_none.value, PlainScore(A, {none, {}}, m.seen).bias, 1e-6);
        EXPECT_NEAR(rows[k].against_truth.error.mse.value,
                    PlainScore(A, m.Weighted(), m.seen).mse, 1e-6);
    }
    EXPECT_EQ(rows[0].rms_to_none.value, 0);
    EXPECT_LT(rows[6].bias_to_none.value, rows[5].bias_to_none.value);
}

// Expected: points with the settings they name, made here; the front and the cheapest by comparing
// each with each.
TEST(SweepTechniques, ScoresTheSettingsThatItNames) {
    const Measured1m m(FloorAndWall(64, 36));
    const GBuffer gbuffer = DrawGBuffer(m.scene, m.View(), {.guard_px = 8});
    const TechniqueInput in{gbuffer, m.scene, m.View(), m.caster};
    const std::vector<ChosenTechnique> chosen{{"sao-g3d10", {.radius_m = 0.8}},
                                              {"rays-8", {.radius_m = 1}}};
    const Sweep sweep = SweepTechniques(in, m.truth, chosen, 2, 0.05, Ticking());
    const std::vector<SweepPoint>& points = sweep.points;
    ASSERT_EQ(points.size(), 18u);
    const auto at = [&](const std::string& technique, const std::string& setting) {
        return *std::ranges::find_if(points, [&](const SweepPoint& p) {
            return p.technique == technique && p.setting == setting;
        });
    };
    const auto mse = [&](const Technique& technique, const TechniqueInput& on) {
        Image<float> A = Shown(technique.run(on, Ticking()).back().A, on.gbuffer.view);
        if (on.gbuffer.view.width_px == 32) A = Doubled(A, 64, 36);
        return PlainScore(A, m.Near(), m.seen).mse;
    };
    const auto expect = [&](const std::string& name, const std::string& setting,
                            const TechniqueSettings& settings) {
        const double rmse = at(name, setting).rmse.value;
        EXPECT_NEAR(rmse * rmse, mse(TechniqueNamed(name, settings), in), 1e-6) << setting;
    };
    expect("sao-g3d10", "as shipped", {.radius_m = 0.8});
    expect("sao-g3d10", "half the radius", {.radius_m = 0.4});
    expect("sao-g3d10", "twice the radius", {.radius_m = 1.6});
    expect("sao-g3d10", "no filter", {.radius_m = 0.8, .filter = false});
    expect("sao-g3d10", "16 lookups", {.radius_m = 0.8, .samples = 16});
    expect("rays-8", "twice the radius", {.radius_m = 2});
    SaoOptions options = SaoWith("g3d10", {.radius_m = 0.8});
    options.sampling.taps.coarsest_level = 0;
    const double no_pyramid = at("sao-g3d10", "no pyramid").rmse.value;
    EXPECT_NEAR(no_pyramid * no_pyramid, mse(SaoTechnique("t", options), in), 1e-6);
    options = SaoWith("g3d10", {.radius_m = 0.8});
    options.quad_filter = true;
    const double with_quads = at("sao-g3d10", "with quads").rmse.value;
    EXPECT_NEAR(with_quads * with_quads, mse(SaoTechnique("t", options), in), 1e-6);
    Camera half = m.View();
    half.width_px = 32;
    half.height_px = 18;
    const GBuffer small = DrawGBuffer(m.scene, half, {.guard_px = 4});
    const double halved = at("rays-8", "half resolution").rmse.value;
    EXPECT_NEAR(
        halved * halved,
        mse(TechniqueNamed("rays-8", {.radius_m = 1}), {small, m.scene, half, m.caster}), 1e-6);

    double least = 1;
    for (const SweepPoint& p : points) least = std::min(least, p.rmse.value);
    std::string cheapest;
    double cheapest_s = 1e9, cheapest_rmse = 1;
    for (const SweepPoint& p : points) {
        const bool beaten = std::any_of(points.begin(), points.end(), [&](const SweepPoint& q) {
            return q.seconds.value < p.seconds.value && q.rmse.value < p.rmse.value;
        });
        EXPECT_FALSE(beaten && p.on_front) << p.technique << " " << p.setting;
        EXPECT_LE(p.rmse.interval.low, p.rmse.value);
        EXPECT_GE(p.rmse.interval.high, p.rmse.value);
        EXPECT_TRUE(std::isfinite(p.rmse.interval.high));
        EXPECT_TRUE(std::isfinite(p.recalibrated_rmse.interval.high));
        if (p.rmse.value > 1.05 * least) continue;
        if (p.seconds.value > cheapest_s + 1e-9) continue;
        if (p.seconds.value > cheapest_s - 1e-9 && p.rmse.value >= cheapest_rmse) continue;
        cheapest_s = p.seconds.value;
        cheapest_rmse = p.rmse.value;
        cheapest = p.technique + ", " + p.setting;
    }
    EXPECT_EQ(sweep.cheapest.name, cheapest);
    EXPECT_TRUE(std::any_of(points.begin(), points.end(),
                            [](const SweepPoint& p) { return p.on_front; }));
}

std::vector<ChosenTechnique> With1m(const std::vector<std::string>& names) {
    std::vector<ChosenTechnique> chosen;
    for (const std::string& name : names) chosen.push_back({name, {.radius_m = 1}});
    return chosen;
}

// Expected: rays drawn anew in every frame err by their noise, whose variance falls as 1 / rays;
// nets fall faster. What the truth does is the same for every technique.
TEST(StudyFlicker, SeesNoiseThatChangesFromFrameToFrame) {
    const Scene scene = FloorAndWall(64, 36);
    const EmbreeCaster caster(scene);
    const TemporalOptions options{
        .frames = 6, .width_px = 64, .height_px = 36, .guard_px = 8, .spp = 64, .radius_m = 1};
    const std::vector<TemporalRow> rows = StudyFlicker(
        scene, scene.cameras.front(), caster, With1m({"rays-1", "rays-8"}), options, Ticking());
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].technique, "rays-1");
    EXPECT_EQ(rows[0].score.truth.value, rows[1].score.truth.value);
    EXPECT_GT(rows[0].score.flicker.value, 4 * rows[1].score.flicker.value);
    EXPECT_GT(rows[0].score.candidate.value, rows[1].score.candidate.value);
    EXPECT_THROW(StudyFlicker(scene, scene.cameras.front(), caster, With1m({"rays-1"}),
                              {.frames = 1}, Ticking()),
                 Error);
}

// Expected: a floor alone is open whatever the camera does: no variance of anything; and its
// edges, where floor turns to sky, are no pixels that count.
TEST(StudyFlicker, IsNothingWhereNothingOccludes) {
    Scene scene;
    scene.materials.push_back({});
    AddFace(scene, {Vec3f(-4, -4, 0), Vec3f(4, -4, 0), Vec3f(4, 4, 0), Vec3f(-4, 4, 0)});
    scene.cameras = FloorAndWall(64, 36).cameras;
    const EmbreeCaster caster(scene);
    const std::vector<TemporalRow> rows = StudyFlicker(
        scene, scene.cameras.front(), caster, With1m({"sao-supplement2012", "rays-2"}),
        {.frames = 3, .width_px = 64, .height_px = 36, .guard_px = 8, .spp = 16, .radius_m = 1},
        Ticking());
    for (const TemporalRow& row : rows) {
        EXPECT_LT(row.score.candidate.value, 1e-10) << row.technique;  // What bytes round.
        EXPECT_EQ(row.score.truth.value, 0);
        EXPECT_LT(row.score.flicker.value, 1e-10);
    }
}

// Pictures with errors of +-0.1, +-0.1 and +-0.3 at random. Of one view: the two alike are a tie, the
// third is not. Of three views, each twice as dark as the last: the same, because shares are compared.
TEST(FindClosest, NamesTheWinnerAndItsTies) {
    const int n = 64;
    const Mask all(n, n, 1);
    TruthImage truth{Image<float>(n, n, 0.5f), Image<float>(n, n, 0.0f)};
    std::uint32_t state = 1;
    const auto noisy = [&](float size) {
        Image<float> picture(n, n);
        for (float& p : picture.Pixels()) {
            state = state * 1664525u + 1013904223u;
            p = 0.5f + size * (float(state >> 8) / float(1 << 23) - 1);
        }
        return picture;
    };
    for (const int views : {1, 3}) {
        std::vector<Contestant> contestants{{"worst", {}}, {"a", {}}, {"b", {}}};
        std::vector<ComparedView> compared;
        for (int v = 0; v < views; ++v) {
            const float size = 0.05f * float(1 << v);
            contestants[0].pictures.push_back(noisy(3 * size));
            contestants[1].pictures.push_back(noisy(size));
            // Now better, now worse: neither of the two is ahead everywhere.
            contestants[2].pictures.push_back(noisy(views == 1 ? size
                                                    : v == 1   ? 0.9f * size
                                                               : 1.1f * size));
            compared.push_back({&truth, &all});
        }
        const Closest closest = FindClosest(contestants, compared);
        EXPECT_NE(closest.name, "worst") << views;
        EXPECT_EQ(closest.ties, std::vector<std::string>{closest.name == "a" ? "b" : "a"})
            << views;
        EXPECT_EQ(TiesOf(0, contestants, compared), std::vector<std::string>{}) << views;
    }
}

}  // namespace
}  // namespace plumb
