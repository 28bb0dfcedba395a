// What n trials with k successes say about the probability of success, and how many tests may
// share one risk of a false alarm.
//
//       Wilson           (p + z^2/2n +- z sqrt(p (1-p)/n + z^2/4n^2)) / (1 + z^2/n),   p = k/n
//       Clopper-Pearson  [ B(a/2; k, n-k+1),  B(1 - a/2; k+1, n-k) ],     a = 1 - confidence
//       Sidak            p_1 = 1 - (1 - p)^(1/m)
//
// with z the normal quantile and B the beta quantile. Clopper-Pearson covers the truth at least
// as often as it says, for every n; Wilson does so on average, and is shorter.
//
// Source   [Wilson27] E. B. Wilson, J. Am. Stat. Assoc. 22, 1927. [Clopper34] C. Clopper,
//          E. Pearson, Biometrika 26, 1934. [Sidak67] Z. Sidak, J. Am. Stat. Assoc. 62, 1967.
#pragma once

#include <cstdint>

namespace plumb {

struct Interval {
    double low = 0, high = 1;
};

/// For `successes` of `trials` > 0, each in [0, trials].
Interval WilsonInterval(std::int64_t successes, std::int64_t trials, double confidence);
Interval ClopperPearsonInterval(std::int64_t successes, std::int64_t trials, double confidence);

/// The level of each of m independent tests whose common level is p: P(any false alarm) = p.
double SidakLevel(double p, std::int64_t tests);

}  // namespace plumb
