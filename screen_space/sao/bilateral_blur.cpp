#include "screen_space/sao/bilateral_blur.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "screen_space/sao/blur_rows.h"

namespace plumb {
namespace {

void CheckRange(const char* field, double value, double low, double high, const char* rule) {
    if (!(value >= low && value <= high)) {
        throw Error(MustBe(std::string("BlurOptions::") + field, value, rule));
    }
}

struct Surface {
    Vec3 C = Vec3::Zero(), n = Vec3::Zero();
};

Surface SurfaceAt(const BlurGuide& guide, int x, int y) {
    Surface surface;
    if (guide.normal == nullptr) return surface;
    surface.n = (*guide.normal)(x, y).cast<double>();
    surface.C = guide.view.Point(x + 0.5, y + 0.5, guide.key(x, y) * guide.z_min_m);
    return surface;
}

double SurfaceWeight(const Surface& centre, const Surface& tap, const BlurOptions& options) {
    double weight = 1;
    if (options.normal_weight) weight *= std::clamp(centre.n.dot(tap.n), 0.0, 1.0);
    if (options.plane_weight) {
        const Vec3 across = centre.C - tap.C;
        const double d2 = across.squaredNorm();
        if (d2 >= options.near_m2) {
            const double off =
                std::max(std::abs(across.dot(tap.n)), std::abs(across.dot(centre.n)));
            weight *= std::pow(std::max(0.0, 1 - 2 * off / std::sqrt(d2)), 2);
        }
    }
    return weight;
}

}  // namespace

void Validate(const BlurOptions& options) {
    CheckRange("taps_each_side", options.taps_each_side, 0, 6, "in [0, 6]");
    CheckRange("stride_px", options.stride_px, 1, 64, "in [1, 64]");
    CheckRange("lift", options.lift, 0, 10, "in [0, 10]");
    CheckRange("edge_sharpness", options.edge_sharpness, 0, 1e9, "in [0, 1e9]");
    CheckRange("tiny", options.tiny, 0, 1, "in [0, 1]");
    CheckRange("near_m2", options.near_m2, 1e-12, 1e12, "in [1e-12, 1e12]");
    CheckRange("kernel[0]", options.kernel[0], 1e-6, 1e6, "in [1e-6, 1e6]");
    for (std::size_t k = 1; k < options.kernel.size(); ++k) {
        CheckRange("kernel", options.kernel[k], 0, 1e6, "in [0, 1e6]");
    }
}

double BlurredPixel(BlurAxis axis, const Image<float>& A, const BlurGuide& guide,
                    const BlurOptions& options, int x, int y) {
    const double key = guide.key(x, y);
    if (options.taps_each_side == 0 || key == 1) return A(x, y);
    const bool surfaces = options.normal_weight || options.plane_weight;
    const Surface centre = surfaces ? SurfaceAt(guide, x, y) : Surface{};
    double weights = options.kernel[0], sum = weights * A(x, y);
    for (const int side : {-1, 1}) {
        double nearest = 1;  // the least share of the taps passed, if it must not rise
        for (int k = 1; k <= options.taps_each_side; ++k) {
            const int step = side * k * options.stride_px;
            const int i = axis == BlurAxis::kX ? x + step : x;
            const int j = axis == BlurAxis::kY ? y + step : y;
            if (!Drawn(guide.view).Contains(i, j)) continue;
            const double off = std::abs(guide.key(i, j) - key);
            double share = std::max(0.0, 1 - options.edge_sharpness * off);
            if (surfaces && share > 0) {
                share *= SurfaceWeight(centre, SurfaceAt(guide, i, j), options);
            }
            if (!(share > 0)) share = 0;
            if (options.monotonic) share = nearest = std::min(nearest, share);
            const double weight = share * (options.lift + options.kernel[std::size_t(k)]);
            sum += weight * A(i, j);
            weights += weight;
        }
    }
    return sum / (weights + options.tiny);
}

Image<float> BlurredAlong(BlurAxis axis, const Image<float>& A, const BlurGuide& guide,
                          const BlurOptions& options, const PixelRect& where) {
    Image<float> blurred = A;
    if (options.taps_each_side == 0) return blurred;
    ParallelFor(where.Height(), 8, [&](std::int64_t begin, std::int64_t end) {
        for (int y = where.y0 + int(begin); y < where.y0 + int(end); ++y) {
            BlurRow(axis, A, guide, options, y, where.x0, where.x1, &blurred(0, y));
        }
    });
    return blurred;
}

}  // namespace plumb
