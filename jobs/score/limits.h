// Limits that figures must keep: --fail-under psnr=40, --fail-over flip=0.05.
#pragma once

#include <string>
#include <vector>

#include "jobs/score/score_candidate.h"
#include "reports/document.h"

namespace plumb {

struct Limit {
    std::string key;  ///< Of FigureKeys().
    double value;
    bool is_least;  ///< Fails where the figure is less; else where it is greater.
};

/// "psnr=40" of the flag `flag`. Throws Error naming both.
Limit ParseLimit(const std::string& text, const std::string& flag, bool is_least);

/// A figure that is not known keeps no limit; an infinite PSNR keeps each.
bool Keeps(const Limit& limit, double figure);

/// A row for each candidate and limit. Adds to `failures` what is not kept.
doc::Table LimitTable(const std::vector<Limit>& limits,
                      const std::vector<CandidateScore>& scores,
                      std::vector<std::string>& failures);

}  // namespace plumb
