// Sums of colours over the points of every receiver (or pixel) and net.
#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <vector>

#include "truth/replicates.h"

namespace plumb {

struct RgbSums {
    int replicates = 0;
    std::int64_t points = 0;
    std::vector<std::array<double, 3>> sum;  ///< [receiver * replicates + replicate]

    /// Of one colour, 0 ... 2.
    Measured Of(std::int64_t receiver, std::size_t colour,
                double confidence = kConfidence) const {
        std::vector<double> means;
        for (int r = 0; r < replicates; ++r) {
            means.push_back(sum[std::size_t(receiver * replicates + r)][colour] /
                            double(points));
        }
        return FromUnboundedMeans(means, points, confidence);
    }

    /// Adds later points of the same nets.
    void Merge(const RgbSums& later) {
        assert(later.sum.size() == sum.size() && later.replicates == replicates);
        for (std::size_t i = 0; i < sum.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) sum[i][c] += later.sum[i][c];
        }
        points += later.points;
    }
};

}  // namespace plumb
