// Sums of colours over the points of every receiver (or pixel) and net.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <vector>

#include "truth/replicates.h"

namespace plumb {

struct RgbSums {
    int replicates = 0;
    std::int64_t points = 0;
    std::vector<std::array<double, 3>> sum;           ///< [receiver * replicates + replicate]
    std::vector<std::array<SampleSpread, 3>> spread;  ///< [receiver]
    std::array<double, 3> ceiling{};                  ///< The largest sample of all receivers.

    RgbSums() = default;
    RgbSums(std::int64_t receivers, int replicates_in, std::int64_t points_in)
        : replicates(replicates_in),
          points(points_in),
          sum(std::size_t(receivers * replicates_in)),
          spread(std::size_t(receivers)) {}

    /// To be called when all samples are in.
    void FindCeiling() {
        for (const std::array<SampleSpread, 3>& of : spread) {
            for (std::size_t c = 0; c < 3; ++c) ceiling[c] = std::max(ceiling[c], of[c].most);
        }
    }

    /// Of one colour, 0 ... 2.
    Measured Of(std::int64_t receiver, std::size_t colour,
                double confidence = kConfidence) const {
        std::vector<double> sums;
        for (int r = 0; r < replicates; ++r) {
            sums.push_back(sum[std::size_t(receiver * replicates + r)][colour]);
        }
        return FromUnboundedSums(sums, points, spread[std::size_t(receiver)][colour],
                                 ceiling[colour], confidence);
    }

    /// Adds later points of the same nets.
    void Merge(const RgbSums& later) {
        assert(later.sum.size() == sum.size() && later.replicates == replicates);
        for (std::size_t i = 0; i < sum.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) sum[i][c] += later.sum[i][c];
        }
        for (std::size_t i = 0; i < spread.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) spread[i][c].Merge(later.spread[i][c]);
        }
        for (std::size_t c = 0; c < 3; ++c) ceiling[c] = std::max(ceiling[c], later.ceiling[c]);
        points += later.points;
    }
};

}  // namespace plumb
