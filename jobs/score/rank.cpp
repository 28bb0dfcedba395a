#include "jobs/score/rank.h"

#include <algorithm>
#include <numeric>

#include "core/intervals.h"

namespace plumb {

std::vector<std::size_t> Ranking::TiesOf(std::size_t k) const {
    std::vector<std::size_t> ties;
    for (const std::size_t other : order) {
        for (const RankedPair& pair : pairs) {
            const bool of_both = (pair.first == k && pair.second == other) ||
                                 (pair.second == k && pair.first == other);
            if (of_both && pair.tie) ties.push_back(other);
        }
    }
    return ties;
}

Ranking Rank(const Compared& compared, const std::vector<double>& mse,
             const ErrorOptions& options) {
    Ranking ranking;
    const std::size_t n = mse.size();
    ranking.order.resize(n);
    std::iota(ranking.order.begin(), ranking.order.end(), std::size_t{0});
    std::ranges::stable_sort(ranking.order,
                             [&](std::size_t a, std::size_t b) { return mse[a] < mse[b]; });
    ranking.rank.assign(n, 1);
    if (n < 2) return ranking;
    ErrorOptions shared = options;
    shared.confidence =
        1 - SidakLevel(1 - options.confidence, std::int64_t(n) * std::int64_t(n - 1) / 2);
    for (std::size_t a = 0; a < n; ++a) {
        for (std::size_t b = a + 1; b < n; ++b) {
            const std::size_t first = ranking.order[a], second = ranking.order[b];
            const Measured difference = CompareChannels(
                compared.candidates[first].values, compared.candidates[second].values,
                compared.reference.values, compared.standard_error, compared.mask, shared);
            const bool tie = !(difference.interval.high < 0);
            ranking.pairs.push_back({first, second, difference, tie});
            ranking.rank[second] += !tie;
        }
    }
    return ranking;
}

}  // namespace plumb
