#include "screen_space/antialiasing/shading_metric.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"

namespace plumb {
namespace {

constexpr std::int64_t kRowsAtATime = 8;

// IEC 61966-2-1.
float SrgbOf(float linear) {
    const float v = std::clamp(linear, 0.f, 1.f);
    return v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
}

float LuminanceOf(const Rgb& colour, const ShadingMetric& metric) {
    if (metric.encoding == LuminanceEncoding::kLinear) return Luma(metric.weights, colour);
    return Luma(metric.weights, {SrgbOf(colour[0]), SrgbOf(colour[1]), SrgbOf(colour[2])});
}

void CheckNotNegative(const char* field, double value) {
    if (!(value >= 0 && std::isfinite(value))) {
        throw Error(
            MustBe(std::string("ShadingMetric::") + field, value, "finite and not negative"));
    }
}

}  // namespace

void Validate(const ShadingMetric& metric) {
    CheckNotNegative("c", metric.c);
    CheckNotNegative("min_threshold", metric.min_threshold);
    CheckNotNegative("edge_threshold", metric.edge_threshold);
}

// [Hollander13 eq. 4]
Image<float> ShadingSamples(const Image<Rgb>& one_sample, const ShadingMetric& metric) {
    Validate(metric);
    const int W = one_sample.Width(), H = one_sample.Height();
    Image<float> l(W, H), k_s(W, H);
    ParallelFor(H, kRowsAtATime, [&](std::int64_t begin, std::int64_t end) {
        for (int y = int(begin); y < int(end); ++y) {
            for (int x = 0; x < W; ++x) l(x, y) = LuminanceOf(one_sample(x, y), metric);
        }
    });
    ParallelFor(H, kRowsAtATime, [&](std::int64_t begin, std::int64_t end) {
        for (int y = int(begin); y < int(end); ++y) {
            const int above = std::max(y - 1, 0), below = std::min(y + 1, H - 1);
            for (int x = 0; x < W; ++x) {
                const int left = std::max(x - 1, 0), right = std::min(x + 1, W - 1);
                const float a = l(left, y), b = l(right, y), c = l(x, above), d = l(x, below);
                float l_max = std::max(std::max(a, b), std::max(c, d));
                float l_min = std::min(std::min(a, b), std::min(c, d));
                if (metric.neighbours == ShadingNeighbours::kFourAndCentre) {
                    l_max = std::max(l_max, l(x, y));
                    l_min = std::min(l_min, l(x, y));
                }
                const double r = l_max - l_min;
                const double threshold =
                    std::max(metric.min_threshold, l_max * metric.edge_threshold);
                k_s(x, y) = r < threshold ? 0 : float(metric.c * r);
            }
        }
    });
    return k_s;
}

}  // namespace plumb
