// Who beats whom, and who cannot be told apart.
//
// Every pair is held against the same reference by the difference of the squared errors, pixel by pixel
// (CompareChannels), whose interval over the tiles is much shorter than those of the two figures: the
// reference's noise and what is hard for both cancel. The level is shared among all pairs by Sidak's
// rule. A pair whose interval holds 0 is a tie.
#pragma once

#include <vector>

#include "core/measured.h"
#include "jobs/score/compared.h"
#include "score/errors.h"

namespace plumb {

struct RankedPair {
    std::size_t first, second;  ///< Candidates; the first has the smaller MSE.
    Measured difference;        ///< MSE of the first less that of the second.
    bool tie;
};

struct Ranking {
    std::vector<std::size_t> order;  ///< Candidates by rising MSE.
    std::vector<int> rank;           ///< Of each: 1 + those that surely beat it.
    std::vector<RankedPair> pairs;

    /// Those that candidate k ties with, in the order of their MSE.
    std::vector<std::size_t> TiesOf(std::size_t k) const;
};

/// `mse`: of each candidate.
Ranking Rank(const Compared& compared, const std::vector<double>& mse,
             const ErrorOptions& options);

}  // namespace plumb
