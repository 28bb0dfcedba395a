#include "jobs/light/histograms.h"

namespace plumb {

BinnedBy BinningFor(const ModelInputs& inputs) {
    if (inputs.alpha && inputs.V) return BinnedBy::kBothVisibilities;
    return inputs.V ? BinnedBy::kCosineVisibility : BinnedBy::kUniformVisibility;
}

const BounceHistogram& HistogramBy(BinnedBy binned_by, const SurfaceLight& light) {
    switch (binned_by) {
        case BinnedBy::kUniformVisibility:
            return light.over_alpha;
        case BinnedBy::kCosineVisibility:
            return light.over_V;
        case BinnedBy::kBothVisibilities:
            break;
    }
    return light.over_both;
}

std::vector<BounceHistogram> HistogramsBy(BinnedBy binned_by,
                                          std::span<const SurfaceLight> lights) {
    std::vector<BounceHistogram> histograms;
    for (const SurfaceLight& light : lights) {
        histograms.push_back(HistogramBy(binned_by, light));
    }
    return histograms;
}

}  // namespace plumb
