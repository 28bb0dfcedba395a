// Samples that a pixel needs by the normals in its window: how wide a cone they span.
//
//       k_n = c sqrt( 1 - min_ij |<n_mean, n_ij>| )                        [Hollander13 eq. 2]
//
// where n_mean is the mean of the window's normals, or that mean made a unit vector: the paper says
// "average normal". Four normals, two and two at right angles, get sqrt(1/2) or 0.541.
//
// The stable form takes 1 - |<n_mean, n>| from differences, which for unit normals is the same:
// |n_mean -+ n|^2 / 2 of unit means, else -<n_mean - n, n>. It is exactly 0 where all are equal; as
// printed, equal normals that are not quite of unit length (8 bits a component) ask for samples.
//
// Source   [Hollander13] section 3.1.
// Symbols  n_ij unit normals of the window, c samples for the widest cone.
// Beware   Because of the absolute value opposite normals count as equal: three against one get 0
//          with a unit mean. Sky has no normal: a window with some of it gets the whole c, one of
//          nothing else 0.
#pragma once

#include <span>

#include "core/image.h"
#include "core/vec.h"
#include "screen_space/antialiasing/depth_metric.h"

namespace plumb {

/// What n_mean is.
enum class MeanNormal { kRaw, kUnit };

struct NormalMetric {
    double c = 16;  ///< Ours: as many as m = 4 has. >= 0
    MeanNormal mean = MeanNormal::kRaw;
    MetricForm form = MetricForm::kStable;

    friend bool operator==(const NormalMetric&, const NormalMetric&) = default;
};

/// Throws Error, naming field, value and rule.
void Validate(const NormalMetric& metric);

/// sqrt(1 - min |<n_mean, n>|) of a window's normals, each unit, or 0 for the sky. [0, 1]
double NormalSpread(std::span<const Vec3f> normals, MeanNormal mean, MetricForm form);

/// k_n of every pixel, >= 0; the normals are of the enlarged size.
Image<float> NormalSamples(const Image<Vec3f>& normals, int m, const NormalMetric& metric);

}  // namespace plumb
