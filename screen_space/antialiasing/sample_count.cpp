#include "screen_space/antialiasing/sample_count.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "screen_space/antialiasing/windows.h"

namespace plumb {
namespace {

double Rounded(double k, CountRounding rounding) {
    switch (rounding) {
        case CountRounding::kDown:
            return std::floor(k);
        case CountRounding::kNearest:
            return std::floor(k + 0.5);
        case CountRounding::kUp:
            return std::ceil(k);
    }
    return k;
}

SampleMetrics WithConstants(SampleMetrics metrics) {
    if (metrics.constants == MetricConstants::kShared) {
        metrics.depth.c = metrics.normals.c = metrics.shading.c = metrics.shared_c;
    }
    return metrics;
}

// NaN stays: it asks for all samples.
void RaiseTo(const Image<float>& k_more, Image<float>& k) {
    for (std::size_t i = 0; i < k.Pixels().size(); ++i) {
        const float more = k_more.Pixels()[i];
        if (!(more <= k.Pixels()[i])) k.Pixels()[i] = more;
    }
}

void CheckSize(int width, int height, int m, const Image<Rgb>& one_sample, const char* what) {
    CheckWindows(m, width, height, std::string("size of the enlarged ") + what);
    if (width != one_sample.Width() * m || height != one_sample.Height() * m) {
        throw Error(std::string("size of the enlarged ") + what + " = " +
                    std::to_string(width) + " x " + std::to_string(height) +
                    ", must be m = " + std::to_string(m) + " times that of the picture, " +
                    std::to_string(one_sample.Width()) + " x " +
                    std::to_string(one_sample.Height()));
    }
}

}  // namespace

void Validate(const SampleMetrics& metrics) {
    Validate(metrics.depth);
    Validate(metrics.normals);
    Validate(metrics.shading);
    if (!(metrics.shared_c >= 0 && std::isfinite(metrics.shared_c))) {
        throw Error(
            MustBe("SampleMetrics::shared_c", metrics.shared_c, "finite and not negative"));
    }
}

int WholeSamples(double k, int n, CountRounding rounding, FirstSample first) {
    const double all = Rounded(k, rounding) + (first == FirstSample::kBeside ? 1 : 0);
    if (!(all < n)) return n;
    return std::max(1, int(all));
}

Image<std::uint8_t> SampleCounts(const MetricInput& input, int m, const SampleMetrics& given) {
    Validate(given);
    const SampleMetrics metrics = WithConstants(given);
    CheckSize(input.z_m.Width(), input.z_m.Height(), m, input.one_sample, "depths");
    CheckSize(input.normals.Width(), input.normals.Height(), m, input.one_sample, "normals");
    const int W = input.one_sample.Width(), H = input.one_sample.Height();
    Image<float> k(W, H, 0.f);
    // [Hollander13 eq. 3]
    if (metrics.use_depth) RaiseTo(DepthSamples(input.z_m, m, metrics.depth), k);
    if (metrics.use_normals) RaiseTo(NormalSamples(input.normals, m, metrics.normals), k);
    if (metrics.use_shading) RaiseTo(ShadingSamples(input.one_sample, metrics.shading), k);
    Image<std::uint8_t> counts(W, H);
    for (std::size_t i = 0; i < counts.Pixels().size(); ++i) {
        counts.Pixels()[i] =
            std::uint8_t(WholeSamples(k.Pixels()[i], m * m, metrics.rounding, metrics.first));
    }
    return counts;
}

double SamplesUsed(const Image<std::uint8_t>& counts, int m) {
    CheckEnlargement(m);
    if (counts.Empty()) return std::numeric_limits<double>::quiet_NaN();
    std::int64_t sum = 0;
    for (const std::uint8_t count : counts.Pixels()) sum += count;
    return double(sum) / (double(counts.Pixels().size()) * m * m);
}

}  // namespace plumb
