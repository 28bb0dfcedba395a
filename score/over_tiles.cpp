#include "score/over_tiles.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/distributions.h"

namespace plumb {

Tiling::Tiling(int width, int height, int tile)
    : width_px(width), height_px(height), tile_px(tile) {
    assert(width > 0 && height > 0 && tile >= 0);
    constexpr double kTiles = 256;
    if (tile_px == 0) {
        tile_px = std::max(1, int(std::sqrt(double(width) * height / kTiles)));
    }
}

namespace {

struct PairSums {
    double own = 0;      ///< Of each tile with itself.
    double flat = 0;     ///< With its neighbours, all alike.
    double tapered = 0;  ///< With weights 1, 1/2, 1/4: never negative.
    double pairs = 0;    ///< How many are in `flat`.
};

PairSums SumsOfPairs(const Tiling& tiling, const std::vector<double>& z,
                     const std::vector<std::int64_t>& n) {
    PairSums sums;
    for (int row = 0; row < tiling.Rows(); ++row) {
        for (int column = 0; column < tiling.Columns(); ++column) {
            const int b = row * tiling.Columns() + column;
            if (n[b] == 0) continue;
            sums.own += z[b] * z[b];
            for (int dr = -1; dr <= 1; ++dr) {
                for (int dc = -1; dc <= 1; ++dc) {
                    const int r = row + dr, c = column + dc;
                    if (r < 0 || r >= tiling.Rows() || c < 0 || c >= tiling.Columns()) continue;
                    const int other = r * tiling.Columns() + c;
                    if (n[other] == 0) continue;
                    sums.flat += z[b] * z[other];
                    sums.tapered += z[b] * z[other] / ((1 + dr * dr) * (1 + dc * dc));
                    ++sums.pairs;
                }
            }
        }
    }
    return sums;
}

}  // namespace

Measured RatioOverTiles(const Tiling& tiling, const std::vector<double>& y,
                        const std::vector<std::int64_t>& n, double confidence) {
    assert(y.size() == std::size_t(tiling.Count()) && n.size() == y.size());
    assert(confidence > 0 && confidence < 1);
    double Y = 0, N = 0, n2 = 0, B = 0;
    for (std::size_t b = 0; b < y.size(); ++b) {
        Y += y[b];
        N += double(n[b]);
        n2 += double(n[b]) * double(n[b]);
        B += n[b] > 0;
    }
    Measured figure{.standard_error = std::numeric_limits<double>::infinity()};
    if (B == 0) return figure;
    figure.value = Y / N;
    if (B < 2) return figure;

    std::vector<double> z(y.size());
    for (std::size_t b = 0; b < y.size(); ++b) z[b] = (y[b] - figure.value * double(n[b])) / N;
    const PairSums sums = SumsOfPairs(tiling, z, n);
    const double effective = N * N / n2;
    double dof = effective * B / sums.pairs - 1;
    double squares = std::max(sums.flat, sums.tapered) * B * B / (B * B - sums.pairs);
    if (sums.pairs > B * B / 2) {  // Nearly every tile is every other's neighbour.
        dof = effective - 1;
        squares = sums.own * B / (B - 1);
    }
    figure.standard_error = std::sqrt(squares);
    // With one tile that outweighs all others there is no scatter to speak of.
    const double half =
        StudentQuantile(0.5 + confidence / 2, std::max(dof, 0.1)) * figure.standard_error;
    figure.interval = {figure.value - half, figure.value + half};
    return figure;
}

}  // namespace plumb
