// The oracle: the fewest samples that any metric could have used, the variance of each pixel known.
//
//       MSE = 1/P Sum_p v_p f(k_p)  <=  target,      Sum_p k_p least,  1 <= k_p <= n
//
//       f(k) = 1/k                          k independent samples of the pixel
//       f(k) = (n - k) / ((n - 1) k)        k of the n samples of its window, none twice
//
// f is convex and every sample costs the same, so the greedy choice is the best one: each sample goes
// where it lowers the error most, v_p (f(k) - f(k + 1)), until the target is met. It is found without
// sorting, by the gain of the last sample taken: all gains above it are taken, and of those equal to
// it as many as are needed, by rows.
//
//       share of the gain = (uniform - used) / (uniform - oracle)       samples, at one MSE
//
// tells how much of what can be saved a metric saves: 1 as the oracle, 0 as if every pixel had the
// same number, below 0 if that had been better.
//
// Source   ours; the least samples for a given variance are Neyman's allocation, k ~ sqrt v, which
//          the greedy one rounds.
// Symbols  P pixels, v_p variance of one sample of pixel p, k_p samples of it, n most of them.
// Domain   v finite, >= 0. n in [1, 255]. The target is met to the rounding of a sum of P numbers.
// Beware   An expectation: samples at random. One order of taking them, as an index matrix has,
//          may do better or worse on a given picture.
#pragma once

#include <cstdint>

#include "core/image.h"

namespace plumb {

/// How samples are drawn: f.
enum class SampleDraw { kIndependent, kOfWindow };

struct Allocation {
    Image<std::uint8_t> counts;  ///< k_p. [1, n]
    std::int64_t samples = 0;    ///< Sum_p k_p
    double mse = 0;
    /// False: n samples wherever they help are too few for the target, or fewer than may be used.
    bool reached = true;
};

/// Population variance of the window's samples, mean over the three colours: v for kOfWindow.
Image<double> WindowVariances(const Image<Rgb>& samples, int m);

/// MSE of counts in [1, n]. 0 without pixels. Throws Error if sizes, n, a variance or a count are
/// out of range.
double ExpectedMse(const Image<double>& v, const Image<std::uint8_t>& counts, int n,
                   SampleDraw draw);

/// The fewest samples whose MSE is at most `target_mse` >= 0.
Allocation LeastSamples(const Image<double>& v, int n, double target_mse, SampleDraw draw);

/// The least MSE with at most `samples` of them, between one a pixel and n a pixel. None is given
/// where it brings nothing.
Allocation LeastError(const Image<double>& v, int n, std::int64_t samples, SampleDraw draw);

/// A metric beside the oracle, all at the metric's own MSE.
struct OracleShare {
    double mse = 0;
    double used = 0, oracle = 0, uniform = 0;  ///< Samples a pixel; uniform: a real number.
    double share = 1;                          ///< NaN where there is nothing to gain.
};

OracleShare ShareOfGain(const Image<double>& v, const Image<std::uint8_t>& counts, int n,
                        SampleDraw draw);

}  // namespace plumb
