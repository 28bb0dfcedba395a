#include "screen_space/horizon/gtao.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "screen_space/horizon/every_pixel.h"
#include "screen_space/horizon/slice_integral.h"

namespace plumb {
namespace {

/// A of V.
double Raised(double V, const GtaoOptions& options) {
    return std::max(options.least, options.power == 1 ? V : std::pow(V, options.power));
}

/// cos h of one side of a slice, at least that of the tangent plane.
double HorizonCosine(const SliceMarch& march, const Slice& slice, int side,
                     const GtaoOptions& options) {
    const double r = options.sampling.radius_m;
    const double start = options.falloff_start * r;
    const double c_low = -side * std::sin(slice.gamma_rad);  // cos(gamma + side pi/2)
    const double c_far = options.fade == HorizonFade::kBehind ? -1 : c_low;
    double cos_h = c_low;
    march.ForEachSample(slice, side, [&](double x, double y, double d2) {
        double c = y / std::sqrt(x * x + y * y);
        if (d2 > start * start) {
            c = c_far + (c - c_far) * (r - std::sqrt(d2)) / (r - start);
        }
        if (c >= cos_h) {
            cos_h = c;
        } else {
            cos_h += (std::max(c, c_low) - cos_h) * options.thickness_blend;
        }
    });
    return std::clamp(cos_h, -1.0, 1.0);
}

double Visibility(SliceMarch& march, const GtaoOptions& options, int x, int y) {
    if (!march.Receive(x, y)) return 1;
    const int N = options.sampling.slices;
    double sum = 0, open = 0;
    for (int k = 0; k < N; ++k) {
        const Slice slice = march.SliceAt(march.Phi(k, N, std::numbers::pi));
        const double gamma = slice.gamma_rad;
        const double h_1 = std::acos(HorizonCosine(march, slice, 1, options));
        const double h_0 = -std::acos(HorizonCosine(march, slice, -1, options));
        const double L = slice.L + options.length_lift * (1 - slice.L);
        sum += L * (SliceIntegral(h_0, gamma) + SliceIntegral(h_1, gamma));
        open += L * OpenSlice(gamma);
    }
    const double total = options.normalize ? open : N;
    return total > 0 ? Raised(std::max(sum / total, 0.0), options) : 1;
}

}  // namespace

void Validate(const GtaoOptions& options) {
    Validate(options.sampling, "GtaoOptions");
    if (!(options.falloff_start >= 0 && options.falloff_start <= 1))
        throw Error(MustBe("GtaoOptions::falloff_start", options.falloff_start, "in [0, 1]"));
    if (!(options.thickness_blend >= 0 && options.thickness_blend < 1))
        throw Error(
            MustBe("GtaoOptions::thickness_blend", options.thickness_blend, "in [0, 1)"));
    if (!(options.length_lift >= 0 && options.length_lift <= 1))
        throw Error(MustBe("GtaoOptions::length_lift", options.length_lift, "in [0, 1]"));
    if (!(options.power >= 0.1 && options.power <= 10))
        throw Error(MustBe("GtaoOptions::power", options.power, "in [0.1, 10]"));
    if (!(options.least >= 0 && options.least <= 1))
        throw Error(MustBe("GtaoOptions::least", options.least, "in [0, 1]"));
}

double GtaoOfPixel(const GBuffer& gbuffer, const GtaoOptions& options, int x, int y) {
    Validate(options);
    SliceMarch march(gbuffer, options.sampling);
    return Visibility(march, options, x, y);
}

Image<float> Gtao(const GBuffer& gbuffer, const GtaoOptions& options) {
    return Gtao(gbuffer, options, Drawn(gbuffer.view));
}

Image<float> Gtao(const GBuffer& gbuffer, const GtaoOptions& options, const PixelRect& where) {
    Validate(options);
    return EveryTile(gbuffer, options.sampling, where,
                     [&](const SliceTask& task, const PixelRect& tile, Image<float>& A) {
                         GtaoTile(task, options, tile, A);
                         if (options.power == 1 && options.least == 0) return;
                         for (int y = tile.y0; y < tile.y1; ++y) {
                             for (int x = tile.x0; x < tile.x1; ++x) {
                                 A(x, y) = float(Raised(A(x, y), options));
                             }
                         }
                     });
}

}  // namespace plumb
