#include "screen_space/horizon/hbao.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "screen_space/horizon/every_pixel.h"

namespace plumb {
namespace {

/// The integrand of one direction: Sum_j W(d_j) (sin h_j - sin h_{j-1}).
double Rise(const SliceMarch& march, const HbaoOptions& options, double theta_rad) {
    const Slice slice = march.SliceAt(theta_rad);
    // The tangent plane meets the slice along t cos gamma - V sin gamma.
    const double sin_t =
        slice.t.z() * std::cos(slice.gamma_rad) - slice.V.z() * std::sin(slice.gamma_rad);
    double sin_h = sin_t;
    if (options.bias_rad > 0) {
        const double t = std::asin(std::clamp(sin_t, -1.0, 1.0));
        sin_h = std::sin(std::min(t + options.bias_rad, std::numbers::pi / 2));
    }
    const double r2 = options.sampling.radius_m * options.sampling.radius_m;
    double rise = 0;
    march.ForEachSample(slice, 1, [&](double x, double y, double d2) {
        const double sin_s = (x * slice.t.z() + y * slice.V.z()) / std::sqrt(x * x + y * y);
        if (sin_s <= sin_h) return;
        rise += (options.attenuate ? 1 - d2 / r2 : 1) * (sin_s - sin_h);
        sin_h = sin_s;
    });
    return rise;
}

double Visibility(SliceMarch& march, const HbaoOptions& options, int x, int y) {
    if (!march.Receive(x, y)) return 1;
    const int directions = 2 * options.sampling.slices;
    double sum = 0;
    for (int k = 0; k < directions; ++k) {
        sum += Rise(march, options, march.Phi(k, directions, 2 * std::numbers::pi));
    }
    return std::clamp(1 - options.strength * sum / directions, 0.0, 1.0);
}

}  // namespace

void Validate(const HbaoOptions& options) {
    Validate(options.sampling, "HbaoOptions");
    if (!(options.bias_rad >= 0 && options.bias_rad < std::numbers::pi / 2))
        throw Error(MustBe("HbaoOptions::bias_rad", options.bias_rad, "in [0, pi/2)"));
    if (!(options.strength >= 0 && options.strength <= 100))
        throw Error(MustBe("HbaoOptions::strength", options.strength, "in [0, 100]"));
}

double HbaoOfPixel(const GBuffer& gbuffer, const HbaoOptions& options, int x, int y) {
    Validate(options);
    SliceMarch march(gbuffer, options.sampling);
    return Visibility(march, options, x, y);
}

Image<float> Hbao(const GBuffer& gbuffer, const HbaoOptions& options) {
    return Hbao(gbuffer, options, Drawn(gbuffer.view));
}

Image<float> Hbao(const GBuffer& gbuffer, const HbaoOptions& options, const PixelRect& where) {
    Validate(options);
    return EveryTile(gbuffer, options.sampling, where,
                     [&](const SliceTask& task, const PixelRect& tile, Image<float>& A) {
                         HbaoTile(task, options, tile, A);
                     });
}

}  // namespace plumb
