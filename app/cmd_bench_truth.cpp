// plumb bench truth: the path tracer beside bare Embree, a furnace and independent sampling.
//
// Options -> struct -> call -> print.
#include <memory>
#include <string>

#include "app/command.h"
#include "jobs/truth/bench_truth.h"

namespace plumb::app {
namespace {

struct Options {
    std::string scene = "atrium";
    TruthBenchSettings settings;
    Common common;
};

void Run(const Options& o) {
    const auto monitor = MakeMonitor(o.common);
    Publish(BenchTruth(LoadScene(o.scene), o.settings, ContextOf(o.common, *monitor)),
            o.common);
}

void Add(CLI::App& bench) {
    auto o = std::make_shared<Options>();
    o->common.out = "out/bench-truth";
    CLI::App* truth = bench.add_subcommand(
        "truth",
        "The path tracer: V of a view beside bare Embree calls over the same rays on 1 and 2\n"
        "threads, a furnace on a noisy field, error of V against rays. The page, JSON and CSV\n"
        "go to the folder --out.");
    truth->add_option("scene", o->scene, "scene.json, or make:KIND")->capture_default_str();
    truth->add_option("--width", o->settings.width_px, "Width of the view [pixels]")
        ->check(CLI::Range(1, 65536))
        ->capture_default_str();
    truth->add_option("--height", o->settings.height_px, "Height of the view [pixels]")
        ->check(CLI::Range(1, 65536))
        ->capture_default_str();
    truth
        ->add_option("--rows", o->settings.pixel_rows,
                     "Rows of pixels that are timed, evenly spread: each costs 3 KiB a pixel")
        ->check(CLI::Range(1, 65536))
        ->capture_default_str();
    AddRounds(*truth, o->settings.rounds);
    truth
        ->add_option("--paths", o->settings.furnace_paths,
                     "Paths of the furnace; 0 = none, 100000000 takes minutes")
        ->check(CLI::Range(std::int64_t{0}, std::int64_t{1} << 40))
        ->capture_default_str();
    AddCommon(*truth, o->common);
    truth->callback([o] { Run(*o); });
}

const Listed kListed("bench", 30, Add);

}  // namespace
}  // namespace plumb::app
