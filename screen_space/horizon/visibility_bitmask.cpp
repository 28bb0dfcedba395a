#include "screen_space/horizon/visibility_bitmask.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "screen_space/horizon/every_pixel.h"
#include "screen_space/horizon/slice_integral.h"

namespace plumb {
namespace {

constexpr double kHalfPi = std::numbers::pi / 2;

/// The first `count` of 64 sectors.
std::uint64_t FirstSectors(int count) {
    return count >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
}

/// How many sectors of a slice are closed.
int ClosedOf(const SliceMarch& march, const Slice& slice, const BitmaskOptions& options) {
    const double gamma = slice.gamma_rad;
    const auto share = [&](double x, double y) {
        const double th = std::atan2(x, y);
        return SectorShare(std::clamp(th, gamma - kHalfPi, gamma + kHalfPi), gamma,
                           options.measure);
    };
    std::uint64_t closed = 0;
    for (const int side : {1, -1}) {
        march.ForEachSample(slice, side, [&](double x, double y, double) {
            const double front = share(x, y);
            const double back = std::isinf(options.thickness_m)
                                    ? (side > 0 ? 1.0 : 0.0)
                                    : share(x, y - options.thickness_m);
            closed |= ClosedSectors(std::min(front, back), std::max(front, back),
                                    options.sectors, options.rounding);
        });
    }
    return std::popcount(closed);
}

double Visibility(SliceMarch& march, const BitmaskOptions& options, int x, int y) {
    if (!march.Receive(x, y)) return 1;
    const int N = options.sampling.slices;
    double sum = 0, weights = 0;
    for (int k = 0; k < N; ++k) {
        const Slice slice = march.SliceAt(march.Phi(k, N, std::numbers::pi));
        const double T = options.measure == SectorMeasure::kCosine
                             ? slice.L * OpenSlice(slice.gamma_rad)
                             : 1;
        sum += T * (1 - double(ClosedOf(march, slice, options)) / options.sectors);
        weights += T;
    }
    const double total = options.normalize ? weights : N;
    return total > 0 ? sum / total : 1;
}

}  // namespace

void Validate(const BitmaskOptions& options) {
    Validate(options.sampling, "BitmaskOptions");
    if (!(options.thickness_m > 0))
        throw Error(MustBe("BitmaskOptions::thickness_m", options.thickness_m, "> 0"));
    if (options.sectors < 1 || options.sectors > 64)
        throw Error(MustBe("BitmaskOptions::sectors", options.sectors, "in [1, 64]"));
}

std::uint64_t ClosedSectors(double h_1, double h_2, int sectors, SectorRounding rounding) {
    const auto S = double(sectors);
    int first, count;
    if (rounding == SectorRounding::kCeil) {
        first = int(std::floor(h_1 * S));
        count = int(std::ceil((h_2 - h_1) * S));
    } else {
        first = int(std::round(h_1 * S));
        count = int(std::round(h_2 * S)) - first;
    }
    if (first >= sectors || count <= 0) return 0;
    return FirstSectors(count) << first & FirstSectors(sectors);
}

double SectorShare(double th_rad, double gamma_rad, SectorMeasure measure) {
    double share = (th_rad - gamma_rad + kHalfPi) / std::numbers::pi;
    if (measure == SectorMeasure::kCosine) {
        const double below = SliceIntegral(gamma_rad - kHalfPi, gamma_rad);
        const double to_th = SliceIntegral(th_rad, gamma_rad);
        share = (below + (th_rad < 0 ? -to_th : to_th)) / OpenSlice(gamma_rad);
    }
    return std::clamp(share, 0.0, 1.0);
}

double VisibilityBitmaskOfPixel(const GBuffer& gbuffer, const BitmaskOptions& options, int x,
                                int y) {
    Validate(options);
    SliceMarch march(gbuffer, options.sampling);
    return Visibility(march, options, x, y);
}

Image<float> VisibilityBitmask(const GBuffer& gbuffer, const BitmaskOptions& options) {
    return VisibilityBitmask(gbuffer, options, Drawn(gbuffer.view));
}

Image<float> VisibilityBitmask(const GBuffer& gbuffer, const BitmaskOptions& options,
                               const PixelRect& where) {
    Validate(options);
    if (options.sectors <= kSectorsOfTile) {
        return EveryTile(gbuffer, options.sampling, where,
                         [&](const SliceTask& task, const PixelRect& tile, Image<float>& A) {
                             BitmaskTile(task, options, tile, A);
                         });
    }
    return EveryPixel(gbuffer, options.sampling, where, [&](SliceMarch& march, int x, int y) {
        return Visibility(march, options, x, y);
    });
}

}  // namespace plumb
