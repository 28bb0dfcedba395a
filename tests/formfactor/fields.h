// Surfaces and statistics that the tests of this room share.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/distributions.h"
#include "core/error.h"
#include "core/intervals.h"
#include "core/random.h"
#include "core/statistics.h"
#include "formfactor/links.h"
#include "heightfield/facet.h"
#include "heightfield/height_field.h"

namespace plumb {

/// Heights at random: every texel in [0, amplitude_m], unequal spacings.
inline HeightField RoughField(int width, int height, double amplitude_m,
                              Boundary boundary = Boundary::kWrap,
                              Diagonal diagonal = Diagonal::kRising, double s_x = 1,
                              double s_y = 1.25) {
    Image<double> heights(width, height);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i)
            heights(i, j) = amplitude_m * RandomUnit(101, std::uint64_t(j * width + i), 0, 0);
    return HeightField(std::move(heights), s_x, s_y, boundary, diagonal);
}

/// A V is what is left of 1 by weights rounded to float, each by half a unit in its last place
/// at most: 2^-24 of the row's sum, and the sum is at most 1.
inline constexpr double kFloatRow = 0x1p-24;

/// The chance that an honest program fails any of the statistical tests of formfactor_test:
/// 1e-3, shared among at most 20 000 comparisons. All seeds are fixed.
inline const double kLevel = SidakLevel(1e-3, 20000);

/// How far `replicates` independent values of a quantity stand from `expected`, in units of
/// what chance allows at kLevel (Student's t); up to 1 is fine. `bias` is allowed besides.
inline double Excess(const Moments& replicates, double expected, double bias) {
    const double chance = replicates.HalfWidth(1 - kLevel);
    const double off = std::abs(replicates.Mean() - expected) - bias;
    return off <= 0 ? 0 : off / chance;
}

/// F_ij of row i as (j, weight), in order.
inline std::vector<std::pair<std::uint32_t, double>> RowOf(const Links& links, std::int64_t i) {
    const LinkBlock& block = links.blocks[std::size_t(i / Links::kFacetsPerBlock)];
    const std::size_t r = std::size_t(i % Links::kFacetsPerBlock);
    std::vector<std::pair<std::uint32_t, double>> row;
    for (std::uint32_t k = block.row_begin[r]; k < block.row_begin[r + 1]; ++k) {
        row.emplace_back(block.facet[k], double(block.weight[k]));
    }
    return row;
}

/// Sum_j F_ij.
inline double RowSum(const Links& links, std::int64_t i) {
    double sum = 0;
    for (const auto& [j, weight] : RowOf(links, i)) sum += weight;
    return sum;
}

inline std::string MessageOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& e) {
        return e.what();
    }
    return "no error";
}

}  // namespace plumb
