#include "score/errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "core/distributions.h"
#include "core/error.h"
#include "core/intervals.h"
#include "score/pixels.h"

namespace plumb {
namespace {

struct TileSums {
    std::int64_t n = 0;
    double d = 0, abs_d = 0, d2_less_s2 = 0;
    double s2 = 0, v = 0, abs_bias = 0;
    double max = -1;
    int max_column = 0, max_row = 0, max_channel = 0;
};

std::vector<std::int64_t> Counts(const std::vector<TileSums>& tiles) {
    std::vector<std::int64_t> n;
    for (const TileSums& tile : tiles) n.push_back(tile.n);
    return n;
}

std::vector<double> Sums(const std::vector<TileSums>& tiles, double TileSums::*member) {
    std::vector<double> y;
    for (const TileSums& tile : tiles) y.push_back(tile.*member);
    return y;
}

double Total(const std::vector<TileSums>& tiles, double TileSums::*member) {
    double sum = 0;
    for (const TileSums& tile : tiles) sum += tile.*member;
    return sum;
}

/// Throws Error where anything does not fit.
std::vector<TileSums> SumTiles(const Tiling& tiling, ChannelSpan candidate, ChannelSpan truth,
                               ChannelSpan standard_error, const Mask& mask,
                               const ErrorOptions& options) {
    const double nu = options.truth_dof;
    const double s4_factor =
        std::isinf(nu) ? -2 : -4 + (2 + 10 / nu) * nu / (nu + 2);  // Of v, see the header.

    std::vector<TileSums> tiles(tiling.Count());
    const auto add = [&](TileSums& sums, int channel, int i, int j, double s2) {
        const double d = FinitePixel(candidate[channel], i, j, "candidate") -
                         FinitePixel(truth[channel], i, j, "truth");
        const double d2 = d * d;
        ++sums.n;
        sums.d += d;
        sums.abs_d += std::abs(d);
        sums.d2_less_s2 += d2 - s2;
        sums.s2 += s2;
        sums.v += 4 * d2 * s2 + s4_factor * s2 * s2;
        if (s2 > 0) {
            sums.abs_bias +=
                2 * std::numbers::inv_sqrtpi * std::sqrt(s2) * std::exp(-d2 / (2 * s2));
        }
        if (std::abs(d) > sums.max) {
            sums.max = std::abs(d);
            sums.max_column = i;
            sums.max_row = j;
            sums.max_channel = channel;
        }
    };
    ForEachCounted(tiling, standard_error, int(truth.size()), mask,
                   [&](int tile, int channel, int i, int j, double s2) {
                       add(tiles[tile], channel, i, j, s2);
                   });
    return tiles;
}

}  // namespace

Measured RmseOf(const Measured& mse) {
    const auto root = [](double x) { return std::sqrt(std::max(x, 0.0)); };
    Measured rmse{.value = root(mse.value),
                  .interval = {root(mse.interval.low), root(mse.interval.high)}};
    const double slope = 1 / (2 * rmse.value);
    // At 0 the slope is infinite: the interval is all there is to say.
    if (mse.standard_error == 0) rmse.standard_error = 0;
    if (rmse.value > 0) {
        rmse.standard_error = slope * mse.standard_error;
        rmse.noise_error = slope * mse.noise_error;
    }
    return rmse;
}

Measured PsnrOf(const Measured& mse, double peak) {
    Measured psnr{
        .value = PsnrDb(mse.value, peak),
        .interval = {PsnrDb(mse.interval.high, peak), PsnrDb(mse.interval.low, peak)}};
    if (mse.standard_error == 0) psnr.standard_error = 0;
    if (mse.value > 0) {
        const double slope = 10 / (std::numbers::ln10 * mse.value);
        psnr.standard_error = slope * mse.standard_error;
        psnr.noise_error = slope * mse.noise_error;
    }
    return psnr;
}

double PsnrDb(double mse, double peak) {
    if (mse <= 0) return std::numeric_limits<double>::infinity();
    return 10 * std::log10(peak * peak / mse);
}

void Validate(const ErrorOptions& options) {
    if (!(options.confidence > 0 && options.confidence < 1))
        throw Error(MustBe("ErrorOptions::confidence", options.confidence, "in (0, 1)"));
    if (options.tile_px < 0 || options.tile_px > 65536)
        throw Error(MustBe("ErrorOptions::tile_px", options.tile_px, "in [0, 65536]"));
    if (!(options.truth_dof > 0))
        throw Error(MustBe("ErrorOptions::truth_dof", options.truth_dof, "> 0"));
}

ErrorScore ScoreErrors(const Image<float>& candidate, const Image<float>& truth,
                       const Image<float>& standard_error, const Mask& mask,
                       const ErrorOptions& options) {
    return ScoreChannels(ChannelSpan(&candidate, 1), ChannelSpan(&truth, 1),
                         ChannelSpan(&standard_error, 1), mask, options);
}

ErrorScore ScoreChannels(ChannelSpan candidate, ChannelSpan truth, ChannelSpan standard_error,
                         const Mask& mask, const ErrorOptions& options) {
    Validate(options);
    CheckChannels({candidate}, truth, standard_error, mask);
    const Tiling tiling(truth[0].Width(), truth[0].Height(), options.tile_px);
    const std::vector<TileSums> tiles =
        SumTiles(tiling, candidate, truth, standard_error, mask, options);

    ErrorScore score;
    const std::vector<std::int64_t> n = Counts(tiles);
    std::int64_t numbers = 0;
    for (std::int64_t count : n) {
        numbers += count;
        score.tiles += count > 0;
    }
    if (numbers == 0) return score;
    const double N = double(numbers), channels = double(truth.size());
    score.pixels = numbers / std::int64_t(truth.size());
    score.truth_variance = Total(tiles, &TileSums::s2) / N;
    score.mae_noise_bias = Total(tiles, &TileSums::abs_bias) / N;

    score.bias = RatioOverTiles(tiling, Sums(tiles, &TileSums::d), n, options.confidence);
    score.bias.noise_error = std::sqrt(channels * Total(tiles, &TileSums::s2)) / N;
    score.mae = RatioOverTiles(tiling, Sums(tiles, &TileSums::abs_d), n, options.confidence);
    score.mae.noise_error = score.bias.noise_error;  // |d| spreads no more than d.
    score.mae.interval.low = std::max(0.0, score.mae.interval.low - score.mae_noise_bias);
    score.mse =
        RatioOverTiles(tiling, Sums(tiles, &TileSums::d2_less_s2), n, options.confidence);
    score.mse.noise_error = std::sqrt(std::max(0.0, channels * Total(tiles, &TileSums::v))) / N;
    score.rmse = RmseOf(score.mse);
    score.psnr_db = PsnrOf(score.mse, 1);
    score.psnr_paper_db = PsnrOf(score.mse, kPaperPeak);

    for (const TileSums& tile : tiles) {
        if (tile.n == 0 || tile.max <= score.max) continue;
        score.max = tile.max;
        score.max_column = tile.max_column;
        score.max_row = tile.max_row;
        score.max_channel = tile.max_channel;
    }
    const double z = NormalQuantile(1 - SidakLevel(1 - options.confidence, numbers) / 2);
    std::vector<double> at_least(tiling.Count(), 0.0);
    ForEachCounted(
        tiling, standard_error, int(truth.size()), mask,
        [&](int tile, int channel, int i, int j, double s2) {
            const double d = double(candidate[channel](i, j)) - double(truth[channel](i, j));
            at_least[tile] = std::max(at_least[tile], std::abs(d) - z * std::sqrt(s2));
        });
    score.max_at_least = *std::max_element(at_least.begin(), at_least.end());
    return score;
}

std::vector<TileError> ScoreTiles(ChannelSpan candidate, ChannelSpan truth,
                                  ChannelSpan standard_error, const Mask& mask,
                                  const ErrorOptions& options) {
    Validate(options);
    CheckChannels({candidate}, truth, standard_error, mask);
    const Tiling tiling(truth[0].Width(), truth[0].Height(), options.tile_px);
    std::vector<TileError> errors;
    for (const TileSums& tile :
         SumTiles(tiling, candidate, truth, standard_error, mask, options)) {
        TileError error{.numbers = tile.n};
        if (tile.n > 0) {
            const double n = double(tile.n), channels = double(truth.size());
            error.mse = tile.d2_less_s2 / n;
            error.noise_error = std::sqrt(std::max(0.0, channels * tile.v)) / n;
        }
        errors.push_back(error);
    }
    return errors;
}

Measured CompareMse(const Image<float>& a, const Image<float>& b, const Image<float>& truth,
                    const Image<float>& standard_error, const Mask& mask,
                    const ErrorOptions& options) {
    return CompareChannels(ChannelSpan(&a, 1), ChannelSpan(&b, 1), ChannelSpan(&truth, 1),
                           ChannelSpan(&standard_error, 1), mask, options);
}

Measured CompareChannels(ChannelSpan a, ChannelSpan b, ChannelSpan truth,
                         ChannelSpan standard_error, const Mask& mask,
                         const ErrorOptions& options) {
    Validate(options);
    CheckChannels({a, b}, truth, standard_error, mask);
    const Tiling tiling(truth[0].Width(), truth[0].Height(), options.tile_px);
    std::vector<TileSums> tiles(tiling.Count());
    ForEachCounted(tiling, standard_error, int(truth.size()), mask,
                   [&](int tile, int c, int i, int j, double s2) {
                       const double A = FinitePixel(a[c], i, j, "candidate");
                       const double B = FinitePixel(b[c], i, j, "candidate");
                       TileSums& sums = tiles[tile];
                       ++sums.n;
                       sums.d += (A - B) * (A + B - 2 * FinitePixel(truth[c], i, j, "truth"));
                       sums.v += 4 * (A - B) * (A - B) * s2;
                   });
    const std::vector<std::int64_t> n = Counts(tiles);
    Measured figure = RatioOverTiles(tiling, Sums(tiles, &TileSums::d), n, options.confidence);
    double N = 0;
    for (std::int64_t count : n) N += double(count);
    if (N > 0) {
        figure.noise_error = std::sqrt(double(truth.size()) * Total(tiles, &TileSums::v)) / N;
    }
    return figure;
}

}  // namespace plumb
