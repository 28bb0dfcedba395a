// plumb bench score: how long each metric takes.
//
// Options -> struct -> call -> print.
#include <memory>

#include "app/command.h"
#include "jobs/score/bench_score.h"

namespace plumb::app {
namespace {

struct Options {
    ScoreBenchSettings settings;
    Common common;
};

void Run(const Options& o) {
    const auto monitor = MakeMonitor(o.common);
    Publish(BenchScore(o.settings, ContextOf(o.common, *monitor)), o.common);
}

void Add(CLI::App& bench) {
    auto o = std::make_shared<Options>();
    o->common.out = "out/bench-score";
    CLI::App* score = bench.add_subcommand(
        "score",
        "Every metric of plumb score on two made pictures, in milliseconds a megapixel.\n"
        "The page, JSON and CSV go to the folder --out.");
    score->add_option("--width", o->settings.width_px, "Width of the pictures [pixels]")
        ->check(CLI::Range(1, 16384))
        ->capture_default_str();
    score->add_option("--height", o->settings.height_px, "Height of the pictures [pixels]")
        ->check(CLI::Range(1, 16384))
        ->capture_default_str();
    AddRounds(*score, o->settings.rounds);
    AddCommon(*score, o->common);
    score->callback([o] { Run(*o); });
}

const Listed kListed("bench", 50, Add);

}  // namespace
}  // namespace plumb::app
