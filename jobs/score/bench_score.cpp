#include "jobs/score/bench_score.h"

#include <array>
#include <functional>

#include "core/parallel.h"
#include "core/random.h"
#include "jobs/bench_facts.h"
#include "score/errors.h"
#include "score/flip_hdr.h"
#include "score/quantiles.h"
#include "score/ssim.h"

namespace plumb {
namespace {

struct Pictures {
    Image<Rgb> candidate, reference;
    Channels c, t;
};

/// Noise, which no metric can take a short cut through.
Pictures Make(const ScoreBenchSettings& settings, std::uint64_t seed) {
    Pictures made{.candidate = Image<Rgb>(settings.width_px, settings.height_px),
                  .reference = Image<Rgb>(settings.width_px, settings.height_px),
                  .c = Channels(3, Image<float>(settings.width_px, settings.height_px)),
                  .t = {}};
    made.t = made.c;
    for (std::size_t p = 0; p < made.candidate.Pixels().size(); ++p) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double unit = RandomUnit(seed, p, c, 0);
            made.t[c].Pixels()[p] = made.reference.Pixels()[p][c] = float(unit);
            made.c[c].Pixels()[p] = made.candidate.Pixels()[p][c] = float(0.9 * unit);
        }
    }
    return made;
}

}  // namespace

doc::Document BenchScore(const ScoreBenchSettings& settings, const RunContext& run) {
    const Pictures made = Make(settings, run.seed);
    constexpr std::array kShares{0.5, 0.99};
    const ToneExposures exposures{.start_stops = -1, .stop_stops = 2, .count = 4};
    const std::vector<std::pair<std::string, std::function<void()>>> metrics{
        {"FLIP", [&] { FlipMap(made.candidate, made.reference); }},
        {"FLIP, high range, 4 exposures",
         [&] { HdrFlipMap(made.candidate, made.reference, {}, {.exposures = exposures}); }},
        {"SSIM of one channel", [&] { SsimMap(made.c[0], made.t[0]); }},
        {"bias, MAE, MSE of a colour", [&] { ScoreChannels(made.c, made.t); }},
        {"quantiles of a colour", [&] { AbsoluteErrorQuantiles(made.c, made.t, kShares); }},
    };
    std::vector<Turn> turns;
    for (const auto& [name, metric] : metrics) turns.push_back({.run = metric});
    const TurnTimes times = TimeInTurns(turns, settings.rounds, run.clock, run.monitor);
    doc::Table table{.key = "metrics",
                     .columns = {{.key = "metric", .title = "Metric", .role = doc::Role::kName},
                                 TimeColumn("ms_per_mpx", "Time", "ms/Mpx"),
                                 TimeColumn("of_errors", "Over bias, MAE, MSE", "")}};
    const double megapixels = 1e-6 * settings.width_px * settings.height_px;
    for (std::size_t k = 0; k < metrics.size(); ++k) {
        table.Add({metrics[k].first, (1e3 / megapixels) * times.Seconds(k), times.Ratio(k, 3)});
    }
    doc::Section section{.id = "metrics",
                         .title = "Two pictures of " + std::to_string(settings.width_px) +
                                  " x " + std::to_string(settings.height_px) +
                                  " pixels, all threads"};
    section.facts = BenchFacts(ThreadCount(), settings.rounds);
    section.tables.push_back(std::move(table));
    return {.kind = "bench_score",
            .title = "Speed of scoring",
            .subtitle = {},
            .provenance = doc::ProvenanceOf(run),
            .sections = {std::move(section)}};
}

}  // namespace plumb
