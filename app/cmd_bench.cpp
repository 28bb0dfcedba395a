// plumb bench: speed as ratios to this machine's own limits.
//
// Options -> struct -> call -> print.
#include <sys/resource.h>

#include <memory>
#include <string>

#include "app/bench_output.h"
#include "app/command.h"
#include "jobs/light/bench_light.h"

namespace plumb::app {
namespace {

struct Options {
    std::string map = "make:stone_wall:512";
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
    const LightBench bench =
        BenchLight(LoadSurface(o.map), o.settings, NowS, PeakMemoryBytes, *monitor);
    Publish(bench, o.common);
}

}  // namespace

void AddBench(CLI::App& program) {
    CLI::App* bench =
        program.add_subcommand("bench", "Speed against this machine's own limits, in one run");
    bench->require_subcommand(1);
    auto o = std::make_shared<Options>();
    CLI::App* light = bench->add_subcommand(
        "light",
        "The light simulation: casting beside Embree, both methods whole, memory, error of V\n"
        "against time. Writes bench_light.json to the folder --out.");
    light->add_option("map", o->map, "Height map, or make:KIND[:SIZE[:SEED]]")
        ->capture_default_str();
    light->add_option("--slices", o->settings.slices, "Slices a facet")
        ->check(CLI::Range(4, 65536))
        ->capture_default_str();
    light->add_option("--rays", o->settings.rays, "Rays a facet")
        ->check(CLI::Range(1, 1048576))
        ->capture_default_str();
    light
        ->add_option("--rounds", o->settings.rounds, "Rounds of each comparison; medians count")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    AddCommon(*light, o->common);
    light->callback([o] { Run(*o); });
    AddBenchRaster(*bench);
    AddBenchTruth(*bench);
    AddBenchAo(*bench);
}

}  // namespace plumb::app
