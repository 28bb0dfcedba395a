// plumb bench light: the light simulation beside Embree and copying memory.
//
// Options -> struct -> call -> print.
#include <sys/resource.h>

#include <memory>
#include <string>

#include "app/command.h"
#include "jobs/light/bench_light.h"

namespace plumb::app {
namespace {

struct Options {
    std::string map = "make:stone_wall:256";
    LightBenchSettings settings;
    Common common;
};

double PeakMemoryBytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * double(usage.ru_maxrss);  // Linux counts KiB.
}

void Run(const Options& o) {
    const auto monitor = MakeMonitor(o.common);
    Publish(BenchLight(LoadSurface(o.map), o.settings, PeakMemoryBytes,
                       ContextOf(o.common, *monitor)),
            o.common);
}

void Add(CLI::App& bench) {
    auto o = std::make_shared<Options>();
    o->common.out = "out/bench-light";
    CLI::App* light = bench.add_subcommand(
        "light",
        "The light simulation: casting beside Embree, both methods whole, memory, error of V\n"
        "against time. The page, JSON and CSV go to the folder --out.");
    light->add_option("map", o->map, "Height map, or make:KIND[:SIZE[:SEED]]")
        ->capture_default_str();
    light->add_option("--slices", o->settings.slices, "Slices a facet")
        ->check(CLI::Range(4, 65536))
        ->capture_default_str();
    light->add_option("--rays", o->settings.rays, "Rays a facet")
        ->check(CLI::Range(1, 1048576))
        ->capture_default_str();
    AddRounds(*light, o->settings.rounds);
    AddCommon(*light, o->common);
    light->callback([o] { Run(*o); });
}

const Listed kListed("bench", 10, Add);

}  // namespace
}  // namespace plumb::app
