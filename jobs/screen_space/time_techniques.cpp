#include "jobs/screen_space/time_techniques.h"

#include "core/time_in_turns.h"

namespace plumb {

std::vector<TimedTechnique> TimeTechniques(std::span<const TechniqueTurn> turns, int rounds,
                                           const Clock& clock, Monitor& monitor) {
    std::vector<TimedTechnique> results(turns.size());
    std::vector<SelfTimed> things;
    for (std::size_t k = 0; k < turns.size(); ++k) {
        things.push_back([&, k] {
            std::vector<Pass> passes = turns[k].technique->run(*turns[k].input, clock);
            std::vector<double> seconds;
            for (const Pass& pass : passes) seconds.push_back(pass.seconds);
            if (results[k].passes.empty()) {
                results[k].A = Shown(passes.back().A, turns[k].input->gbuffer.view);
                for (Pass& pass : passes) results[k].passes.push_back({pass.name, {}});
            }
            return seconds;
        });
    }
    const TurnTimes times = TakeTurns(things, rounds, monitor);
    for (std::size_t k = 0; k < turns.size(); ++k) {
        results[k].seconds = times.Seconds(k);
        for (std::size_t p = 0; p < results[k].passes.size(); ++p) {
            results[k].passes[p].seconds = times.SecondsOfPart(k, p);
        }
    }
    return results;
}

}  // namespace plumb
