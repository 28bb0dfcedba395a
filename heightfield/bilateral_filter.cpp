#include "heightfield/bilateral_filter.h"

#include <cmath>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"

namespace plumb {
namespace {

constexpr int kOutside = -1;

// The texel of [0, n) that stands for texel i of the endless field, or kOutside.
int Resolve(int i, int n, Boundary boundary) {
    if (0 <= i && i < n) return i;
    if (boundary == Boundary::kOpen) return kOutside;
    const int period = boundary == Boundary::kWrap ? n : 2 * (n - 1);
    const int r = ((i % period) + period) % period;
    return r < n ? r : period - r;
}

}  // namespace

void Validate(const BilateralFilter& filter) {
    if (filter.radius_texels < 0 || filter.radius_texels > 64)
        throw Error(
            MustBe("BilateralFilter::radius_texels", filter.radius_texels, "in [0, 64]"));
    if (!(filter.tolerance_m > 0 && std::isfinite(filter.tolerance_m)))
        throw Error(
            MustBe("BilateralFilter::tolerance_m", filter.tolerance_m, "finite and > 0"));
}

HeightField Filtered(const HeightField& field, const BilateralFilter& filter) {
    Validate(filter);
    const int r = filter.radius_texels;
    const double t = filter.tolerance_m;
    const int width = field.Width(), height = field.Height();
    const Boundary boundary = field.GetBoundary();

    std::vector<double> w_s(r + 1);  // Of one axis: the Gaussian separates.
    for (int d = 0; d <= r; ++d) w_s[d] = r == 0 ? 1 : std::exp(-0.5 * d * d / (r * r));
    std::vector<int> column(width + 2 * r);
    for (int i = -r; i < width + r; ++i) column[i + r] = Resolve(i, width, boundary);

    Image<double> out(width, height);
    ParallelFor(height, 1, [&](std::int64_t begin, std::int64_t end) {
        for (int j = int(begin); j < int(end); ++j) {
            for (int i = 0; i < width; ++i) {
                const double z = field.At(i, j);
                // Summed as differences from z: a constant comes out bit for bit.
                double sum = 0, norm = 0;
                for (int dj = -r; dj <= r; ++dj) {
                    const int row = Resolve(j + dj, height, boundary);
                    if (row == kOutside) continue;
                    for (int di = -r; di <= r; ++di) {
                        const int col = column[i + di + r];
                        if (col == kOutside) continue;
                        const double d = field.At(col, row) - z;
                        if (std::abs(d) >= t) continue;
                        const double tukey = 1 - (d / t) * (d / t);
                        const double w = w_s[std::abs(di)] * w_s[std::abs(dj)] * tukey * tukey;
                        sum += w * d;
                        norm += w;
                    }
                }
                out(i, j) = z + sum / norm;
            }
        }
    });
    return HeightField(std::move(out), field.SpacingXM(), field.SpacingYM(), boundary,
                       field.GetDiagonal());
}

}  // namespace plumb
