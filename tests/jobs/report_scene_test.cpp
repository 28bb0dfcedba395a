// A scene's report end to end, on scenes small enough to know what it must say.
#include "jobs/screen_space/report_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "core/error.h"
#include "core/parallel.h"
#include "jobs/screen_space/ao_sweep.h"
#include "jobs/screen_space/error_budget.h"
#include "jobs/screen_space/guard_study.h"
#include "jobs/screen_space/pyramid_study.h"
#include "jobs/screen_space/score_technique.h"
#include "jobs/screen_space/temporal_study.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "tests/jobs/made_scenes.h"
#include "truth/embree_caster.h"

namespace plumb {
namespace {

// A clock that ticks: the same call takes the same time in every run.
PassClock Ticking() {
    auto now = std::make_shared<double>(0);
    return [now] { return *now += 0.001; };
}

SceneReportJob Brief() {
    SceneReportJob job;
    job.radius_m = 1;
    job.spp = 64;
    job.rounds = 1;
    job.studies = false;
    job.guard_px = 8;
    return job;
}

SceneReport Made(const Scene& scene, const SceneReportJob& job) {
    return ReportScene({scene, {"a note"}, "digest"}, job, "test", "plumb report", Ticking());
}

// Expected: more rays are nearer to the truth, and rays have no bias; a note of the scene is
// handed on; whatever the threads, the figures are the same.
TEST(ReportScene, ScoresEveryTechnique) {
    const Scene scene = FloorAndWall(96, 54);
    SetThreadCount(1);
    const SceneReport report = Made(scene, Brief());
    SetThreadCount(2);
    const SceneReport again = Made(scene, Brief());
    SetThreadCount(0);
    ASSERT_EQ(report.techniques.size(), TechniqueNames().size());
    const auto json = nlohmann::json::parse(ToJsonText(report));
    EXPECT_EQ(json["techniques"], nlohmann::json::parse(ToJsonText(again))["techniques"]);
    EXPECT_EQ(json["notes"][0], "a note");
    EXPECT_EQ(json["pixels_seen"].get<int>(), report.seen);
    EXPECT_GT(report.seen, 96 * 54 / 2);
    EXPECT_EQ(report.triangles, 4);

    const auto rmse = [&](const std::string& name) {
        const auto found =
            std::find_if(report.techniques.begin(), report.techniques.end(),
                         [&](const TechniqueScore& t) { return t.name == name; });
        return found->Against(kTruthNear).error;
    };
    EXPECT_LT(rmse("rays-8").rmse.value, rmse("rays-1").rmse.value);
    EXPECT_LT(std::abs(rmse("rays-8").bias.value), 0.01);
    const std::string csv = ScoresCsv(report);
    // Three truths over four regions, and the line of heads.
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'),
              1 + 12 * std::ptrdiff_t(report.techniques.size()));
    const std::string html = ToHtml(report);
    for (const std::string& name : TechniqueNames()) {
        EXPECT_NE(html.find(name), std::string::npos) << name;
    }
}

TEST(ReportScene, RefusesWhatCannotBeScored) {
    Scene scene = FloorAndWall(32, 18);
    scene.cameras.front().target_m = {0, -3, 100};
    scene.cameras.front().up = {0, 1, 0};
    EXPECT_THROW(Made(scene, Brief()), Error);  // Nothing but sky.
    scene = FloorAndWall(32, 18);
    SceneReportJob job = Brief();
    job.radius_m = 0;
    EXPECT_THROW(Made(scene, job), Error);
    job = Brief();
    job.spp = 60;
    EXPECT_THROW(Made(scene, job), Error);
    job = Brief();
    job.techniques = {"ssao"};
    EXPECT_THROW(Made(scene, job), Error);
    job = Brief();
    job.budget = "best";
    EXPECT_THROW(Made(scene, job), Error);
    job = Brief();
    job.camera = "back";
    EXPECT_THROW(Made(scene, job), Error);
}

// Expected: all steps of the preset in the order of design, over the pixels of every second row
// and column; the last step is the picture as shipped, so its score is that of the technique.
TEST(ErrorBudget, GoesFromTheIdealToTheShipped) {
    const Scene scene = FloorAndWall(96, 54);
    const Camera& camera = scene.cameras.front();
    const EmbreeCaster caster(scene);
    const SaoOptions shipped = SaoWith("supplement2012", {.radius_m = 1});
    const std::vector<Falloff> falloffs{Falloff::kHard, Falloff::kSao};
    const ViewTruth truth = MeasureViewTruth(caster, scene, camera, falloffs,
                                             {.radius_m = 1, .spp = 64, .far = false});
    const std::vector<BudgetRow> rows =
        MakeErrorBudget(shipped, scene, camera, caster, truth,
                        {.many_taps = 64, .stride_px = 1, .guard_px = 16}, Ticking());
    std::vector<std::string> steps;
    for (const BudgetRow& row : rows) steps.push_back(row.step);
    EXPECT_EQ(steps, (std::vector<std::string>{"ideal", "estimator", "one layer", "border",
                                               "normals", "taps", "pyramid", "quads", "RGB8",
                                               "filter x", "filter y", "no border"}));
    const GBuffer gbuffer = DrawGBuffer(scene, camera, {.guard_px = 16});
    const Image<float> A = Shown(SaoObscurance(gbuffer, shipped), gbuffer.view);
    const ScoreAgainst score = ScoreOver(A, truth.near.at(Falloff::kSao), kTruthWeighted,
                                         "whole", RegionsOf(truth).seen);
    EXPECT_EQ(rows[10].score.error.rmse.value, score.error.rmse.value);
    EXPECT_EQ(rows[10].pixels, CountOf(RegionsOf(truth).seen));
    EXPECT_GT(rows[5].rms_change, 0);
    EXPECT_GT(rows[8].rms_change, 0);
    EXPECT_LT(rows[8].rms_change, 1.5 / 255);  // RGB8 rounds A by 1/2 of 1/255, z's bits moved
}

// Expected: the widest border is itself; none is farthest from it; the first filter's row is A
// without a pyramid against itself.
TEST(Studies, OfBorderAndPyramidStartFromThemselves) {
    const Scene scene = FloorAndWall(96, 54);
    const Camera& camera = scene.cameras.front();
    const EmbreeCaster caster(scene);
    const SaoOptions sao = SaoWith("supplement2012", {.radius_m = 1});
    const std::vector<Falloff> falloffs{Falloff::kHard, Falloff::kSao};
    const ViewTruth truth = MeasureViewTruth(caster, scene, camera, falloffs,
                                             {.radius_m = 1, .spp = 64, .far = false});
    const std::vector<GuardRow> guards = StudyGuardBand(scene, camera, truth, sao, Ticking());
    ASSERT_EQ(guards.size(), 6u);
    EXPECT_EQ(guards.front().guard_px, 0);
    EXPECT_EQ(guards.back().rms_to_widest.value, 0);
    EXPECT_GT(guards.front().rms_to_widest.value, 0);
    const GBuffer gbuffer = DrawGBuffer(scene, camera, {.guard_px = 8});
    const std::vector<PyramidRow> pyramids =
        StudyPyramid({gbuffer, scene, camera, caster}, truth, sao);
    ASSERT_EQ(pyramids.size(), 7u);
    EXPECT_EQ(pyramids[0].rms_to_none.value, 0);
    // Of nearest and farthest depth, the nearest occludes more, so A is smaller.
    EXPECT_LT(pyramids[6].bias_to_none.value, pyramids[5].bias_to_none.value);
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
    const std::vector<GuardRow> rows = StudyGuardBand(scene, camera, truth, sao, Ticking());
    ASSERT_EQ(rows.size(), 6u);
    EXPECT_GT(rows[0].border.error.max, 0.02);  // There is something to change.
    for (const GuardRow& row : rows) {
        EXPECT_GT(row.border.error.pixels, 300);
        EXPECT_LT(row.rms_to_widest.value, 0.0013) << row.guard_px;
        EXPECT_EQ(row.share, row.guard_px / 108.0);
    }
}

TEST(SweepTechniques, MarksWhatNothingBeats) {
    const Scene scene = FloorAndWall(64, 36);
    const Camera& camera = scene.cameras.front();
    const EmbreeCaster caster(scene);
    const std::vector<Falloff> falloffs{Falloff::kHard};
    const ViewTruth truth = MeasureViewTruth(caster, scene, camera, falloffs,
                                             {.radius_m = 1, .spp = 64, .far = false});
    const GBuffer gbuffer = DrawGBuffer(scene, camera, {.guard_px = 8});
    const std::vector<SweepPoint> points =
        SweepTechniques({gbuffer, scene, camera, caster}, truth, {"sao-g3d10", "rays-8"},
                        {.radius_m = 1, .rounds = 1}, Ticking());
    EXPECT_EQ(points.size(), 18u);
    for (const SweepPoint& p : points) {
        const bool beaten = std::any_of(points.begin(), points.end(), [&](const SweepPoint& q) {
            return q.seconds < p.seconds && q.rmse < p.rmse;
        });
        EXPECT_FALSE(beaten && p.on_front) << p.technique << " " << p.setting;
    }
    EXPECT_TRUE(std::any_of(points.begin(), points.end(),
                            [](const SweepPoint& p) { return p.on_front; }));
}

// Expected: rays drawn alike in every frame of a still scene err by their noise, which the
// flicker sees; the truth's own variance is small where nothing but the camera moves.
TEST(StudyFlicker, SeesNoiseThatChangesFromFrameToFrame) {
    const Scene scene = FloorAndWall(64, 36);
    const EmbreeCaster caster(scene);
    const std::vector<TemporalRow> rows = StudyFlicker(
        scene, scene.cameras.front(), caster, {"rays-1", "rays-8"},
        {.frames = 4, .width_px = 64, .height_px = 36, .guard_px = 8, .spp = 64, .radius_m = 1},
        Ticking());
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_GT(rows[0].score.flicker.value, 0);
    EXPECT_THROW(StudyFlicker(scene, scene.cameras.front(), caster, {"rays-1"}, {.frames = 1},
                              Ticking()),
                 Error);
}

}  // namespace
}  // namespace plumb
