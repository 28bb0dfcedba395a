#include "score/ssim.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/parallel.h"
#include "score/pixels.h"

namespace plumb {
namespace {

constexpr int kTaps = 2 * kSsimReach + 1;

std::array<double, kTaps> Gaussian() {
    std::array<double, kTaps> g{};
    double sum = 0;
    for (int k = 0; k < kTaps; ++k) {
        const double x = (k - kSsimReach) / kSsimSigma_px;
        g[k] = std::exp(-x * x / 2);
        sum += g[k];
    }
    for (double& weight : g) weight /= sum;
    return g;
}

/// Sums over a window, each pixel times its weight; not yet divided by that of the weights.
struct Sums {
    double w = 0, c = 0, t = 0, cc = 0, tt = 0, ct = 0, s2 = 0;
    double w2_s2 = 0;  ///< With squared weights.
};

constexpr int kChannels = 8;  // As many as Sums has, in its order.

/// Rows of each channel, side by side, so that the loops over columns are plain.
class Rows {
  public:
    Rows(int width, int height)
        : width_(width), height_(height), values_(std::size_t(width) * height * kChannels) {}

    double* operator()(int channel, int row) {
        return &values_[(std::size_t(channel) * height_ + row) * width_];
    }
    const double* operator()(int channel, int row) const {
        return &values_[(std::size_t(channel) * height_ + row) * width_];
    }
    Sums At(int row, int i) const {
        return {(*this)(0, row)[i], (*this)(1, row)[i], (*this)(2, row)[i], (*this)(3, row)[i],
                (*this)(4, row)[i], (*this)(5, row)[i], (*this)(6, row)[i], (*this)(7, row)[i]};
    }
    void Set(int row, int i, const Sums& sums) {
        const double all[kChannels] = {sums.w,  sums.c,  sums.t,  sums.cc,
                                       sums.tt, sums.ct, sums.s2, sums.w2_s2};
        for (int channel = 0; channel < kChannels; ++channel)
            (*this)(channel, row)[i] = all[channel];
    }

  private:
    int width_, height_;
    std::vector<double> values_;
};

/// to[i] = Sum_k g_k from_k[i] for i in [0, n); of the last channel with g_k^2.
template <class From>
void Weigh(const std::array<double, kTaps>& g, int channel, int n, double* to,
           const From& from) {
    std::fill(to, to + n, 0.0);
    for (int k = 0; k < kTaps; ++k) {
        const double weight = channel == kChannels - 1 ? g[k] * g[k] : g[k];
        const double* row = from(k);
        for (int i = 0; i < n; ++i) to[i] += weight * row[i];
    }
}

double Ssim(const Sums& sums) {
    constexpr double C1 = kSsimK1 * kSsimK1, C2 = kSsimK2 * kSsimK2;
    const double mu_c = sums.c / sums.w, mu_t = sums.t / sums.w;
    const double p = sums.s2 / sums.w, q = sums.w2_s2 / (sums.w * sums.w);
    const double sigma_c2 = std::max(sums.cc / sums.w - mu_c * mu_c, 0.0);
    const double sigma_ct = sums.ct / sums.w - mu_c * mu_t;
    const double sigma_t2 = std::max(sums.tt / sums.w - mu_t * mu_t - (p - q), 0.0);
    const double mu_t2 = std::max(mu_t * mu_t - q, 0.0);
    return (2 * mu_c * mu_t + C1) * (2 * sigma_ct + C2) /
           ((mu_c * mu_c + mu_t2 + C1) * (sigma_c2 + sigma_t2 + C2));
}

}  // namespace

Image<float> SsimMap(const Image<float>& candidate, const Image<float>& truth,
                     const Image<float>& standard_error, const Mask& seen) {
    CheckSizes(candidate, truth, standard_error, seen);
    const int width = truth.Width(), height = truth.Height();
    Image<float> map(width, height, std::numeric_limits<float>::quiet_NaN());
    if (width < kTaps || height < kTaps) return map;

    const std::array<double, kTaps> g = Gaussian();
    const auto pixel = [&](int i, int j) -> Sums {
        if (!seen.Empty() && seen(i, j) == 0) return {};
        const double c = FinitePixel(candidate, i, j, "candidate");
        const double t = FinitePixel(truth, i, j, "truth");
        double s2 = 0;
        if (!standard_error.Empty()) {
            const double s = FinitePixel(standard_error, i, j, "standard error");
            s2 = s * s;
        }
        return {1, c, t, c * c, t * t, c * t, s2, s2};
    };
    constexpr std::int64_t kRows = 32;
    const int inner = width - 2 * kSsimReach;
    ParallelFor(height - 2 * kSsimReach, kRows, [&](std::int64_t begin, std::int64_t end) {
        const int high = int(end - begin);
        Rows pixels(width, high + 2 * kSsimReach), columns(width, 1), windows(inner, 1);
        for (int row = 0; row < high + 2 * kSsimReach; ++row)
            for (int i = 0; i < width; ++i) pixels.Set(row, i, pixel(i, int(begin) + row));
        for (int row = 0; row < high; ++row) {
            for (int channel = 0; channel < kChannels; ++channel) {
                double* column = columns(channel, 0);
                Weigh(g, channel, width, column,
                      [&](int k) { return pixels(channel, row + k); });
                Weigh(g, channel, inner, windows(channel, 0),
                      [&](int k) { return column + k; });
            }
            const int j = int(begin) + row + kSsimReach;
            for (int i = 0; i < inner; ++i) {
                if (!seen.Empty() && seen(i + kSsimReach, j) == 0) continue;
                map(i + kSsimReach, j) = float(Ssim(windows.At(0, i)));
            }
        }
    });
    return map;
}

Measured ScoreSsim(const Image<float>& map, const Mask& mask, const ErrorOptions& options) {
    Validate(options);
    CheckSizes(map, map, {}, mask);
    const Tiling tiling(map.Width(), map.Height(), options.tile_px);
    std::vector<double> y(tiling.Count(), 0);
    std::vector<std::int64_t> n(tiling.Count(), 0);
    ForEachCounted(tiling, {}, mask, [&](int tile, int i, int j, double) {
        if (std::isnan(map(i, j))) return;
        y[tile] += map(i, j);
        ++n[tile];
    });
    return RatioOverTiles(tiling, y, n, options.confidence);
}

}  // namespace plumb
