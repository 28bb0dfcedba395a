#include "jobs/light/facet_scores.h"

#include <cmath>
#include <vector>

#include "core/parallel.h"
#include "formfactor/histogram.h"

namespace plumb {
namespace {

// Bins along a side of the grid whose spread is the floor of both visibilities.
constexpr int kFloorGridSide = 100;

double FloorOver(const BounceHistogram& histogram) {
    double sum = 0;
    for (std::size_t r = 0; r < histogram.albedos.size(); ++r) {
        const double floor = FloorOf(histogram, int(r), true);
        sum += floor * floor;
    }
    return std::sqrt(sum / double(histogram.albedos.size()));
}

}  // namespace

double FacetRms(const Formula& formula, const SurfaceLight& light) {
    constexpr std::int64_t kChunk = 1024;
    const std::int64_t stride =
        (std::int64_t(light.V.size()) + kScoredFacets - 1) / kScoredFacets;
    const std::int64_t n = (std::int64_t(light.V.size()) + stride - 1) / stride;
    struct Sum {
        double square = 0;
        std::int64_t count = 0;
    };
    std::vector<Sum> sums(std::size_t((n + kChunk - 1) / kChunk));
    ParallelFor(n, kChunk, [&](std::int64_t begin, std::int64_t end) {
        Sum& sum = sums[std::size_t(begin / kChunk)];
        for (std::size_t r = 0; r < light.albedos.size(); ++r) {
            for (std::int64_t k = begin; k < end; ++k) {
                const std::size_t i = std::size_t(k * stride);
                const double f =
                    formula({UniformVisibility(light.alpha[i]), CosineVisibility(light.V[i]),
                             Albedo(light.albedos[r])});
                if (!std::isfinite(f)) continue;
                const double error = f - double(light.total[r][i]);
                sum.square += error * error;
                ++sum.count;
            }
        }
    });
    Sum all;
    for (const Sum& sum : sums) all.square += sum.square, all.count += sum.count;
    return all.count > 0 ? std::sqrt(all.square / double(all.count)) : SurfaceFigures::kUnknown;
}

Floors FloorsOf(const SurfaceLight& light) {
    // The grid of the fits is too coarse to be a floor: its bins are wider than a histogram's.
    HistogramBuilder both(light.name, BinnedBy::kBothVisibilities, kFloorGridSide, light.alpha,
                          light.V);
    for (std::size_t r = 0; r < light.albedos.size(); ++r) {
        both.AddTotal(light.albedos[r], light.total[r]);
    }
    return {FloorOver(light.over_alpha), FloorOver(light.over_V), FloorOver(both.Result())};
}

}  // namespace plumb
