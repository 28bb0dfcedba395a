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

/// Weighted sums of a window, not yet divided by the weight.
struct Sums {
    double w = 0, c = 0, t = 0, cc = 0, tt = 0, ct = 0, s2 = 0;
    double w2_s2 = 0;  ///< With squared weights.

    void Add(double g, const Sums& o) {
        w += g * o.w;
        c += g * o.c;
        t += g * o.t;
        cc += g * o.cc;
        tt += g * o.tt;
        ct += g * o.ct;
        s2 += g * o.s2;
        w2_s2 += g * g * o.w2_s2;
    }
};

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
    constexpr std::int64_t kRows = 16;
    ParallelFor(height - 2 * kSsimReach, kRows, [&](std::int64_t begin, std::int64_t end) {
        std::vector<Sums> columns(width);
        for (int j = int(begin) + kSsimReach; j < int(end) + kSsimReach; ++j) {
            for (int i = 0; i < width; ++i) {
                columns[i] = {};
                for (int k = 0; k < kTaps; ++k)
                    columns[i].Add(g[k], pixel(i, j + k - kSsimReach));
            }
            for (int i = kSsimReach; i < width - kSsimReach; ++i) {
                if (!seen.Empty() && seen(i, j) == 0) continue;
                Sums window;
                for (int k = 0; k < kTaps; ++k) window.Add(g[k], columns[i + k - kSsimReach]);
                map(i, j) = float(Ssim(window));
            }
        }
    });
    return map;
}

Figure ScoreSsim(const Image<float>& map, const Mask& mask, const ErrorOptions& options) {
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
