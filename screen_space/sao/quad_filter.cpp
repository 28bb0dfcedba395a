#include "screen_space/sao/quad_filter.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "screen_space/sao/quad_filter.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace plumb::HWY_NAMESPACE {
namespace {

// What both pixels of a pair move by, up and down, to get their mean if they lie on one surface:
// dA ((x & 1) - 1/2). NaN, of sky beside sky, compares false.
inline float HalfStep(float A0, float A1, float z0, float z1, float threshold) {
    return std::abs(z1 - z0) < threshold ? (A1 - A0) / 2 : 0.0f;
}

// Loops for the compiler to vectorize, once for each kind of machine.
void Filter(Image<float>& A, const Image<float>& z_m, float threshold, const PixelRect& where) {
    const int pairs = where.Width() / 2, width = where.Width();
    for (int y = where.y0; y < where.y1; ++y) {
        float* HWY_RESTRICT row = &A(where.x0, y);
        const float* HWY_RESTRICT z = &z_m(where.x0, y);
        for (int k = 0; k < pairs; ++k) {
            const float A0 = row[2 * k], A1 = row[2 * k + 1];
            const float half_step = HalfStep(A0, A1, z[2 * k], z[2 * k + 1], threshold);
            row[2 * k] = A0 + half_step;
            row[2 * k + 1] = A1 - half_step;
        }
        if ((y - where.y0) % 2 == 0) continue;
        float *HWY_RESTRICT upper = &A(where.x0, y - 1), *HWY_RESTRICT lower = row;
        const float* HWY_RESTRICT z_upper = &z_m(where.x0, y - 1);
        for (int k = 0; k < width; ++k) {
            const float half_step = HalfStep(upper[k], lower[k], z_upper[k], z[k], threshold);
            upper[k] += half_step;
            lower[k] -= half_step;
        }
    }
}

}  // namespace
}  // namespace plumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace plumb {
namespace {

HWY_EXPORT(Filter);

}  // namespace

void FilterQuads(Image<float>& A, const Image<float>& z_m, double threshold_m,
                 const PixelRect& where) {
    assert(where.x0 % 2 == 0 && where.y0 % 2 == 0);
    if (where.Width() <= 0) return;
    HWY_DYNAMIC_DISPATCH(Filter)(A, z_m, float(threshold_m), where);
}

Image<float> QuadFiltered(Image<float> A, const Image<float>& z_m, double threshold_m,
                          const PixelRect& where) {
    ForEachTile(where, [&](const PixelRect& tile) { FilterQuads(A, z_m, threshold_m, tile); });
    return A;
}

}  // namespace plumb

#endif
