// Images made for the tests, and their one risk of a false alarm.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/distributions.h"
#include "core/image.h"
#include "core/intervals.h"
#include "core/random.h"

namespace plumb {

/// The chance that an honest program fails any of the statistical tests of score_test: 1e-3,
/// shared among at most 64 comparisons. All seeds are fixed, so what passes once passes
/// always.
inline const double kLevel = SidakLevel(1e-3, 64);
inline const double kSigmas = NormalQuantile(1 - kLevel / 2);

/// A standard normal number of its own for every (seed, pixel, sample), by Box and Muller.
inline double MadeNormal(std::uint64_t seed, std::uint64_t pixel, std::uint64_t sample) {
    const double u = 1 - RandomUnit(seed, pixel, sample, 0);  // In (0, 1].
    const double v = RandomUnit(seed, pixel, sample, 1);
    return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
}

template <class T, class Value>
Image<T> MadeImage(int width, int height, const Value& value) {
    Image<T> image(width, height);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) image(i, j) = T(value(i, j));
    return image;
}

/// White noise, summed over `reach` x `reach` pixels and scaled to variance 1: normal, and
/// correlated as far as `reach` pixels.
inline Image<float> CorrelatedNoise(int width, int height, int reach, std::uint64_t seed,
                                    std::uint64_t sample) {
    const int w = width + reach - 1, h = height + reach - 1;
    const auto white = MadeImage<float>(
        w, h, [&](int i, int j) { return MadeNormal(seed, std::uint64_t(j) * w + i, sample); });
    const auto rows = MadeImage<float>(width, h, [&](int i, int j) {
        double sum = 0;
        for (int k = 0; k < reach; ++k) sum += white(i + k, j);
        return sum;
    });
    return MadeImage<float>(width, height, [&](int i, int j) {
        double sum = 0;
        for (int k = 0; k < reach; ++k) sum += rows(i, j + k);
        return sum / reach;
    });
}

}  // namespace plumb
