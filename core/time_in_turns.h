// Times of things that are compared: each in turn, round after round, so that a machine that
// slows down slows all of them.
//
//       one round that warms up and does not count, then R rounds; of each thing the times t_r
//       time    median of t_r         interval: from the least to the greatest
//       ratio   median of t_r / u_r   of the same rounds, u_r being those of another thing
//
// The interval from the least to the greatest of R independent times holds the median of all times
// that this machine could show with probability 1 - 2^(1-R): .94 for R = 5, .98 for R = 7
// (each time lies above the median with probability 1/2). A ratio pair by pair is surer than a
// ratio of medians, since what disturbs a round disturbs both.
//
// Source   The sign test's interval: [Thompson36] W. R. Thompson, On Confidence Ranges for the
//          Median, Annals of Mathematical Statistics 7, 1936.
// Beware   Neighbouring rounds are alike on a shared machine: the interval is then too short.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/clock.h"
#include "core/measured.h"
#include "core/monitor.h"

namespace plumb {

/// Rounds of a timing unless its user asks for others.
inline constexpr int kTimedRounds = 5;

/// The median, and the interval from the least to the greatest. Needs a value.
Measured MedianOf(std::span<const double> values);

/// `units` a second, done in `seconds`.
Measured PerSecond(double units, const Measured& seconds);

/// What is timed, with what has to be made ready before each time and does not count.
struct Turn {
    std::function<void()> run;
    std::function<void()> prepare = {};
};

/// What times itself: the seconds of each of its parts, as many in every round.
using SelfTimed = std::function<std::vector<double>()>;

/// The times of things, by the order in which they were given.
class TurnTimes {
  public:
    /// Of all parts together.
    Measured Seconds(std::size_t thing) const;
    Measured SecondsOfPart(std::size_t thing, std::size_t part) const;

    /// `units` a second, all parts together.
    Measured Rate(std::size_t thing, double units) const;

    /// Time of one over the time of another, round by round.
    Measured Ratio(std::size_t thing, std::size_t other) const;

  private:
    friend TurnTimes TakeTurns(const std::vector<SelfTimed>&, int, Monitor&);

    template <class F>
    Measured OverRounds(const F& of_round) const;
    double Total(std::size_t thing, std::size_t round) const;

    std::vector<std::vector<std::vector<double>>> seconds_;  ///< [round][thing][part]
};

/// Runs every thing `rounds` + 1 times. `rounds` >= 1. Throws Interrupted between two turns.
TurnTimes TimeInTurns(const std::vector<Turn>& turns, int rounds, const Clock& clock,
                      Monitor& monitor = SilentMonitor());
TurnTimes TakeTurns(const std::vector<SelfTimed>& things, int rounds,
                    Monitor& monitor = SilentMonitor());

}  // namespace plumb
