// A low rough floor with towers: most of it is skipped, and nothing of it may be stepped through.
#pragma once

#include <utility>

#include "core/random.h"
#include "heightfield/height_field.h"

namespace plumb {

inline HeightField SpikyField(int width, int height, Boundary boundary, Diagonal diagonal,
                              double tower_m = 6) {
    Image<double> heights(width, height);
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
            const std::uint64_t texel = std::uint64_t(j) * std::uint64_t(width) + i;
            heights(i, j) = 0.3 * RandomUnit(5, texel, 0, 0);
            if (RandomUnit(5, texel, 1, 0) < 0.03) heights(i, j) += tower_m;
        }
    }
    return HeightField(std::move(heights), 1, 1.25, boundary, diagonal);
}

}  // namespace plumb
