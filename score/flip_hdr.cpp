#include "score/flip_hdr.h"

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

Image<Rgb> ShownAt(const HdrFlipOptions& options, double stops, const Image<Rgb>& picture) {
    Image<Rgb> shown = picture;
    const double factor = std::exp2(stops);
    for (Rgb& pixel : shown.Pixels()) {
        for (float& c : pixel) c = float(factor * std::max(double(c), 0.0));
        pixel = Shown(options.curve, pixel);
    }
    return shown;
}

}  // namespace

HdrFlip HdrFlipMap(const Image<Rgb>& candidate, const Image<Rgb>& reference, const Mask& mask,
                   const HdrFlipOptions& options) {
    HdrFlip result;
    result.exposures =
        options.exposures ? *options.exposures : ExposuresOf(options.curve, reference, mask);
    for (int k = 0; k < result.exposures.count; ++k) {
        const double stops = result.exposures.At(k);
        Image<float> map = FlipMap(ShownAt(options, stops, candidate),
                                   ShownAt(options, stops, reference), options.flip);
        if (k == 0) {
            result.map = std::move(map);
            continue;
        }
        for (std::size_t p = 0; p < map.Pixels().size(); ++p) {
            result.map.Pixels()[p] = std::max(result.map.Pixels()[p], map.Pixels()[p]);
        }
    }
    return result;
}

}  // namespace plumb
