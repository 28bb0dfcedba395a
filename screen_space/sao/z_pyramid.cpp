#include "screen_space/sao/z_pyramid.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <string>

#include "core/error.h"
#include "core/parallel.h"

namespace plumb {
namespace {

constexpr float kSky = -std::numeric_limits<float>::infinity();
constexpr float kFarthest = -1e18f, kNearest = -1e-18f;  // their squares are finite floats

[[noreturn]] void ThrowBadDepth(const Image<float>& z_m, int j) {
    for (int i = 0; i < z_m.Width(); ++i) {
        const float z = z_m(i, j);
        if (!(z >= kFarthest && z <= kNearest) && z != kSky) {
            throw Error(
                MustBe("GBuffer::z_m(" + std::to_string(i) + ", " + std::to_string(j) + ")", z,
                       "in [-1e18, -1e-18] or the sky's -inf"));
        }
    }
    throw Error("GBuffer::z_m: row " + std::to_string(j) + " is not a depth");
}

}  // namespace

void ZPyramid::Build(const Image<float>& z_m, ZFilter filter, int coarsest) {
    assert(!z_m.Empty() && 0 <= coarsest && coarsest < kMostLevels);
    coarsest_ = coarsest;
    int width = z_m.Width(), height = z_m.Height();
    const int lanes = 16;  // of the widest vectors
    const int whole = std::max(1 << coarsest, lanes);
    span_ = (width + whole - 1) / whole * whole;
    // An odd number of cache lines: rows above each other then compete for no lines of the cache.
    pitch_ = span_ / lanes % 2 == 0 ? span_ + lanes : span_;
    const int rows = coarsest > 0 ? height + (height + 1) / 2 : height;
    for (int level = 0; level <= coarsest; ++level) {
        levels_[std::size_t(level)] = {
            width, height,
            level == 0 ? 0 : Strip() - std::int32_t(2 * std::int64_t(span_) >> level)};
        width = (width + 1) / 2;
        height = (height + 1) / 2;
    }
    const std::size_t texels = std::size_t(rows) * std::size_t(pitch_);
    if (capacity_ < texels) {
        texels_ = std::make_unique_for_overwrite<float[]>(texels + 2 * kMargin);
        capacity_ = texels;
    }
    std::fill_n(texels_.get(), kMargin, kSky);
    std::fill_n(texels_.get() + kMargin + texels, kMargin, kSky);
    CopyFinest(z_m);
    for (int level = 1; level <= coarsest; ++level) Minify(filter, level);
}

void ZPyramid::CopyFinest(const Image<float>& z_m) {
    const int width = z_m.Width();
    ParallelFor(z_m.Height(), 16, [&](std::int64_t begin, std::int64_t end) {
        for (int j = int(begin); j < int(end); ++j) {
            const float* from = &z_m(0, j);
            float* to = Row(0, j);
            int good = 0;
            for (int i = 0; i < width; ++i) {
                const float z = from[i];
                to[i] = z;
                good += (int(z >= kFarthest) & int(z <= kNearest)) | int(z == kSky);
            }
            if (good != width) ThrowBadDepth(z_m, j);
            std::fill(to + width, to + pitch_, kSky);
        }
    });
}

void ZPyramid::Minify(ZFilter filter, int level) {
    const Level fine = At(level - 1), coarse = At(level);
    ParallelFor(coarse.height, 16, [&](std::int64_t begin, std::int64_t end) {
        for (int y = int(begin); y < int(end); ++y) {
            const float* const rows[2] = {Row(level - 1, 2 * y),
                                          Row(level - 1, std::min(2 * y + 1, fine.height - 1))};
            float* to = Row(level, y);
            for (int x = 0; x < coarse.width; ++x) {
                to[x] = Minified<float>(filter, x, y, [&](int i, int j) {
                    return rows[j][std::min(2 * x + i, fine.width - 1)];
                });
            }
        }
    });
}

}  // namespace plumb
