// A scene's report end to end, on scenes small enough to know what it must say.
#include "jobs/screen_space/report_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/error.h"
#include "core/parallel.h"
#include "jobs/screen_space/report_folders.h"
#include "jobs/screen_space/score_technique.h"
#include "rays/embree/embree_caster.h"
#include "reports/render.h"
#include "reports/sentence.h"
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

doc::Document Made(const Scene& scene, const SceneReportJob& job) {
    return ReportScene({scene, {"a *note*"}, std::string(64, 'd')}, job,
                       {.version = "test", .command = "plumb report", .clock = Ticking()});
}

// The row of the table of all scores.
std::size_t RowOf(const doc::Table& scores, const std::string& technique,
                  const std::string& view, const std::string& truth,
                  const std::string& region) {
    for (std::size_t row = 0; row < scores.rows.size(); ++row) {
        const auto is = [&](const char* key, const std::string& text) {
            return std::get<std::string>(scores.At(row, key)) == text;
        };
        if (is("technique", technique) && is("view", view) && is("truth", truth) &&
            is("region", region)) {
            return row;
        }
    }
    throw std::runtime_error(technique + " " + view + " " + truth + " " + region);
}

double Value(const doc::Document& report, const std::string& technique, const char* key) {
    const doc::Table& scores = doc::TableOf(report, "scores");
    return doc::NumberOf(
        scores.At(RowOf(scores, technique, "all views", kTruthNear, "whole"), key));
}

// Expected: more rays are nearer to the truth, and rays have no bias; a note of the scene is
// handed on; whatever the threads, all but the times is the same.
TEST(ReportScene, ScoresEveryTechnique) {
    const Scene scene = FloorAndWall(96, 54);
    SetThreadCount(1);
    const doc::Document report = Made(scene, Brief());
    SetThreadCount(2);
    const doc::Document again = Made(scene, Brief());
    SetThreadCount(0);
    EXPECT_EQ(doc::ToJsonText(doc::WithoutTimes(report)),
              doc::ToJsonText(doc::WithoutTimes(again)));
    EXPECT_EQ(doc::TableOf(report, "techniques").rows.size(), TechniqueNames().size());
    const std::vector<std::string>& says = report.sections.front().sentences;
    EXPECT_EQ(doc::PlainText(says.back()), "a *note*");
    const double seen = doc::NumberOf(doc::TableOf(report, "views").At(0, "pixels_seen"));
    EXPECT_GT(seen, 96 * 54 / 2);
    EXPECT_EQ(seen, Value(report, "rays-8", "pixels"));
    EXPECT_EQ(doc::NumberOf(doc::FactOf(report, "triangles")), 4);

    EXPECT_LT(Value(report, "rays-8", "rmse"), Value(report, "rays-1", "rmse"));
    EXPECT_LT(std::abs(Value(report, "rays-8", "bias")), 0.01);
    // Three truths over four regions, of the view and of all views.
    EXPECT_EQ(doc::TableOf(report, "scores").rows.size(), 24 * TechniqueNames().size());
    const std::string html = doc::ToHtml(report);
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
    const auto mse = [](const doc::Document& r) { return Value(r, "gtao-paper", "mse"); };
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
