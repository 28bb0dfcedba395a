#include "screen_space/quad_filter.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace plumb {
namespace {

/// Both pixels of a pair get their mean if they lie on one surface.
inline void Filter(float& A0, float& A1, float z0, float z1, float threshold) {
    // A - dA ((x & 1) - 1/2) for x even and odd; NaN, of sky beside sky, compares false.
    const float half_step = std::abs(z1 - z0) < threshold ? (A1 - A0) / 2 : 0.0f;
    A0 += half_step;
    A1 -= half_step;
}

}  // namespace

void FilterQuads(Image<float>& A, const Image<float>& z_m, double threshold_m,
                 const PixelRect& where) {
    assert(where.x0 % 2 == 0 && where.y0 % 2 == 0);
    const float threshold = float(threshold_m);
    for (int y = where.y0; y < where.y1; y += 2) {
        const int rows = std::min(2, where.y1 - y);
        for (int j = y; j < y + rows; ++j) {
            float* row = &A(0, j);
            const float* z = &z_m(0, j);
            for (int x = where.x0; x + 1 < where.x1; x += 2) {
                Filter(row[x], row[x + 1], z[x], z[x + 1], threshold);
            }
        }
        if (rows < 2) continue;
        float *upper = &A(0, y), *lower = &A(0, y + 1);
        const float *z_upper = &z_m(0, y), *z_lower = &z_m(0, y + 1);
        for (int x = where.x0; x < where.x1; ++x) {
            Filter(upper[x], lower[x], z_upper[x], z_lower[x], threshold);
        }
    }
}

Image<float> QuadFiltered(Image<float> A, const Image<float>& z_m, double threshold_m,
                          const PixelRect& where) {
    ForEachTile(where, [&](const PixelRect& tile) { FilterQuads(A, z_m, threshold_m, tile); });
    return A;
}

}  // namespace plumb
