// How often everything is measured, and how sure that makes us.
//
//       X_r    = 1/n Sum_s x(net r, point s)                      r = 1 ... R
//       X      = mean of X_r,   se = sd of X_r / sqrt(R)
//       interval X +- t_{R-1} se
//
// Each of the R nets is an independent Owen scramble of the same n Sobol points, so the X_r are
// independent and unbiased, and their scatter is the whole error: a net's own samples are
// dependent, and their scatter says nothing (2.8 times too much, as measured).
//
// Where few samples decide, or none, the scatter says little: the interval is then that of
// truth/rare_samples.h, and not even about X. Where counts only happen to be equal, se is kept
// above what rounding to counts hides: 1 / (n sqrt(12 R)) of the range of the samples.
//
// Source   [Owen95] for the nets; R = 8 gave the narrowest honest interval of those tried at
//          R n = 1024 (4, 8, 16, 32): tests/truth/replicates_test.cpp checks its coverage.
// Beware   A net is even at powers of two: double n, do not add to it.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "core/intervals.h"
#include "core/measured.h"
#include "core/monitor.h"
#include "truth/rare_samples.h"

namespace plumb {

/// Which samples to take of every receiver.
struct NetSampling {
    int replicates = 8;      ///< R, independent nets. [2, 1024]
    std::int64_t first = 0;  ///< First point of each net: goes on where an earlier call ended.
    std::int64_t points = 64;  ///< n, points of each net. [1, 2^32 - first]
    std::uint64_t seed = 1;
};

/// Throws Error, naming field, value and rule.
void Validate(const NetSampling& sampling);

/// Calls work(part) for parts of the sampling, one after the other, of few enough points that
/// the memory of their rays stays small and a cancelled run ends soon: Interrupted is thrown
/// between them.
void InParts(const NetSampling& sampling, const Monitor& monitor,
             const std::function<void(const NetSampling& part)>& work);

/// Throws Interrupted if the monitor says so.
void CheckCancelled(const Monitor& monitor);

/// Which pair of a net's dimensions serves what: the first is the evenest, and the first direction
/// has the edges.
inline constexpr std::uint32_t kFirstDirection = 0, kPlace = 1, kLaterDirections = 2;

/// The seed of one net of one receiver.
std::uint64_t NetSeed(std::uint64_t seed, std::int64_t receiver, int replicate);

inline constexpr double kConfidence = 0.95;

/// Of a share: successes[r] of n points of net r.
Measured FromCounts(std::span<const std::uint32_t> successes, std::int64_t n,
                    double confidence = kConfidence);

/// Of the mean of values in [0, 1]: sums[r] over the n points of net r.
Measured FromSums(std::span<const double> sums, std::int64_t n, const SampleSpread& spread,
                  double confidence = kConfidence);

/// Of the mean of values >= 0 without an upper bound, such as radiances. `ceiling`: the largest
/// value that was met anywhere, which a sample that was not taken might have had.
Measured FromUnboundedSums(std::span<const double> sums, std::int64_t n,
                           const SampleSpread& spread, double ceiling,
                           double confidence = kConfidence);

}  // namespace plumb
