// plumb bench ao: SAO and AlchemyAO at the paper's sizes.
//
// Options -> struct -> call -> print.
#include <memory>
#include <string>

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
    Validate(o.settings);
    const LoadedScene loaded = LoadScene(o.scene);
    AoBenchSettings settings = o.settings;
    if (o.width_px > 0 && o.height_px > 0) {
        settings.sizes = {{o.width_px, o.height_px, GuardPx(-1, o.height_px)}};
    }
    Publish(BenchAo(loaded.scene, CameraNamed(loaded.scene, o.camera), settings,
                    ContextOf(o.common, *monitor)),
            o.common);
}

void Add(CLI::App& bench) {
    auto o = std::make_shared<Options>();
    o->common.out = "out/bench-ao";
    CLI::App* ao = bench.add_subcommand(
        "ao",
        "SAO and AlchemyAO at the paper's sizes of picture: all passes, sampling time against\n"
        "radius, beside copying the same bytes. The page, JSON and CSV go to the folder "
        "--out.");
    ao->add_option("scene", o->scene, "A scene.json, or a generated scene (docs/scenes.md)")
        ->capture_default_str();
    ao->add_option("--camera", o->camera, "Name of the camera; the first if not given");
    ao->add_option("--radius", o->settings.radius_m, "Radius [m]")->capture_default_str();
    CLI::Option* width =
        ao->add_option("--width", o->width_px, "One size only, with --height [px]")
            ->check(CLI::Range(1, 16384));
    CLI::Option* height =
        ao->add_option("--height", o->height_px, "One size only, with --width [px]")
            ->check(CLI::Range(1, 16384));
    width->needs(height);
    height->needs(width);
    AddRounds(*ao, o->settings.rounds);
    AddCommon(*ao, o->common);
    ao->callback([o] { Run(*o); });
}

const Listed kListed("bench", 40, Add);

}  // namespace
}  // namespace plumb::app
