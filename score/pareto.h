// Which settings are worth their time: those that no other one beats in both time and error.
//
// Symbols  A point is beaten by another that is no slower and no worse, and better in one.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace plumb {

struct TimedError {
    std::string name;  ///< Of the technique with its settings.
    double time_s = 0;
    double error = 0;  ///< Any measure that is better when smaller.
};

/// The indices of the points that no other beats, by rising time; of equal points the first
/// only. Throws Error, naming the point, for a time or an error that is not a number.
std::vector<std::size_t> ParetoFront(std::span<const TimedError> points);

/// The fastest point whose error is at most (1 + tolerance) times the least; needs a point.
std::size_t CheapestWithin(std::span<const TimedError> points, double tolerance);

}  // namespace plumb
