#include "core/time_in_turns.h"

#include <algorithm>
#include <numeric>

#include "core/error.h"
#include "core/statistics.h"

namespace plumb {

Measured MedianOf(std::span<const double> values) {
    const auto [least, greatest] = std::ranges::minmax_element(values);
    return {.value = Percentile({values.begin(), values.end()}, 0.5),
            .interval = {.low = *least, .high = *greatest}};
}

Measured PerSecond(double units, const Measured& seconds) {
    return {.value = units / seconds.value,
            .interval = {.low = units / seconds.interval.high,
                         .high = units / seconds.interval.low}};
}

template <class F>
Measured TurnTimes::OverRounds(const F& of_round) const {
    std::vector<double> values;
    for (std::size_t round = 0; round < seconds_.size(); ++round) {
        values.push_back(of_round(round));
    }
    return MedianOf(values);
}

double TurnTimes::Total(std::size_t thing, std::size_t round) const {
    const std::vector<double>& parts = seconds_[round][thing];
    return std::accumulate(parts.begin(), parts.end(), 0.0);
}

Measured TurnTimes::Seconds(std::size_t thing) const {
    return OverRounds([&](std::size_t round) { return Total(thing, round); });
}

Measured TurnTimes::SecondsOfPart(std::size_t thing, std::size_t part) const {
    return OverRounds([&](std::size_t round) { return seconds_[round][thing][part]; });
}

Measured TurnTimes::Rate(std::size_t thing, double units) const {
    return PerSecond(units, Seconds(thing));
}

Measured TurnTimes::Ratio(std::size_t thing, std::size_t other) const {
    return OverRounds(
        [&](std::size_t round) { return Total(thing, round) / Total(other, round); });
}

TurnTimes TakeTurns(const std::vector<SelfTimed>& things, int rounds, Monitor& monitor) {
    if (rounds < 1) throw Error(MustBe("rounds", rounds, ">= 1"));
    TurnTimes times;
    for (int round = 0; round <= rounds; ++round) {
        std::vector<std::vector<double>> of_round;
        for (const SelfTimed& thing : things) {
            if (monitor.Cancelled()) throw Interrupted();
            of_round.push_back(thing());
        }
        if (round > 0) times.seconds_.push_back(std::move(of_round));
    }
    return times;
}

TurnTimes TimeInTurns(const std::vector<Turn>& turns, int rounds, const Clock& clock,
                      Monitor& monitor) {
    std::vector<SelfTimed> things;
    for (const Turn& turn : turns) {
        things.push_back([&turn, &clock] {
            if (turn.prepare) turn.prepare();
            const double begin_s = clock();
            turn.run();
            return std::vector<double>{clock() - begin_s};
        });
    }
    return TakeTurns(things, rounds, monitor);
}

}  // namespace plumb
