#include "score/quantiles.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/error.h"
#include "core/parallel.h"
#include "score/pixels.h"

namespace plumb {
namespace {

using Tiles = std::vector<std::vector<float>>;  // Each sorted, of numbers >= 0.

std::int64_t CountUpTo(const std::vector<float>& sorted, float value) {
    return std::upper_bound(sorted.begin(), sorted.end(), value) - sorted.begin();
}

/// Element ceil(p n) of all n numbers, counted from 1. Floats >= 0 have the order of their bits:
/// one bit after the other, from the highest.
double Ranked(const Tiles& tiles, std::int64_t n, double p) {
    const double place = std::max(std::ceil(std::clamp(p, 0.0, 1.0) * double(n)), 1.0);
    std::uint32_t below = 0;  // Less than `place` numbers lie under what follows it.
    for (int bit = 30; bit >= 0; --bit) {
        const std::uint32_t tried = below | std::uint32_t{1} << bit;
        std::int64_t count = 0;
        for (const std::vector<float>& tile : tiles)
            count += CountUpTo(tile, std::bit_cast<float>(tried - 1));
        if (double(count) < place) below = tried;
    }
    return std::bit_cast<float>(below);
}

std::vector<float> CountedOf(const Image<float>& map, const Mask& mask) {
    std::vector<float> values;
    for (std::size_t p = 0; p < map.Pixels().size(); ++p) {
        if (mask.Empty() || mask.Pixels()[p] != 0) values.push_back(map.Pixels()[p]);
    }
    return values;
}

}  // namespace

std::vector<Measured> AbsoluteErrorQuantiles(ChannelSpan candidate, ChannelSpan truth,
                                             std::span<const double> shares, const Mask& mask,
                                             const ErrorOptions& options) {
    Validate(options);
    CheckChannels({candidate}, truth, {}, mask);
    for (const double share : shares) {
        if (!(share > 0 && share <= 1)) throw Error(MustBe("share", share, "in (0, 1]"));
    }
    const Tiling tiling(truth[0].Width(), truth[0].Height(), options.tile_px);
    Tiles tiles(std::size_t(tiling.Count()));
    ForEachCounted(
        tiling, {}, int(truth.size()), mask, [&](int tile, int c, int i, int j, double) {
            const double d = FinitePixel(candidate[std::size_t(c)], i, j, "candidate") -
                             FinitePixel(truth[std::size_t(c)], i, j, "truth");
            tiles[std::size_t(tile)].push_back(float(std::abs(d)));
        });
    ParallelFor(tiling.Count(), 1, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t b = begin; b < end; ++b)
            std::sort(tiles[std::size_t(b)].begin(), tiles[std::size_t(b)].end());
    });
    std::vector<std::int64_t> n;
    std::int64_t all = 0;
    for (const std::vector<float>& tile : tiles) {
        n.push_back(std::int64_t(tile.size()));
        all += n.back();
    }
    std::vector<Measured> quantiles(shares.size());
    if (all == 0) return quantiles;
    for (std::size_t k = 0; k < shares.size(); ++k) {
        Measured& quantile = quantiles[k];
        quantile.value = Ranked(tiles, all, shares[k]);
        std::vector<double> below;
        for (const std::vector<float>& tile : tiles)
            below.push_back(double(CountUpTo(tile, float(quantile.value))));
        const Measured share = RatioOverTiles(tiling, below, n, options.confidence);
        const double half = (share.interval.high - share.interval.low) / 2;
        if (!std::isfinite(half)) continue;
        quantile.interval = {Ranked(tiles, all, shares[k] - half),
                             Ranked(tiles, all, shares[k] + half)};
    }
    return quantiles;
}

std::vector<double> WeightedQuantiles(const Image<float>& map, std::span<const double> shares,
                                      const Mask& mask) {
    std::vector<float> values = CountedOf(map, mask);
    std::sort(values.begin(), values.end());
    double all = 0;
    for (const float value : values) all += value;
    std::vector<double> quantiles;
    for (const double share : shares) {
        double sum = 0, quantile = std::numeric_limits<double>::quiet_NaN();
        for (const float value : values) {
            quantile = value;
            sum += value;
            if (sum > share * all) break;
        }
        quantiles.push_back(quantile);
    }
    return quantiles;
}

std::vector<double> BinnedWeightedQuantiles(const Image<float>& map,
                                            std::span<const double> shares, const Mask& mask) {
    constexpr int kBins = 100;
    std::array<double, kBins> weight{};
    double all = 0;
    for (const float value : CountedOf(map, mask)) {
        const int bin = std::clamp(int(double(value) * kBins), 0, kBins - 1);
        weight[std::size_t(bin)] += (bin + 0.5) / kBins;
        all += (bin + 0.5) / kBins;
    }
    std::vector<double> quantiles;
    for (const double share : shares) {
        double sum = 0, quantile = std::numeric_limits<double>::quiet_NaN();
        for (int bin = 0; bin < kBins && std::isnan(quantile); ++bin) {
            const double w = weight[std::size_t(bin)];
            if (w > 0 && sum + w > share * all)
                quantile = (bin + (share * all - sum) / w) / kBins;
            sum += w;
        }
        quantiles.push_back(quantile);
    }
    return quantiles;
}

}  // namespace plumb
