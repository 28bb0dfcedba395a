// plumb truth: the path-traced truth of one view, with error bars.
//
// Options -> struct -> call -> print.
#include <iostream>
#include <map>
#include <memory>
#include <string>

#include "app/command.h"
#include "core/error.h"
#include "core/parallel.h"
#include "jobs/truth/facet_truth.h"
#include "jobs/truth/truth.h"

namespace plumb::app {
namespace {

struct Options {
    std::string scene;
    TruthJob job;
    bool no_alpha = false, no_v = false, no_cache = false, facets = false;
    Common common;
};

void RunFacets(const Options& o, Monitor& monitor) {
    const FacetTruthJob job{.spp = o.job.max_spp,
                            .bounces = o.job.bounces,
                            .alpha = !o.no_alpha,
                            .seed = o.common.seed};
    Validate(job);  // Before a scene that may be large.
    const FacetTruthResult result =
        MeasureFacetTruth(LoadScene(o.scene), job, o.common.out, monitor);
    if (o.common.quiet) return;
    std::cout << result.triangles << " triangles (" << result.zero_area
              << " without area left out), mean V " << result.mean_V
              << ", root mean square standard error of V " << result.rms_error_V << ", "
              << result.lost << " rays lost\nTable: " << result.csv.string() << "\n";
}

void RunTruth(Options o) {
    SetThreadCount(o.common.threads);
    const auto monitor = MakeMonitor(o.common);
    if (o.facets) return RunFacets(o, *monitor);
    o.job.alpha = !o.no_alpha;
    o.job.V = !o.no_v;
    o.job.use_cache = !o.no_cache;
    o.job.seed = o.common.seed;
    Validate(o.job);  // Before a scene that may be large.
    const TruthResult result =
        MeasureTruth(LoadScene(o.scene), o.job, ContextOf(o.common, *monitor));
    Print(result.document, result.page, o.common);
    if (result.interrupted) throw Interrupted();
}

void Add(CLI::App& program) {
    auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand(
        "truth",
        "Path-trace one view of a scene: V, alpha and bounces under a white sky, irradiance "
        "and\n"
        "beauty under its own, each with its standard error. Writes truth.exr, truth.html,\n"
        "truth.json, truth.csv and pictures; states go to the cache.");
    command
        ->add_option("scene", o->scene,
                     "A scene.json, or a generated scene such as atrium (docs/scenes.md)")
        ->required();
    command->add_option("--camera", o->job.camera,
                        "Name of the camera; the first if not given");
    command->add_option("--width", o->job.width_px, "Width of the picture [px]")
        ->check(CLI::Range(1, 65536));
    command->add_option("--height", o->job.height_px, "Height of the picture [px]")
        ->check(CLI::Range(1, 65536));
    command->add_flag("--no-alpha", o->no_alpha, "Leave out the uniform visibility");
    command->add_flag("--no-v", o->no_v, "Leave out the cosine visibility");
    command->add_flag("--irradiance", o->job.irradiance,
                      "Also the light with the scene's own albedos, sky and lights");
    command->add_flag("--beauty", o->job.beauty,
                      "Also the shading model, averaged over each pixel");
    command
        ->add_option("--bounces", o->job.bounces,
                     "Also E_1 ... E_K: the light of each of K bounces")
        ->check(CLI::Range(0, 100))
        ->capture_default_str();
    command->add_option(
        "--albedo", o->job.albedos,
        "With --bounces: also the total light for these albedos, each in [0, 1]");
    CLI::Option* reach = command->add_option(
        "--reach", o->job.reach_m, "Also the visibility within this reach [m]; 0 = not");
    const std::map<std::string, Falloff> falloffs{
        {"hard", Falloff::kHard}, {"linear", Falloff::kLinear}, {"sao", Falloff::kSao}};
    command->add_option("--falloff", o->job.falloff, "With --reach: hard, linear or sao")
        ->transform(CLI::CheckedTransformer(falloffs))
        ->needs(reach);
    command
        ->add_option("--spp", o->job.max_spp,
                     "Stop at this many samples a pixel: a power of two, at least 64")
        ->capture_default_str();
    command
        ->add_option(
            "--target-error", o->job.target_error,
            "Stop when the root mean square standard error of V (without V: of irradiance,\n"
            "or beauty) is this small, > 0")
        ->check(AboveZero());
    command->add_option("--seconds", o->job.max_seconds, "Stop after this time [s], > 0")
        ->check(AboveZero());
    command->add_flag("--resume", o->job.resume,
                      "Refuse to start anew: the cache must have a state to go on from");
    command->add_option("--cache", o->job.cache,
                        "Folder of states; the folder cache in that of --out if not given");
    command->add_flag("--no-cache", o->no_cache, "Keep no state, and use none");
    CLI::Option* facets = command->add_flag(
        "--facets", o->facets,
        "Measure every triangle over its area instead of a view: facets.csv, with "
        "--spp, --bounces and --no-alpha");
    for (const char* of_a_view :
         {"--camera", "--width", "--height", "--no-v", "--irradiance", "--beauty", "--albedo",
          "--reach", "--falloff", "--target-error", "--seconds", "--resume", "--cache"}) {
        facets->excludes(of_a_view);
    }
    AddCommon(*command, o->common);
    facets->excludes("--json");
    command->callback([o] { RunTruth(*o); });
}

const Listed kListed("", 30, Add);

}  // namespace
}  // namespace plumb::app
