// Samples that a pixel needs by the depths in its window: their variance.
//
//       k_d = c ( Sum d_i^2 / n - (Sum d_i / n)^2 )                        [Hollander13 eq. 1]
//
// The paper numbers no equation; here they are counted as they are printed.
//
// As printed, in 32-bit floats, the difference cancels where d is large beside its spread: four
// depths 1 mm apart, 1 km away, have the variance 1.25e-6 m^2 and get 0.0625 or nothing. So there
// is a stable form too, the mean of (d_i - mean)^2 in double; both are the same number.
//
// Source   [Hollander13] section 3.1. Which depth, its bits and c are not said: they are options.
// Symbols  d_i depth of sample i of the window, encoded as the options say; n = m^2; c samples for
//          a variance of 1.
// Beware   Sky counts as the far plane. A slope seen at a low angle has as much variance as an edge.
#pragma once

#include <span>

#include "core/image.h"

namespace plumb {

/// How a formula is computed.
enum class MetricForm {
    kPrinted,  ///< As it stands, in 32-bit floats.
    kStable,   ///< In double, without cancellation.
};

/// What d is.
enum class DepthEncoding {
    kMetres,  ///< -z, at most the far plane's.
    kLinear,  ///< (d - near) / (far - near): 0 near, 1 far.
    kDevice,  ///< far (d - near) / (d (far - near)): a depth buffer's. Reversed ones vary alike.
};

struct DepthMetric {
    double c = 16;  ///< Ours: a variance of 1 asks for 16 samples. >= 0
    DepthEncoding encoding = DepthEncoding::kDevice;
    double near_m = 0.1;  ///< > 0
    double far_m = 1000;  ///< Finite, > near_m.
    int bits = 0;         ///< Of the stored depth, 0 to 1; 0: float. kMetres: 0. [0, 24]
    MetricForm form = MetricForm::kStable;

    friend bool operator==(const DepthMetric&, const DepthMetric&) = default;
};

/// Throws Error, naming field, value and rule.
void Validate(const DepthMetric& metric);

/// d of a point with z_m < 0 in the camera's frame, minus infinity for the sky.
float EncodedDepth(const DepthMetric& metric, float z_m);

/// Variance of the values themselves: divided by n, not n - 1.
double WindowVariance(MetricForm form, std::span<const float> d);

/// k_d of every pixel, >= 0; z_m is of the enlarged size.
Image<float> DepthSamples(const Image<float>& z_m, int m, const DepthMetric& metric);

}  // namespace plumb
