#include "jobs/screen_space/report_scene.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.h"
#include "core/names.h"
#include "core/parallel.h"
#include "core/sobol.h"
#include "core/warp.h"
#include "io/data_uri.h"
#include "io/image_io.h"
#include "io/whole_file.h"
#include "jobs/pictures.h"
#include "jobs/screen_space/ao_sweep.h"
#include "jobs/screen_space/chosen_technique.h"
#include "jobs/screen_space/error_budget.h"
#include "jobs/screen_space/guard_study.h"
#include "jobs/screen_space/pyramid_study.h"
#include "jobs/screen_space/render_scene.h"
#include "jobs/screen_space/scene_views.h"
#include "jobs/screen_space/score_technique.h"
#include "jobs/screen_space/signed_picture.h"
#include "jobs/screen_space/time_techniques.h"
#include "rays/embree/embree_caster.h"
#include "rays/leave_surface.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/near_plane.h"
#include "screen_space/sao/sao_presets.h"

namespace plumb {
namespace {

// Bare occlusion rays a second: cosine-weighted from the view's own pixels, all threads.
Measured BareRaysPerSecond(const EmbreeCaster& caster, const Scene& scene,
                           const PixelGeometry& pixels, int rounds, const Clock& clock) {
    constexpr std::size_t kRays = 1 << 20;
    std::vector<Ray> rays(kRays);
    for (std::size_t k = 0; k < kRays; ++k) {
        const Receiver& receiver = pixels.receivers[k * pixels.receivers.size() / kRays];
        const Triangle triangle = TriangleOf(scene.mesh, receiver.triangle);
        const Vec3 n = receiver.Normal(triangle);
        rays[k] = LeaveSurface(triangle, receiver.b_1, receiver.b_2, n);
        rays[k].direction =
            Basis(n)
                .ToWorld(SampleCosineHemisphere(SobolOwenPair(std::uint32_t(k), 0, 1)))
                .cast<float>();
    }
    const EmbreeBareLoop loop(caster, rays);
    const auto cast = [&] {
        ParallelFor(std::int64_t(kRays), 4096, [&](std::int64_t begin, std::int64_t end) {
            loop.Any(std::size_t(begin), std::size_t(end));
        });
    };
    return TimeInTurns({{cast}}, rounds, clock).Rate(0, double(kRays));
}

constexpr int kLeastSpp = 16;  // Two points in each net of a truth.

// A page holds some thirty pictures: they are half this wide on it at most.
constexpr int kMostPictureColumns = 560;

std::vector<Falloff> FalloffsOf(const std::vector<Technique>& techniques,
                                const SaoOptions& budget) {
    std::set<Falloff> falloffs{Falloff::kHard, FalloffOf(budget.sampling.sao.falloff)};
    for (const Technique& technique : techniques) falloffs.insert(technique.falloff);
    return {falloffs.begin(), falloffs.end()};
}

std::vector<Camera> CamerasOf(const Scene& scene, const SceneReportJob& job) {
    std::vector<Camera> cameras;
    for (const std::string& name : job.cameras) cameras.push_back(CameraNamed(scene, name));
    if (job.cameras.empty()) {
        CameraNamed(scene, "");  // Says that there is none.
        cameras = scene.cameras;
    }
    for (std::size_t k = 0; k < cameras.size(); ++k) {
        Camera& camera = cameras[k];
        if (job.width_px != 0) camera.width_px = job.width_px;
        if (job.height_px != 0) camera.height_px = job.height_px;
        Validate(camera, scene.name + ": camera " + camera.name);
        for (std::size_t other = 0; other < k; ++other) {
            if (cameras[other].name == camera.name) {
                throw Error("camera = " + camera.name + ", given twice");
            }
        }
    }
    return cameras;
}

// Those whose passes are timed at the paper's sizes.
const std::string kTimedSao = "sao-supplement2012", kTimedAlchemy = "alchemy";

std::string BudgetTechnique(const SceneReportJob& job) {
    return job.budget == "alchemy" ? job.budget : "sao-" + job.budget;
}

int OtherSpp(const SceneReportJob& job) {
    return job.other_spp.value_or(std::max(kLeastSpp, job.spp / 4));
}

void AddStudies(const LoadedScene& loaded, const SceneReportJob& job,
                std::span<const ChosenTechnique> chosen, const SaoOptions& budget,
                const EmbreeCaster& caster, const MeasuredView& view, SceneReport& report,
                const RunContext& run) {
    const Scene& scene = loaded.scene;
    const Camera& camera = view.camera;
    const TechniqueInput in{view.gbuffer, scene, camera, caster};
    const BudgetOptions options{.stride_px = job.budget_stride_px,
                                .guard_px = view.summary.guard_px,
                                .rounds = job.rounds};
    ErrorBudget made = MakeErrorBudget(budget, scene, camera, caster, view.truth, options,
                                       run.clock, run.monitor);
    report.budget_technique = BudgetTechnique(job);
    report.budget_taps = options.many_taps;
    report.budget_pixels = made.pixels;
    report.budget = std::move(made.rows);
    report.no_border = std::move(made.no_border);
    report.pyramids = StudyPyramid(in, view.truth, budget);
    report.guards =
        StudyGuardBand(scene, camera, view.truth, budget, job.rounds, run.clock, run.monitor);
    Sweep sweep = SweepTechniques(in, view.truth, chosen, job.rounds, report.cheapest_within,
                                  run.clock, run.monitor);
    report.sweep = std::move(sweep.points);
    report.cheapest = std::move(sweep.cheapest);
    const auto sao = [&](const std::string& technique, const std::string& preset) {
        return NamedSao{
            preset, SaoWith(preset, Chosen(loaded, technique, job.radius_m, job.set).settings)};
    };
    const NamedSao saos[] = {sao(kTimedSao, "supplement2012"), sao(kTimedAlchemy, "alchemy")};
    report.times = TimePasses(scene, camera, caster, saos, job.sizes, job.rounds,
                              report.copy_bytes_per_second.value, run.clock, run.monitor);
    report.radii_width_px = job.radii_size.width_px;
    report.radii_height_px = job.radii_size.height_px;
    report.radii = TimeRadii(scene, camera, job.radii_size, job.rounds, run.clock, run.monitor);
    TemporalOptions temporal = job.flicker;
    temporal.radius_m = report.radius_m;
    temporal.seed = job.seed;
    report.temporal_frames = temporal.frames;
    report.temporal =
        StudyFlicker(scene, camera, caster, chosen, temporal, run.clock, run.monitor);
    report.precision = StudyZPrecision(scene, job.precision, run.monitor);
}

}  // namespace

void Validate(const SceneReportJob& job) {
    Validate(TechniqueSettings{.radius_m = job.radius_m.value_or(kReportRadiusM)});
    GuardPx(job.guard_px, 1);
    if (job.rounds < 1 || job.rounds > 1000) {
        throw Error(MustBe("rounds", job.rounds, "in [1, 1000]"));
    }
    Validate(ViewTruthOptions{.spp = job.spp});
    RequireSpp("other_spp", OtherSpp(job));
    FindNamed(
        SaoPresets(), [](const SaoPreset& preset) { return preset.name; }, job.budget,
        "budget = " + job.budget);
    for (const std::string& name : job.techniques) {
        TechniqueNamed(name);
        if (std::ranges::count(job.techniques, name) > 1) {
            throw Error("technique = " + name + ", given twice");
        }
    }
    if (!job.radius_m) return;
    for (const std::string& name : job.techniques.empty() ? TechniqueNames() : job.techniques) {
        RequireRadius(name, *job.radius_m);
    }
}

SceneReport ReportScene(const LoadedScene& loaded, const SceneReportJob& job,
                        const RunContext& run) {
    Validate(job);
    const Scene& scene = loaded.scene;
    const std::vector<Camera> cameras = CamerasOf(scene, job);
    std::vector<ChosenTechnique> chosen;
    std::vector<Technique> techniques;
    for (const std::string& name : job.techniques.empty() ? TechniqueNames() : job.techniques) {
        chosen.push_back(Chosen(loaded, name, job.radius_m, job.set));
        techniques.push_back(chosen.back().Made());
    }
    std::vector<std::string> running;
    for (const ChosenTechnique& one : chosen) running.push_back(one.name);
    if (job.studies)
        running.insert(running.end(), {BudgetTechnique(job), kTimedSao, kTimedAlchemy});
    CheckSetIsOf(job.set, running);
    const SaoOptions budget = SaoWith(
        job.budget, Chosen(loaded, BudgetTechnique(job), job.radius_m, job.set).settings);

    SceneReport report;
    report.tool_version = run.version;
    report.command = run.command;
    report.scene = scene.name;
    report.scene_sha256 = loaded.digest;
    report.threads = ThreadCount();
    report.rounds = job.rounds;
    report.seed = job.seed;
    report.radius_m = job.radius_m.value_or(kReportRadiusM);
    report.notes = loaded.notes;

    const EmbreeCaster caster(scene);
    report.triangles = caster.Counts().triangles;
    std::vector<MeasuredView> views;
    for (const Camera& camera : cameras) {
        const int spp = views.empty() ? job.spp : OtherSpp(job);
        views.push_back(MeasureView(scene, camera, GuardPx(job.guard_px, camera.height_px),
                                    caster, FalloffsOf(techniques, budget),
                                    {.radius_m = report.radius_m, .spp = spp, .seed = job.seed},
                                    run.clock, run.monitor));
    }
    const MeasuredView& first = views.front();
    const TruthImage& near = first.truth.near.at(Falloff::kHard);
    const auto picture = [&](const std::string& name, const auto& image) -> std::string {
        if (job.pictures.empty()) return {};
        WritePreview(job.pictures / (name + ".png"), image);
        const std::filesystem::path small = job.pictures / (name + "_small.png");
        WritePreview(small, Smaller(image, kMostPictureColumns));
        return PngDataUri(small);
    };
    for (const MeasuredView& view : views) report.views.push_back(view.summary);
    report.views.front().truth.picture_V = picture("truth_v", first.truth.V.value);
    report.views.front().truth.picture_near = picture("truth_near", near.value);
    report.embree_rays_per_second =
        BareRaysPerSecond(caster, scene, first.truth.pixels, job.rounds, run.clock);
    report.copy_bytes_per_second = CopyRate(job.rounds, run.clock);
    Rasterizer rasterizer;
    GBuffer again;
    const auto draw = [&] {
        DrawGBuffer(rasterizer, scene, first.camera,
                    SuitedTo(scene, first.camera, first.summary.guard_px), again);
    };
    report.raster_s = TimeInTurns({{draw}}, job.rounds, run.clock, run.monitor).Seconds(0);

    const TechniqueInput in{first.gbuffer, scene, first.camera, caster};
    std::vector<TechniqueTurn> turns;
    for (const Technique& technique : techniques) turns.push_back({&technique, &in});
    std::vector<TimedTechnique> timed =
        TimeTechniques(turns, job.rounds, run.clock, run.monitor);
    for (std::size_t t = 0; t < techniques.size(); ++t) {
        TechniqueScore score;
        score.name = techniques[t].name;
        score.falloff = NameOf(techniques[t].falloff);
        score.samples = techniques[t].samples;
        score.passes = timed[t].passes;
        score.seconds = timed[t].seconds;
        score.picture = picture(score.name, timed[t].A);
        score.signed_error = picture(score.name + "_error",
                                     SignedPicture(timed[t].A, near.value, first.regions.seen));
        report.techniques.push_back(std::move(score));
    }
    ViewBoard board(report.techniques);
    double done = 0;
    for (std::size_t v = 0; v < views.size(); ++v) {
        for (std::size_t t = 0; t < techniques.size(); ++t) {
            if (run.monitor.Cancelled()) throw Interrupted();
            Image<float> A = std::move(timed[t].A);
            if (v > 0) {
                A = Shown(
                    techniques[t]
                        .run({views[v].gbuffer, scene, views[v].camera, caster}, run.clock)
                        .back()
                        .A,
                    views[v].gbuffer.view);
            }
            board.Add(t, views[v], techniques[t].falloff, std::move(A));
            run.monitor.Progress("scores",
                                 ++done / double(views.size()) / double(techniques.size()));
        }
    }
    board.Finish(views, report);
    if (job.studies) {
        AddStudies(loaded, job, chosen, budget, caster, first, report, run);
    }
    return report;
}

std::filesystem::path WriteSceneReport(const std::filesystem::path& folder,
                                       const SceneReport& report) {
    WriteWholeFile(folder / "report.json", ToJsonText(report));
    WriteWholeFile(folder / "scores.csv", ScoresCsv(report));
    WriteWholeFile(folder / "sweep.csv", SweepCsv(report));
    const std::filesystem::path page = folder / "report.html";
    WriteWholeFile(page, ToHtml(report));
    return page;
}

}  // namespace plumb
