#include "truth/rare_samples.h"

#include <algorithm>
#include <cmath>

#include "core/distributions.h"
#include "core/statistics.h"

namespace plumb {
namespace {

// Samples z >= 0, most of them 0.
struct Deciding {
    double y, v, most;

    double Count() const { return y > 0 && v > 0 ? y * y / v : 0; }
};

double Dispersion(std::span<const double> sums, double N, const Deciding& z) {
    const double R = double(sums.size());
    Moments moments;
    for (const double sum : sums) moments.Add(sum);
    const double independent = (z.v - z.y * z.y / N) / R;
    return std::min(1.0, ((R - 1) * moments.Variance() / independent + 1) / R);
}

// The interval of y / N.
Interval OfFew(const Deciding& z, double N, double phi, double confidence) {
    const double tail = (1 - confidence) / 2, k = z.Count();
    // Jeffreys' half a count more; Clopper's and Pearson's none where one sample decides.
    const double more = std::clamp((k - 1) / 2, 0.0, 0.5);
    const double low = z.v / z.y * BetaQuantile(tail, k / phi + more, (N - k) / phi + 1 - more);

    const double y = z.y + phi * z.most / 2, v = z.v + phi * z.most * z.most / 2;
    const double k_high = y * y / v;
    const double high =
        v / y * BetaQuantile(1 - tail, k_high / phi, std::max(0.5, (N - k_high) / phi + 1));
    return {.low = low, .high = high};
}

}  // namespace

std::optional<Interval> RareInterval(std::span<const double> sums, std::int64_t n,
                                     const SampleSpread& spread, const Interval& possible,
                                     double confidence) {
    const double N = double(n) * double(sums.size());
    if (spread.AllAlike()) {
        const double share = -std::expm1(std::log((1 - confidence) / 2) / N);
        return Interval{
            .low = spread.least - share * std::max(0.0, spread.least - possible.low),
            .high = spread.most + share * std::max(0.0, possible.high - spread.most)};
    }
    double y = 0;
    for (const double sum : sums) y += sum;
    const double a = spread.least, b = spread.most;
    const Deciding above{y - N * a, spread.squares - 2 * a * y + N * a * a,
                         std::max(b, possible.high) - a};
    const Deciding below{N * b - y, spread.squares - 2 * b * y + N * b * b, b - a};
    const bool few_above = above.Count() <= below.Count();
    const Deciding& z = few_above ? above : below;
    if (z.Count() >= kFewSamples) return std::nullopt;
    const Interval of_z = OfFew(z, N, Dispersion(sums, N, z), confidence);
    if (few_above) {
        return Interval{.low = a + of_z.low, .high = std::min(possible.high, a + of_z.high)};
    }
    return Interval{.low = std::max(possible.low, b - of_z.high), .high = b - of_z.low};
}

}  // namespace plumb
