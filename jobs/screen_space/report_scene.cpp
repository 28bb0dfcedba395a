#include "jobs/screen_space/report_scene.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.h"
#include "core/parallel.h"
#include "core/sobol.h"
#include "core/warp.h"
#include "io/data_uri.h"
#include "io/image_io.h"
#include "io/whole_file.h"
#include "jobs/pictures.h"
#include "jobs/screen_space/ao_sweep.h"
#include "jobs/screen_space/ao_times.h"
#include "jobs/screen_space/error_budget.h"
#include "jobs/screen_space/guard_study.h"
#include "jobs/screen_space/pyramid_study.h"
#include "jobs/screen_space/render_scene.h"
#include "jobs/screen_space/score_technique.h"
#include "jobs/screen_space/signed_picture.h"
#include "jobs/screen_space/temporal_study.h"
#include "jobs/screen_space/z_precision.h"
#include "score/pareto.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/sao/sao_presets.h"
#include "truth/embree_caster.h"
#include "truth/leave_surface.h"

namespace plumb {
namespace {

double RmsError(const TruthImage& truth, const Mask& mask) {
    double squares = 0, n = 0;
    for (std::size_t p = 0; p < mask.Pixels().size(); ++p) {
        if (mask.Pixels()[p] == 0) continue;
        const double error = truth.standard_error.Pixels()[p];
        squares += error * error;
        ++n;
    }
    return n > 0 ? std::sqrt(squares / n) : 0;
}

// Bare occlusion rays a second: cosine-weighted from the view's own pixels, all threads.
double BareRaysPerSecond(const EmbreeCaster& caster, const Scene& scene,
                         const PixelGeometry& pixels, int rounds, const PassClock& clock) {
    constexpr std::size_t kRays = 1 << 20;
    if (pixels.receivers.empty()) return 0;
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
    std::vector<double> seconds;
    for (int round = 0; round <= rounds; ++round) {
        const double begin_s = clock();
        ParallelFor(std::int64_t(kRays), 4096, [&](std::int64_t begin, std::int64_t end) {
            loop.Any(std::size_t(begin), std::size_t(end));
        });
        if (round > 0) seconds.push_back(clock() - begin_s);
    }
    std::sort(seconds.begin(), seconds.end());
    return double(kRays) / seconds[seconds.size() / 2];
}

// A page holds some thirty pictures: they are half this wide on it at most.
constexpr int kMostPictureColumns = 560;

std::vector<Falloff> FalloffsOf(const std::vector<Technique>& techniques,
                                const SaoOptions& budget) {
    std::set<Falloff> falloffs{Falloff::kHard, FalloffOf(budget.sampling.sao.falloff)};
    for (const Technique& technique : techniques) falloffs.insert(technique.falloff);
    return {falloffs.begin(), falloffs.end()};
}

}  // namespace

void Validate(const SceneReportJob& job) {
    Validate(TechniqueSettings{.radius_m = job.radius_m});
    GuardPx(job.guard_px, 1);
    if (job.rounds < 1 || job.rounds > 1000) {
        throw Error(MustBe("rounds", job.rounds, "in [1, 1000]"));
    }
    SaoPresetNamed(job.budget);
    for (const std::string& name : job.techniques) TechniqueNamed(name);
}

SceneReport ReportScene(const LoadedScene& loaded, const SceneReportJob& job,
                        const std::string& tool_version, const std::string& command,
                        const PassClock& clock, Monitor& monitor) {
    Validate(job);
    const Scene& scene = loaded.scene;
    Camera camera = CameraNamed(scene, job.camera);
    if (job.width_px != 0) camera.width_px = job.width_px;
    if (job.height_px != 0) camera.height_px = job.height_px;
    Validate(camera, scene.name + ": camera " + camera.name);
    const int guard_px = GuardPx(job.guard_px, camera.height_px);
    const std::vector<std::string> names =
        job.techniques.empty() ? TechniqueNames() : job.techniques;
    std::vector<Technique> techniques;
    for (const std::string& name : names) {
        techniques.push_back(
            TechniqueNamed(name, SettingsOf(loaded, name, {.radius_m = job.radius_m})));
    }
    const SaoOptions budget = SaoWith(job.budget, {.radius_m = job.radius_m});

    SceneReport report;
    report.tool_version = tool_version;
    report.command = command;
    report.scene = scene.name;
    report.scene_sha256 = loaded.digest;
    report.camera = camera.name;
    report.width_px = camera.width_px;
    report.height_px = camera.height_px;
    report.guard_px = guard_px;
    report.threads = ThreadCount();
    report.seed = job.seed;
    report.radius_m = job.radius_m;
    report.notes = loaded.notes;
    report.pixels = std::int64_t(camera.width_px) * camera.height_px;

    const EmbreeCaster caster(scene);
    report.triangles = caster.Counts().triangles;
    const double truth_begin_s = clock();
    const ViewTruth truth =
        MeasureViewTruth(caster, scene, camera, FalloffsOf(techniques, budget),
                         {.radius_m = job.radius_m, .spp = job.spp, .seed = job.seed}, monitor);
    const Regions regions = RegionsOf(truth);
    report.seen = CountOf(regions.seen);
    if (report.seen == 0) {
        throw Error(scene.name + ": camera " + camera.name +
                    " sees no surface: there is nothing to score");
    }
    const TruthImage& near = truth.near.at(Falloff::kHard);
    report.truth = {.spp = job.spp,
                    .nets = kTruthNets,
                    .seconds = clock() - truth_begin_s,
                    .rms_error_V = RmsError(truth.V, regions.seen),
                    .rms_error_near = RmsError(near, regions.seen),
                    .lost = truth.lost.All(),
                    .picture_V = {},
                    .picture_near = {}};
    const auto picture = [&](const std::string& name, const auto& image) -> std::string {
        if (job.pictures.empty()) return {};
        WritePreview(job.pictures / (name + ".png"), image);
        const std::filesystem::path small = job.pictures / (name + "_small.png");
        WritePreview(small, Smaller(image, kMostPictureColumns));
        return PngDataUri(small);
    };
    report.truth.picture_V = picture("truth_v", truth.V.value);
    report.truth.picture_near = picture("truth_near", near.value);
    report.embree_rays_per_second =
        BareRaysPerSecond(caster, scene, truth.pixels, job.rounds, clock);
    report.copy_bytes_per_second = CopyBytesPerSecond(job.rounds, clock);

    const RasterOptions raster{.guard_px = guard_px};
    Rasterizer rasterizer;
    GBuffer gbuffer;
    std::vector<double> raster_s;
    for (int round = 0; round <= job.rounds; ++round) {
        const double begin_s = clock();
        DrawGBuffer(rasterizer, scene, camera, raster, gbuffer);
        if (round > 0) raster_s.push_back(clock() - begin_s);  // The first warms up.
    }
    std::sort(raster_s.begin(), raster_s.end());
    report.raster_s = raster_s[raster_s.size() / 2];
    const TechniqueInput in{gbuffer, scene, camera, caster};

    for (std::size_t t = 0; t < techniques.size(); ++t) {
        const std::vector<Pass> passes = Timed(techniques[t], in, job.rounds, clock);
        TechniqueScore score;
        score.name = techniques[t].name;
        score.falloff = NameOf(techniques[t].falloff);
        score.samples = techniques[t].samples;
        for (const Pass& pass : passes) score.passes.push_back({pass.name, pass.seconds});
        score.seconds = TotalSeconds(passes);
        const Image<float> A = Shown(passes.back().A, gbuffer.view);
        score.scores = ScoreAll(A, truth, regions, techniques[t].falloff);
        score.picture = picture(score.name, A);
        score.signed_error =
            picture(score.name + "_error", SignedPicture(A, near.value, regions.seen));
        report.techniques.push_back(std::move(score));
        if (monitor.Cancelled()) throw Interrupted();
        monitor.Progress("techniques", double(t + 1) / double(techniques.size()));
    }
    if (!job.studies) return report;

    report.budget_technique = "sao-" + job.budget;
    report.budget = MakeErrorBudget(budget, scene, camera, caster, truth,
                                    {.guard_px = guard_px}, clock, monitor);
    report.pyramids = StudyPyramid(in, truth, budget);
    report.guards = StudyGuardBand(scene, camera, truth, budget, clock);
    report.sweep =
        SweepTechniques(in, truth, names, {.radius_m = job.radius_m}, clock, monitor);
    std::vector<TimedError> points;
    for (const SweepPoint& p : report.sweep) {
        points.push_back({p.technique + ", " + p.setting, p.seconds, p.rmse});
    }
    report.cheapest = points[CheapestWithin(points, report.cheapest_within)].name;
    report.times = TimePasses(scene, camera, caster, job.radius_m, job.rounds,
                              report.copy_bytes_per_second, clock, monitor);
    report.radii = TimeRadii(scene, camera, {1920, 1080, 192}, job.rounds, clock, monitor);
    const TemporalOptions temporal{.radius_m = job.radius_m, .seed = job.seed};
    report.temporal_frames = temporal.frames;
    report.temporal = StudyFlicker(scene, camera, caster, names, temporal, clock, monitor);
    report.precision = StudyZPrecision(scene, {}, monitor);
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
