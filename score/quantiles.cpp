#include "score/quantiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "score/pixels.h"

namespace plumb {
namespace {

/// Element ceil(p n) of n sorted numbers, counted from 1.
double Sorted(const std::vector<float>& values, double p) {
    const double place = std::ceil(std::clamp(p, 0.0, 1.0) * double(values.size()));
    return values[std::size_t(std::max(place, 1.0)) - 1];
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
    std::vector<std::vector<float>> tiles(std::size_t(tiling.Count()));
    ForEachCounted(
        tiling, {}, int(truth.size()), mask, [&](int tile, int c, int i, int j, double) {
            const double d = FinitePixel(candidate[std::size_t(c)], i, j, "candidate") -
                             FinitePixel(truth[std::size_t(c)], i, j, "truth");
            tiles[std::size_t(tile)].push_back(float(std::abs(d)));
        });
    std::vector<float> all;
    std::vector<std::int64_t> n;
    for (std::vector<float>& tile : tiles) {
        std::sort(tile.begin(), tile.end());
        all.insert(all.end(), tile.begin(), tile.end());
        n.push_back(std::int64_t(tile.size()));
    }
    std::vector<Measured> quantiles(shares.size());
    if (all.empty()) return quantiles;
    std::sort(all.begin(), all.end());
    for (std::size_t k = 0; k < shares.size(); ++k) {
        Measured& quantile = quantiles[k];
        quantile.value = Sorted(all, shares[k]);
        std::vector<double> below;
        for (const std::vector<float>& tile : tiles) {
            below.push_back(
                double(std::upper_bound(tile.begin(), tile.end(), float(quantile.value)) -
                       tile.begin()));
        }
        const Measured share = RatioOverTiles(tiling, below, n, options.confidence);
        const double half = (share.interval.high - share.interval.low) / 2;
        if (!std::isfinite(half)) continue;
        quantile.interval = {Sorted(all, shares[k] - half), Sorted(all, shares[k] + half)};
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
