// How many samples each pixel is shaded with: the largest of what the metrics ask for.
//
//       k = max(k_d, k_n)                                                  [Hollander13 eq. 3]
//
// and with the shading metric max(k, k_s), made a whole number and kept within 1 to n = m^2.
//
// Source   [Hollander13] section 3.1: the two metrics "are combined using a max filter"; section
//          3.2: "we use k samples".
// Symbols  k samples asked for; n samples of a window.
// Domain   Of the metrics any may be left out.
// Beware   The paper calls k "the number of additional samples" in section 3 and the number of all
//          in sections 3.2 and 4.2: an option.
#pragma once

#include <cstdint>

#include "core/image.h"
#include "core/vec.h"
#include "screen_space/antialiasing/depth_metric.h"
#include "screen_space/antialiasing/normal_metric.h"
#include "screen_space/antialiasing/shading_metric.h"

namespace plumb {

/// How k becomes a whole number.
enum class CountRounding { kDown, kNearest, kUp };

/// What k counts.
enum class FirstSample {
    kIncluded,  ///< All samples: max(1, k).
    kBeside,    ///< Those after the first: 1 + k.
};

/// Whose c the metrics take.
enum class MetricConstants {
    kEach,    ///< Each its own.
    kShared,  ///< All SampleMetrics::shared_c: the print has one letter.
};

struct SampleMetrics {
    bool use_depth = true, use_normals = true, use_shading = true;
    DepthMetric depth;
    NormalMetric normals;
    ShadingMetric shading;
    MetricConstants constants = MetricConstants::kEach;
    double shared_c = 16;  ///< Used if kShared. >= 0
    CountRounding rounding = CountRounding::kNearest;
    FirstSample first = FirstSample::kIncluded;

    friend bool operator==(const SampleMetrics&, const SampleMetrics&) = default;
};

/// Throws Error, naming field, value and rule.
void Validate(const SampleMetrics& metrics);

/// Samples of a pixel whose metrics ask for `k` of n. Infinite and NaN: n. [1, n]
int WholeSamples(double k, int n, CountRounding rounding, FirstSample first);

/// What the metrics read, each of m times the size of `one_sample`.
struct MetricInput {
    const Image<float>& z_m;       ///< Of the camera's frame, < 0; minus infinity: sky.
    const Image<Vec3f>& normals;   ///< Unit; 0: sky.
    const Image<Rgb>& one_sample;  ///< The picture shaded with the first sample of each pixel.
};

/// How many samples each pixel gets, the first included. [1, m^2]
Image<std::uint8_t> SampleCounts(const MetricInput& input, int m, const SampleMetrics& metrics);

/// Share of the n samples of all pixels that are shaded. (0, 1]; NaN without pixels.
double SamplesUsed(const Image<std::uint8_t>& counts, int m);

}  // namespace plumb
