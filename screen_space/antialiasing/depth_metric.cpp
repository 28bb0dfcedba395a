#include "screen_space/antialiasing/depth_metric.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "screen_space/antialiasing/metric_rows.h"
#include "screen_space/antialiasing/windows.h"

namespace plumb {
namespace {

constexpr std::int64_t kRowsAtATime = 4;

// In the order of the samples, every step rounded to 32 bits.
float PrintedVariance(std::span<const float> d) {
    const float n = float(d.size());
    float squares = 0, sum = 0;
    for (const float of : d) {
        squares += of * of;
        sum += of;
    }
    return squares / n - (sum / n) * (sum / n);
}

double StableVariance(std::span<const float> d) {
    const double n = double(d.size());
    double sum = 0, squares = 0;
    for (const float of : d) sum += of;
    for (const float of : d) squares += (of - sum / n) * (of - sum / n);
    return squares / n;
}

void PrintedRow(const DepthMetric& metric, const Image<float>& z_m, int m, int y,
                Image<float>& k_d) {
    std::array<float, kMaxSamples> d;
    const std::size_t n = std::size_t(m) * m;
    for (int x = 0; x < k_d.Width(); ++x) {
        ReadWindow(z_m, m, x, y, d);
        for (std::size_t i = 0; i < n; ++i) d[i] = EncodedDepth(metric, d[i]);
        k_d(x, y) = float(std::max(0.0, metric.c * PrintedVariance({d.data(), n})));
    }
}

}  // namespace

void Validate(const DepthMetric& metric) {
    if (!(metric.c >= 0 && std::isfinite(metric.c))) {
        throw Error(MustBe("DepthMetric::c", metric.c, "finite and not negative"));
    }
    if (!(metric.near_m > 0 && std::isfinite(metric.near_m))) {
        throw Error(MustBe("DepthMetric::near_m", metric.near_m, "finite and > 0"));
    }
    if (!(metric.far_m > metric.near_m && std::isfinite(metric.far_m))) {
        throw Error(MustBe("DepthMetric::far_m", metric.far_m, "finite and > near_m"));
    }
    const int most = metric.encoding == DepthEncoding::kMetres ? 0 : 24;
    if (metric.bits < 0 || metric.bits > most) {
        throw Error(
            MustBe("DepthMetric::bits", metric.bits, "in [0, 24], and 0 for depths in metres"));
    }
}

float EncodedDepth(const DepthMetric& metric, float z_m) {
    const double near = metric.near_m, far = metric.far_m;
    // Written so that NaN becomes the far plane.
    const double d = -double(z_m) < far ? std::max(near, -double(z_m)) : far;
    double encoded = d;
    if (metric.encoding == DepthEncoding::kLinear) encoded = (d - near) / (far - near);
    if (metric.encoding == DepthEncoding::kDevice)
        encoded = far * (d - near) / (d * (far - near));
    if (metric.bits > 0) {
        const double levels = double((1 << metric.bits) - 1);
        encoded = std::floor(encoded * levels + 0.5) / levels;
    }
    return float(encoded);
}

double WindowVariance(MetricForm form, std::span<const float> d) {
    return form == MetricForm::kPrinted ? PrintedVariance(d) : StableVariance(d);
}

// [Hollander13 eq. 1]
Image<float> DepthSamples(const Image<float>& z_m, int m, const DepthMetric& metric) {
    Validate(metric);
    CheckWindows(m, z_m.Width(), z_m.Height(), "size of the enlarged depths");
    Image<float> k_d(z_m.Width() / m, z_m.Height() / m);
    ParallelFor(k_d.Height(), kRowsAtATime, [&](std::int64_t begin, std::int64_t end) {
        for (int y = int(begin); y < int(end) && k_d.Width() > 0; ++y) {
            if (metric.form == MetricForm::kStable) {
                DepthRow(metric, z_m, m, y, &k_d(0, y));
            } else {
                PrintedRow(metric, z_m, m, y, k_d);
            }
        }
    });
    return k_d;
}

}  // namespace plumb
