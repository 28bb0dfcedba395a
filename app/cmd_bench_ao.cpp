// plumb bench ao: SAO and AlchemyAO at the paper's sizes.
//
// Options -> struct -> call -> print.
#include <memory>
#include <string>

#include "app/bench_output.h"
#include "app/command.h"
#include "core/parallel.h"
#include "jobs/screen_space/bench_ao.h"
#include "jobs/screen_space/render_scene.h"
#include "jobs/truth/load_scene.h"

namespace plumb::app {
namespace {

struct Options {
    std::string scene = "atrium", camera;
    AoBenchSettings settings;
    int width_px = 0, height_px = 0;
    Common common;
};

void Run(const Options& o) {
    SetThreadCount(o.common.threads);
    const auto monitor = MakeMonitor(o.common);
    const LoadedScene loaded = LoadScene(o.scene);
    AoBenchSettings settings = o.settings;
    if (o.width_px > 0 && o.height_px > 0) {
        settings.sizes = {{o.width_px, o.height_px, GuardPx(-1, o.height_px)}};
    }
    const AoBench bench =
        BenchAo(loaded.scene, CameraNamed(loaded.scene, o.camera), settings, NowS, *monitor);
    Publish(bench, o.common);
}

}  // namespace

void AddBenchAo(CLI::App& bench) {
    auto o = std::make_shared<Options>();
    CLI::App* ao = bench.add_subcommand(
        "ao",
        "SAO and AlchemyAO at the paper's sizes of picture: all passes, sampling time against\n"
        "radius, beside copying the same bytes. Writes bench_ao.json to the folder --out.");
    ao->add_option("scene", o->scene, "A scene.json, or a generated scene (docs/scenes.md)")
        ->capture_default_str();
    ao->add_option("--camera", o->camera, "Name of the camera; the first if not given");
    ao->add_option("--radius", o->settings.radius_m, "Radius [m]")->capture_default_str();
    ao->add_option("--width", o->width_px, "One size only, with --height [px]")
        ->check(CLI::Range(1, 16384));
    ao->add_option("--height", o->height_px, "One size only, with --width [px]")
        ->check(CLI::Range(1, 16384));
    ao->add_option("--rounds", o->settings.rounds, "Rounds of each comparison; medians count")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    AddCommon(*ao, o->common);
    ao->callback([o] { Run(*o); });
}

}  // namespace plumb::app
