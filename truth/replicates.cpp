#include "truth/replicates.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/distributions.h"
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

void CheckCancelled(const Monitor& monitor) {
    if (monitor.Cancelled()) throw Interrupted();
}

void InParts(const NetSampling& sampling, const Monitor& monitor,
             const std::function<void(const NetSampling& part)>& work) {
    constexpr std::int64_t kPoints = 256;
    NetSampling part = sampling;
    for (std::int64_t done = 0; done < sampling.points; done += part.points) {
        if (done > 0) CheckCancelled(monitor);
        part.first = sampling.first + done;
        part.points = std::min(kPoints, sampling.points - done);
        work(part);
    }
}

namespace {

// Student's t; the usual one is made once.
double StudentFactor(std::size_t replicates, double confidence) {
    const auto factor = [](double level, double dof) {
        return StudentQuantile((1 + level) / 2, dof);
    };
    constexpr std::size_t kUsual = 8;
    static const double usual = factor(kConfidence, kUsual - 1);
    return replicates == kUsual && confidence == kConfidence
               ? usual
               : factor(confidence, double(replicates) - 1);
}

// `step`: what one sample more or less counts, below which equal means say nothing, if the
// samples' range does not tell.
Measured FromScatter(std::span<const double> sums, std::int64_t n, const SampleSpread& spread,
                     const Interval& possible, double step, double confidence) {
    Moments moments;
    for (const double sum : sums) moments.Add(sum / double(n));
    const double R = double(sums.size());
    if (!spread.AllAlike()) step = spread.most - spread.least;
    const double error =
        std::max(moments.StandardError(), step / (double(n) * std::sqrt(12 * R)));
    const double mean = moments.Mean();
    const auto rare = RareInterval(sums, n, spread, possible, confidence);
    if (rare) return {.value = mean, .standard_error = error, .interval = *rare};
    const double half = StudentFactor(sums.size(), confidence) * error;
    return {.value = mean,
            .standard_error = error,
            .interval = {.low = std::max(possible.low, mean - half), .high = mean + half}};
}

}  // namespace

Measured FromSums(std::span<const double> sums, std::int64_t n, const SampleSpread& spread,
                  double confidence) {
    Measured measured = FromScatter(sums, n, spread, {.low = 0, .high = 1}, 1, confidence);
    measured.interval.high = std::min(1.0, measured.interval.high);
    return measured;
}

Measured FromUnboundedSums(std::span<const double> sums, std::int64_t n,
                           const SampleSpread& spread, double ceiling, double confidence) {
    const double largest = *std::max_element(sums.begin(), sums.end()) / double(n);
    return FromScatter(sums, n, spread, {.low = 0, .high = ceiling}, largest, confidence);
}

Measured FromCounts(std::span<const std::uint32_t> successes, std::int64_t n,
                    double confidence) {
    const std::vector<double> sums(successes.begin(), successes.end());
    const std::int64_t all =
        std::accumulate(successes.begin(), successes.end(), std::int64_t{0});
    SampleSpread spread;
    if (all > 0) spread.Add(1, double(all));
    if (const std::int64_t none = n * std::int64_t(sums.size()) - all; none > 0) {
        spread.Add(0, double(none));
    }
    return FromSums(sums, n, spread, confidence);
}

}  // namespace plumb
