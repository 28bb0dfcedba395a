#include "jobs/screen_space/find_closest.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "score/errors.h"
#include "score/over_views.h"

namespace plumb {
namespace {

const ErrorOptions kOptions{.truth_dof = kTruthNets - 1.0};

// MSE in each view.
std::vector<double> MeanSquares(const Contestant& contestant,
                                std::span<const ComparedView> views) {
    std::vector<double> squares;
    for (std::size_t v = 0; v < views.size(); ++v) {
        squares.push_back(ScoreErrors(contestant.pictures[v], views[v].truth->value,
                                      views[v].truth->standard_error, *views[v].mask, kOptions)
                              .mse.value);
    }
    return squares;
}

Measured Difference(const Contestant& a, const Contestant& b,
                    std::span<const ComparedView> views) {
    std::vector<Measured> differences;
    for (std::size_t v = 0; v < views.size(); ++v) {
        differences.push_back(CompareMse(a.pictures[v], b.pictures[v], views[v].truth->value,
                                         views[v].truth->standard_error, *views[v].mask,
                                         kOptions));
    }
    if (views.size() == 1) return differences.front();
    const std::vector<double> of_a = MeanSquares(a, views), of_b = MeanSquares(b, views);
    for (std::size_t v = 0; v < views.size(); ++v) {
        const double half_sum = (of_a[v] + of_b[v]) / 2;
        if (half_sum > 0) differences[v].value /= half_sum;
    }
    return MeanOverViews(differences, kOptions.confidence);
}

}  // namespace

std::vector<std::string> TiesOf(std::size_t winner, std::span<const Contestant> contestants,
                                std::span<const ComparedView> views) {
    std::vector<std::string> ties;
    for (std::size_t c = 0; c < contestants.size(); ++c) {
        if (c == winner) continue;
        const Measured difference = Difference(contestants[c], contestants[winner], views);
        if (difference.interval.low <= 0 && difference.interval.high >= 0) {
            ties.push_back(contestants[c].name);
        }
    }
    return ties;
}

Closest FindClosest(std::span<const Contestant> contestants,
                    std::span<const ComparedView> views) {
    assert(!contestants.empty() && !views.empty());
    std::vector<double> errors;
    for (const Contestant& contestant : contestants) {
        const std::vector<double> squares = MeanSquares(contestant, views);
        errors.push_back(std::accumulate(squares.begin(), squares.end(), 0.0));
    }
    const auto least = std::ranges::min_element(errors) - errors.begin();
    return {contestants[std::size_t(least)].name,
            TiesOf(std::size_t(least), contestants, views)};
}

}  // namespace plumb
