// What every bench says of its run.
#pragma once

#include <string>
#include <vector>

#include "reports/document.h"

namespace plumb {

/// Threads and rounds. Threads count as a time: they are the machine's, not the result's.
inline std::vector<doc::Fact> BenchFacts(int threads, int rounds) {
    return {{{.key = "threads", .title = "Threads", .role = doc::Role::kTime}, threads},
            {{.key = "rounds",
              .title = "Rounds, in turns, after one that warms up",
              .meaning = "times are medians, with the least and the greatest"},
             rounds}};
}

/// A column of times, rates or ratios of times.
inline doc::Column TimeColumn(std::string key, std::string title, std::string unit,
                              doc::Better better = doc::Better::kLess,
                              std::string meaning = {}) {
    return {.key = std::move(key),
            .title = std::move(title),
            .unit = std::move(unit),
            .role = doc::Role::kTime,
            .better = better,
            .meaning = std::move(meaning)};
}

}  // namespace plumb
