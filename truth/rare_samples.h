// The interval of a mean that few of its samples decide, where the scatter of nets says little.
//
// Samples z >= 0 of which most are 0, over R nets of n points, N = R n (of samples in a range
// [least, most] the z are x - least or most - x, whichever fewer decide):
//
//       y = Sum z,  v = Sum z^2,   k = y^2 / v          how many samples decide: their number
//                                                       if all that are not 0 are the same
//       phi  = ( s^2 / s_N^2 + 1 ) / R, <= 1      scatter s^2 of the nets' sums over that
//                                                       of independent ones, s_N^2 = (v - y^2/N) / R
//       low  = v/y    B( a/2;   (k + 1/2)/phi',  ... )  B quantile of beta
//       high = v'/y'  B( 1-a/2; ... ),                  y' = y + phi M/2,  v' = v + phi M^2/2
//
// with k / phi and N / phi in place of k and N, a = 1 - confidence, M the largest z that is
// possible above, the largest that was met below. For yes and
// no (z is 1 or 0) and phi = 1 this is the interval of Jeffreys, its low end that of Clopper and
// Pearson where k = 1; where k = 0 the interval is theirs: [0, 1 - (a/2)^(1/N)] of the range
// that is possible.
//
// Source   Jeffreys' interval with the changes near 0 that [Brown01] recommend; its use for
//          weighted counts after [Fay97], M/2 in place of M as Jeffreys' 1/2 is in that of 1.
//          phi and from how many samples on the nets' own scatter does better are ours: the
//          pair was chosen on V and bounces at 1 to 24 expected counts, and is tested on every kind
//          of value in tests/truth/coverage_test.cpp.
// Beware   Counts are whole, so no interval covers a rare value exactly as often as it says;
//          at 2 to 24 expected counts this one covers 92 to 98.5 %, on average over values 95.
//          What no sample has met, such as a small sun, is in no interval.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "core/intervals.h"

namespace plumb {

/// What single samples were, beside the sums of the nets.
struct SampleSpread {
    double squares = 0;  ///< Sum x^2.
    double least = std::numeric_limits<double>::infinity();
    double most = -std::numeric_limits<double>::infinity();

    void Add(double x, double times = 1) {
        squares += times * x * x;
        least = x < least ? x : least;
        most = x > most ? x : most;
    }
    /// Whether they differ by no more than rounding.
    bool AllAlike() const {
        constexpr double kRelative = 1e-5;
        return !(most - least > kRelative * std::max(std::abs(least), std::abs(most)));
    }
    void Merge(const SampleSpread& later) {
        squares += later.squares;
        least = later.least < least ? later.least : least;
        most = later.most > most ? later.most : most;
    }
};

/// As few samples as this, or fewer, decide a rare mean.
inline constexpr double kFewSamples = 12;

/// Of the mean of samples in [possible.low, possible.high]: sums[r] over the n points of net r.
/// Nothing if more than a few samples decide.
std::optional<Interval> RareInterval(std::span<const double> sums, std::int64_t n,
                                     const SampleSpread& spread, const Interval& possible,
                                     double confidence);

}  // namespace plumb
