#include "jobs/screen_space/report_scene.h"

#include <algorithm>
#include <functional>
#include <set>

#include "core/error.h"
#include "core/names.h"
#include "core/parallel.h"
#include "core/sobol.h"
#include "core/warp.h"
#include "io/data_uri.h"
#include "io/image_io.h"
#include "io/whole_file.h"
#include "jobs/bench_facts.h"
#include "jobs/memory_copy.h"
#include "jobs/pictures.h"
#include "jobs/screen_space/ao_sweep.h"
#include "jobs/screen_space/chosen_technique.h"
#include "jobs/screen_space/error_budget.h"
#include "jobs/screen_space/guard_study.h"
#include "jobs/screen_space/pyramid_study.h"
#include "jobs/screen_space/render_scene.h"
#include "jobs/screen_space/scene_sections.h"
#include "jobs/screen_space/signed_picture.h"
#include "jobs/write_document.h"
#include "rays/embree/embree_caster.h"
#include "rays/leave_surface.h"
#include "reports/text.h"
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

constexpr double kCheapestWithin = 0.05;

// The sections of all studies; the fastest setting is a finding.
void AddStudies(const LoadedScene& loaded, const SceneReportJob& job,
                std::span<const ChosenTechnique> chosen, const ChosenTechnique& budget,
                const EmbreeCaster& caster, const MeasuredView& view,
                double copy_bytes_per_second, std::vector<doc::Section>& sections,
                const RunContext& run) {
    const Scene& scene = loaded.scene;
    const Camera& camera = view.camera;
    const TechniqueInput in{view.gbuffer, scene, camera, caster};
    const SaoOptions sao = SaoOptionsOf(budget);
    sections.push_back(MakeErrorBudget(
        budget.name, sao, scene, camera, caster, view.truth,
        {.stride_px = job.budget_stride_px, .guard_px = view.guard_px, .rounds = job.rounds},
        run));
    sections.back().sections = {
        StudyPyramid(in, view.truth, sao),
        StudyGuardBand(scene, camera, view.truth, sao, job.rounds, run)};
    Sweep sweep = SweepTechniques(in, view.truth, chosen, job.rounds, kCheapestWithin, run);
    const auto finding = [&](std::string key, std::string title, std::string text) {
        sections.front().facts.push_back(
            {{.key = std::move(key), .title = std::move(title), .role = doc::Role::kTime},
             std::move(text)});
    };
    finding("cheapest",
            "Fastest setting within " + Digits(100 * kCheapestWithin, 2) +
                " % of the least error of the sweep",
            sweep.cheapest.name);
    if (!sweep.cheapest.ties.empty()) {
        finding("cheapest_ties", "Not told apart from it", Listed(sweep.cheapest.ties));
    }
    sections.push_back(std::move(sweep.section));
    const ChosenTechnique timed[] = {Chosen(loaded, kTimedSao, job.radius_m, job.set),
                                     Chosen(loaded, kTimedAlchemy, job.radius_m, job.set)};
    sections.push_back(TimePasses(scene, camera, caster, timed, job.sizes, job.rounds,
                                  copy_bytes_per_second, run));
    sections.back().sections = {TimeRadii(scene, camera, job.radii_size, job.rounds, run)};
    TemporalOptions flicker = job.flicker;
    flicker.radius_m = job.radius_m.value_or(kReportRadiusM);
    flicker.seed = job.seed;
    doc::Section flickering = StudyFlicker(scene, camera, caster, chosen, flicker, run);
    sections.push_back(StudyZPrecision(scene, job.precision, run.monitor));
    sections.push_back(std::move(flickering));
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

doc::Document ReportScene(const LoadedScene& loaded, const SceneReportJob& job,
                          const RunContext& run) {
    Validate(job);
    const Scene& scene = loaded.scene;
    const std::vector<Camera> cameras = CamerasOf(scene, job);
    std::vector<ChosenTechnique> chosen;
    std::vector<Technique> techniques;
    std::vector<std::string> running;
    for (const std::string& name : job.techniques.empty() ? TechniqueNames() : job.techniques) {
        chosen.push_back(Chosen(loaded, name, job.radius_m, job.set));
        techniques.push_back(chosen.back().Made());
        running.push_back(name);
    }
    if (job.studies)
        running.insert(running.end(), {BudgetTechnique(job), kTimedSao, kTimedAlchemy});
    CheckSetIsOf(job.set, running);
    const ChosenTechnique budget = Chosen(loaded, BudgetTechnique(job), job.radius_m, job.set);
    const double radius_m = job.radius_m.value_or(kReportRadiusM);

    const EmbreeCaster caster(scene);
    std::vector<MeasuredView> views;
    for (const Camera& camera : cameras) {
        const int spp = views.empty() ? job.spp : OtherSpp(job);
        views.push_back(MeasureView(scene, camera, GuardPx(job.guard_px, camera.height_px),
                                    caster, FalloffsOf(techniques, SaoOptionsOf(budget)),
                                    {.radius_m = radius_m, .spp = spp, .seed = job.seed}, run));
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
    doc::Section truth = TruthSection(views, radius_m);
    if (!job.pictures.empty()) {
        truth.pictures = {{picture("truth_v", first.truth.V.value), "V", "V"},
                          {picture("truth_near", near.value), "V within r",
                           "V within r = " + Digits(radius_m) + " m"}};
    }
    const Measured rays_per_second =
        BareRaysPerSecond(caster, scene, first.truth.pixels, job.rounds, run.clock);
    MemoryCopy copy(kLargeCopyBytes);
    const Measured copy_bytes_per_second =
        TimeInTurns({{std::ref(copy)}}, job.rounds, run.clock).Rate(0, copy.Bytes());
    Rasterizer rasterizer;
    GBuffer again;
    const auto draw = [&] {
        DrawGBuffer(rasterizer, scene, first.camera,
                    SuitedTo(scene, first.camera, first.guard_px), again);
    };
    const Measured raster_s =
        TimeInTurns({{draw}}, job.rounds, run.clock, run.monitor).Seconds(0);

    const TechniqueInput in{first.gbuffer, scene, first.camera, caster};
    std::vector<TechniqueTurn> turns;
    for (const Technique& technique : techniques) turns.push_back({&technique, &in});
    std::vector<TimedTechnique> timed =
        TimeTechniques(turns, job.rounds, run.clock, run.monitor);
    SceneScores scores;
    for (std::size_t t = 0; t < techniques.size(); ++t) {
        const Technique& technique = techniques[t];
        const Image<float>& A = timed[t].A;
        scores.techniques.push_back(
            {.name = technique.name,
             .falloff = technique.falloff,
             .samples = technique.samples,
             .timed = timed[t],
             .picture = picture(technique.name, A),
             .signed_error = picture(technique.name + "_error",
                                     SignedPicture(A, near.value, first.regions.seen))});
    }
    ViewBoard board(scores);
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
            board.Add(t, views[v], std::move(A));
            run.monitor.Progress("scores",
                                 ++done / double(views.size()) / double(techniques.size()));
        }
    }
    board.Finish(views);

    truth.facts = {{{.key = "radius_m", .title = "Radius r", .unit = "m"}, radius_m},
                   {{.key = "triangles", .title = "Triangles"}, caster.Counts().triangles}};
    doc::Section scored = ScoresSection(views, scores, job.rounds);
    doc::Section machine{.id = "machine", .title = "This machine", .folded = true};
    machine.facts = BenchFacts(ThreadCount(), job.rounds);
    machine.facts.insert(machine.facts.end(),
                         {{TimeColumn("raster_ms", "One G-buffer", "ms"), 1e3 * raster_s},
                          {TimeColumn("copy_gb_per_s", "Copying memory, read and written",
                                      "GB/s", doc::Better::kMore),
                           1e-9 * copy_bytes_per_second},
                          {TimeColumn("mrays_per_s", "Bare occlusion rays in this scene", "M/s",
                                      doc::Better::kMore),
                           1e-6 * rays_per_second}});
    scored.sections.push_back(std::move(machine));
    doc::Document report{.kind = "scene_report",
                         .title = "Ambient obscurance of " + scene.name,
                         .subtitle = ViewsText(views) + ", radius " + Digits(radius_m) + " m",
                         .provenance = doc::ProvenanceOf(run)};
    report.provenance.seed = job.seed;
    report.provenance.inputs = {{scene.name, loaded.digest}};
    report.sections = {FindingsSection(views, scores, loaded.notes), std::move(truth),
                       std::move(scored), PicturesSection(first, scores)};
    if (job.studies) {
        AddStudies(loaded, job, chosen, budget, caster, first, copy_bytes_per_second.value,
                   report.sections, run);
    }
    return report;
}

doc::Document InBrief(doc::Document report) {
    std::erase_if(report.sections, [](const doc::Section& section) {
        return section.id != "findings" && section.id != "scores";
    });
    for (doc::Section& section : report.sections) section.sections.clear();
    return report;
}

std::filesystem::path WriteSceneReport(const std::filesystem::path& folder,
                                       const doc::Document& report) {
    WriteWholeFile(folder / "scores.csv", doc::ToCsv(doc::TableOf(report, "scores")));
    for (const doc::Section& section : report.sections) {
        if (section.id != "sweep") continue;
        WriteWholeFile(folder / "sweep.csv", doc::ToCsv(doc::TableOf(report, "sweep")));
    }
    return WriteDocument(folder, report);
}

}  // namespace plumb
