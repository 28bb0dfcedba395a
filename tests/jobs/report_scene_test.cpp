// A scene's report end to end, on scenes small enough to know what it must say.
#include "jobs/screen_space/report_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "core/error.h"
#include "core/parallel.h"
#include "jobs/screen_space/report_folders.h"
#include "jobs/screen_space/score_technique.h"
#include "rays/embree/embree_caster.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "tests/jobs/made_scenes.h"
#include "tests/jobs/plain_scores.h"

namespace plumb {
namespace {

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
    return ReportScene({scene, {"a note"}, "digest"}, job,
                       {.version = "test", .command = "plumb report", .clock = Ticking()});
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
    EXPECT_EQ(json["views"][0]["pixels_seen"].get<int>(), report.views[0].seen);
    EXPECT_GT(report.views[0].seen, 96 * 54 / 2);
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
    // Three truths over four regions, of the view and of all views, and the line of heads.
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'),
              1 + 24 * std::ptrdiff_t(report.techniques.size()));
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
    job.cameras = {"back"};
    EXPECT_THROW(Made(scene, job), Error);
    job.cameras = {"front", "front"};
    EXPECT_THROW(Made(scene, job), Error);
    job = Brief();
    job.other_spp = 12;
    EXPECT_THROW(Made(scene, job), Error);
}

// The command line before the scene's file before the default; the truth's radius is none of the
// file's. Expected scores: of that technique made by hand.
TEST(ReportScene, PutsTheCommandLineBeforeTheFileBeforeTheDefault) {
    const Scene scene = FloorAndWall(64, 36);
    LoadedScene loaded{scene, {}, "digest"};
    loaded.techniques.push_back(
        {.name = "gtao-paper", .where = "techniques[0]", .values = {{"radius_m", "0.5"}}});
    SceneReportJob job = Brief();
    job.techniques = {"gtao-paper"};
    const auto report = [&](std::optional<double> radius_m) {
        job.radius_m = radius_m;
        return ReportScene(loaded, job,
                           {.version = "test", .command = "plumb report", .clock = Ticking()});
    };
    const EmbreeCaster caster(scene);
    const Camera& camera = scene.cameras.front();
    const GBuffer gbuffer = DrawGBuffer(scene, camera, {.guard_px = 8});
    const auto expected = [&](double truth_m, double technique_m) {
        const std::vector<Falloff> hard{Falloff::kHard};
        const ViewTruth truth = MeasureViewTruth(
            caster, scene, camera, hard, {.radius_m = truth_m, .spp = job.spp, .far = false});
        const Technique gtao = TechniqueNamed("gtao-paper", {.radius_m = technique_m});
        const Image<float> A =
            Shown(gtao.run({gbuffer, scene, camera, caster}, Ticking()).back().A, gbuffer.view);
        return PlainScore(A, truth.near.at(Falloff::kHard), SeenPixels(truth)).mse;
    };
    const auto mse = [](const SceneReport& r) {
        return r.techniques[0].Against(kTruthNear).error.mse.value;
    };
    EXPECT_NEAR(mse(report({})), expected(1.5, 0.5), 1e-9);
    EXPECT_NEAR(mse(report(1.0)), expected(1.0, 1.0), 1e-9);
    job.set = {{"gtao-paper", {{"radius_m", 0.75}}}};
    EXPECT_NEAR(mse(report(1.0)), expected(1.0, 0.75), 1e-9);
    job.set = {{"hbao", {{"radius_m", 0.75}}}};  // which does not run
    EXPECT_THROW(report(1.0), Error);
    job.set.clear();
    loaded.techniques.clear();
    EXPECT_NEAR(mse(report({})), expected(1.5, 1.5), 1e-9);
    // Else the two would say nothing.
    EXPECT_GT(std::abs(expected(1.5, 0.5) - expected(1.5, 1.5)), 1e-4);
}

TEST(ReportFolders, AreDistinctOrRefused) {
    using Paths = std::vector<std::filesystem::path>;
    const auto of = [](std::vector<std::string> scenes,
                       std::optional<std::filesystem::path> out) {
        return ReportFolders(scenes, out);
    };
    EXPECT_EQ(of({"atrium"}, {}), (Paths{"out/report-atrium"}));
    EXPECT_EQ(of({"make:atrium"}, {}), (Paths{"out/report-make-atrium"}));
    EXPECT_EQ(of({"a/hall.json"}, "there"), (Paths{"there"}));
    EXPECT_EQ(of({"a/hall.json", "b/yard.json"}, "there"), (Paths{"there/hall", "there/yard"}));
    EXPECT_EQ(of({"a/scene.json", "b/scene.json", "yard.json"}, {}),
              (Paths{"out/report-a-scene", "out/report-b-scene", "out/report-yard"}));
    try {
        of({"x/a/scene.json", "y/a/scene.json"}, "there");
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "scenes x/a/scene.json and y/a/scene.json would both be written to "
                     "there/a-scene: report them one by one, each with its own --out");
    }
    EXPECT_THROW(of({"atrium", "atrium"}, {}), Error);
}

}  // namespace
}  // namespace plumb
