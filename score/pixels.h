// The one loop over the pixels that count, tile by tile, and what is asked of the images.
#pragma once

#include <cmath>
#include <initializer_list>
#include <span>
#include <string>

#include "core/error.h"
#include "core/image.h"
#include "core/parallel.h"
#include "score/over_tiles.h"

namespace plumb {

/// Throws Error where an image has another size than the truth, or none has a pixel.
/// `standard_error` and `mask` may be empty.
inline void CheckSizes(const Image<float>& candidate, const Image<float>& truth,
                       const Image<float>& standard_error, const Mask& mask) {
    if (truth.Empty()) throw Error(MustBe("truth: pixels", 0, ">= 1"));
    const auto check = [&](const char* name, int width, int height) {
        if (width != truth.Width())
            throw Error(MustBe(std::string(name) + ": width", width,
                               "that of the truth, " + std::to_string(truth.Width())));
        if (height != truth.Height())
            throw Error(MustBe(std::string(name) + ": height", height,
                               "that of the truth, " + std::to_string(truth.Height())));
    };
    check("candidate", candidate.Width(), candidate.Height());
    if (!standard_error.Empty())
        check("standard error", standard_error.Width(), standard_error.Height());
    if (!mask.Empty()) check("mask", mask.Width(), mask.Height());
}

/// The same of pictures of several channels; throws too where their numbers differ, or there is
/// none.
inline void CheckChannels(std::initializer_list<std::span<const Image<float>>> candidates,
                          std::span<const Image<float>> truth,
                          std::span<const Image<float>> standard_error, const Mask& mask) {
    if (truth.empty()) throw Error(MustBe("truth: channels", 0, ">= 1"));
    const auto check = [&](const char* name, std::size_t channels) {
        if (channels == truth.size()) return;
        throw Error(MustBe(std::string(name) + ": channels", double(channels),
                           "as many as the truth's, " + std::to_string(truth.size())));
    };
    const Image<float> none;
    if (!standard_error.empty()) check("standard error", standard_error.size());
    for (const std::span<const Image<float>> candidate : candidates) {
        check("candidate", candidate.size());
        for (std::size_t c = 0; c < truth.size(); ++c) {
            CheckSizes(truth[c], truth[0], {}, {});
            CheckSizes(candidate[c], truth[0],
                       standard_error.empty() ? none : standard_error[c], mask);
        }
    }
}

/// The pixel as double. Throws Error, naming image and pixel, if it is not finite.
inline double FinitePixel(const Image<float>& image, int i, int j, const char* name) {
    const double value = image(i, j);
    if (!std::isfinite(value)) {
        throw Error(
            MustBe(std::string(name) + "[" + std::to_string(i) + ", " + std::to_string(j) + "]",
                   value, "finite"));
    }
    return value;
}

/// visit(tile, i, j, s^2) for every pixel that counts; the pixels of a tile in row order, by
/// one thread: a visit may add to the slot of its tile and to nothing else.
template <class Visit>
void ForEachCounted(const Tiling& tiling, const Image<float>& standard_error, const Mask& mask,
                    const Visit& visit) {
    ParallelFor(tiling.Rows(), 1, [&](std::int64_t begin, std::int64_t end) {
        const int first = int(begin) * tiling.tile_px;
        const int last = std::min(int(end) * tiling.tile_px, tiling.height_px);
        for (int j = first; j < last; ++j) {
            for (int i = 0; i < tiling.width_px; ++i) {
                if (!mask.Empty() && mask(i, j) == 0) continue;
                double s2 = 0;
                if (!standard_error.Empty()) {
                    const double s = FinitePixel(standard_error, i, j, "standard error");
                    s2 = s * s;
                }
                visit(tiling.TileOf(i, j), i, j, s2);
            }
        }
    });
}

/// visit(tile, channel, i, j, s^2) of every channel, one after the other.
template <class Visit>
void ForEachCounted(const Tiling& tiling, std::span<const Image<float>> standard_error,
                    int channels, const Mask& mask, const Visit& visit) {
    const Image<float> none;
    for (int channel = 0; channel < channels; ++channel) {
        ForEachCounted(
            tiling, standard_error.empty() ? none : standard_error[channel], mask,
            [&](int tile, int i, int j, double s2) { visit(tile, channel, i, j, s2); });
    }
}

}  // namespace plumb
