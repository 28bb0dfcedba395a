#include "core/intervals.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/distributions.h"

namespace plumb {

Interval WilsonInterval(std::int64_t successes, std::int64_t trials, double confidence) {
    assert(trials > 0 && 0 <= successes && successes <= trials);
    const double n = double(trials), p = double(successes) / n;
    const double z = NormalQuantile((1 + confidence) / 2), z2_n = z * z / n;
    const double centre = p + z2_n / 2;
    const double half = z * std::sqrt((p * (1 - p) + z2_n / 4) / n);
    return {.low = successes == 0 ? 0 : (centre - half) / (1 + z2_n),
            .high = successes == trials ? 1 : (centre + half) / (1 + z2_n)};
}

Interval ClopperPearsonInterval(std::int64_t successes, std::int64_t trials,
                                double confidence) {
    assert(trials > 0 && 0 <= successes && successes <= trials);
    const double k = double(successes), n = double(trials), tail = (1 - confidence) / 2;
    return {.low = successes == 0 ? 0 : BetaQuantile(tail, k, n - k + 1),
            .high = successes == trials ? 1 : BetaQuantile(1 - tail, k + 1, n - k)};
}

double SidakLevel(double p, std::int64_t tests) {
    assert(0 < p && p < 1 && tests > 0);
    return -std::expm1(std::log1p(-p) / double(tests));
}

}  // namespace plumb
