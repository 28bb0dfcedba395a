// plumb bench raster: the reference rasterizer beside this machine's memory.
//
// Options -> struct -> call -> print.
#include <memory>
#include <string>

#include "app/command.h"
#include "jobs/screen_space/bench_raster.h"
#include "jobs/truth/load_scene.h"

namespace plumb::app {
namespace {

struct Options {
    std::string scene = "make:atrium";
    RasterBenchSettings settings;
    Common common;
};

void Run(const Options& o) {
    const auto monitor = MakeMonitor(o.common);
    Publish(BenchRaster(LoadScene(o.scene).scene, o.settings, ContextOf(o.common, *monitor)),
            o.common);
}

void Add(CLI::App& bench) {
    auto o = std::make_shared<Options>();
    o->common.out = "out/bench-raster";
    CLI::App* raster = bench.add_subcommand(
        "raster",
        "The reference rasterizer: every view of a scene, triangles of seven sizes, each\n"
        "beside copying the same bytes. The page, JSON and CSV go to the folder --out.");
    raster->add_option("scene", o->scene, "scene.json, or make:KIND")->capture_default_str();
    raster->add_option("--width", o->settings.width_px, "Width of the views [pixels]")
        ->check(CLI::Range(1, 16384))
        ->capture_default_str();
    raster->add_option("--height", o->settings.height_px, "Height of the views [pixels]")
        ->check(CLI::Range(1, 16384))
        ->capture_default_str();
    AddRounds(*raster, o->settings.rounds);
    AddCommon(*raster, o->common);
    raster->callback([o] { Run(*o); });
}

const Listed kListed("bench", 20, Add);

}  // namespace
}  // namespace plumb::app
