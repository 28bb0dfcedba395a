#include "truth/replicates.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/error.h"
#include "core/random.h"
#include "core/statistics.h"

namespace plumb {

void Validate(const NetSampling& sampling) {
    if (sampling.replicates < 2 || sampling.replicates > 1024) {
        throw Error(MustBe("NetSampling::replicates", sampling.replicates, "in [2, 1024]"));
    }
    if (sampling.first < 0)
        throw Error(MustBe("NetSampling::first", double(sampling.first), ">= 0"));
    if (sampling.points < 1 || sampling.first + sampling.points > std::int64_t{1} << 32) {
        throw Error(
            MustBe("NetSampling::points", double(sampling.points), ">= 1, up to 2^32 in all"));
    }
}

std::uint64_t NetSeed(std::uint64_t seed, std::int64_t receiver, int replicate) {
    return Absorb(Absorb(Absorb(0, seed), std::uint64_t(receiver)), std::uint64_t(replicate));
}

namespace {

// `step`: what one sample more or less counts, below which equal means say nothing.
Measured FromScatter(std::span<const double> means, std::int64_t n, double confidence,
                     double step) {
    Moments moments;
    for (const double mean : means) moments.Add(mean);
    const double R = double(means.size());
    Estimate estimate = moments.Estimate();
    estimate.standard_error =
        std::max(estimate.standard_error, step / (double(n) * std::sqrt(12 * R)));
    const double half = HalfWidth(estimate, confidence);
    return {
        .value = estimate.mean,
        .standard_error = estimate.standard_error,
        .interval = {.low = std::max(0.0, estimate.mean - half), .high = estimate.mean + half}};
}

}  // namespace

Measured FromMeans(std::span<const double> means, std::int64_t n, double confidence) {
    Measured measured = FromScatter(means, n, confidence, 1);
    measured.interval.high = std::min(1.0, measured.interval.high);
    return measured;
}

Measured FromUnboundedMeans(std::span<const double> means, std::int64_t n, double confidence) {
    const double largest = *std::max_element(means.begin(), means.end());
    return FromScatter(means, n, confidence, largest);
}

Measured FromCounts(std::span<const std::uint32_t> successes, std::int64_t n,
                    double confidence) {
    std::vector<double> means;
    means.reserve(successes.size());
    for (const std::uint32_t count : successes) means.push_back(double(count) / double(n));
    Measured measured = FromMeans(means, n, confidence);
    const std::int64_t trials = n * std::int64_t(successes.size());
    const std::int64_t all =
        std::accumulate(successes.begin(), successes.end(), std::int64_t{0});
    if (all == 0 || all == trials) {
        measured.interval = ClopperPearsonInterval(all, trials, confidence);
    }
    return measured;
}

}  // namespace plumb
