// The stable forms of both geometric metrics over a row of pixels, many at once, in double.
//
// Beware   No operation is fused and each pixel's sums are in the order of its samples: the bits are
//          those of WindowVariance and NormalSpread, whatever the machine's vectors.
#pragma once

#include "core/image.h"
#include "core/vec.h"
#include "screen_space/antialiasing/depth_metric.h"
#include "screen_space/antialiasing/normal_metric.h"

namespace plumb {

/// k_d of the pixels of row y, written to k[x].
void DepthRow(const DepthMetric& metric, const Image<float>& z_m, int m, int y, float* k);

/// k_n likewise.
void NormalRow(const NormalMetric& metric, const Image<Vec3f>& normals, int m, int y, float* k);

}  // namespace plumb
