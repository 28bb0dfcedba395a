// The z pyramid: depth at halved resolutions, so that taps far apart still meet the cache.
//
//       rotated grid       z'(x, y) = z(2x + (y & 1 ^ 1), 2y + (x & 1 ^ 1))
//       arithmetic mean    1/4 Sum z(2x + i, 2y + j),            i, j in {0, 1}
//       harmonic mean      4 / Sum 1 / z
//       min                the farthest of the four (z < 0)
//       max                the nearest of the four
//
// Source   [McGuire12 table 1], section 2.2. G3D 10 takes the rotated grid without "^ 1".
// Symbols  z of one level, z' of the next coarser one (m, camera's frame, < 0).
// Domain   Any size. A level has half the texels of the one below it, rounded up, so that texel
//          (x >> m, y >> m) of level m exists for each pixel; a source beyond the border is the
//          border's texel.
// Beware   Table 1 prints the harmonic mean as [Sum 4 / z]^-1, which of four equal z is z / 16. We
//          compute the mean. OpenGL rounds sizes down, so that its last odd row and column are in
//          no coarser level; the two agree for sizes that 2^levels divides.
//          The sky is z = -inf: any sky makes a mean sky, and counts as 0 in the sum of 1 / z.
// Cost     4/3 of a copy of the picture; 3/2 of its memory.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>

#include "core/image.h"

namespace plumb {

enum class ZFilter {
    kRotatedGrid,       ///< As printed, and as in the supplement of 2012.
    kRotatedGridG3d10,  ///< Without "^ 1", as in G3D 10.
    kMean,
    kHarmonicMean,
    kMin,
    kMax,
};

/// The value of a coarser level's texel (x, y), given its four sources: `at(i, j)` is the finer
/// level at (2x + i, 2y + j).
template <class Real, class At>
Real Minified(ZFilter filter, int x, int y, const At& at) {
    switch (filter) {
        case ZFilter::kRotatedGrid:
            return at((y & 1) ^ 1, (x & 1) ^ 1);
        case ZFilter::kRotatedGridG3d10:
            return at(y & 1, x & 1);
        case ZFilter::kMean:
            return (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1)) / 4;
        case ZFilter::kHarmonicMean:
            return 4 / (1 / at(0, 0) + 1 / at(1, 0) + 1 / at(0, 1) + 1 / at(1, 1));
        case ZFilter::kMin:
            return std::min(std::min(at(0, 0), at(1, 0)), std::min(at(0, 1), at(1, 1)));
        case ZFilter::kMax:
            return std::max(std::max(at(0, 0), at(1, 0)), std::max(at(0, 1), at(1, 1)));
    }
    return at(0, 0);
}

class ZPyramid {
  public:
    static constexpr int kMostLevels = 15;  ///< Of 16384 px: 2^14 is its coarsest, 1 texel.

    struct Level {
        int width = 0, height = 0;
        std::int32_t offset = 0;  ///< Of its first texel in Data().
    };

    /// Levels 0 to `coarsest`, which is in [0, kMostLevels). Throws Error where z is not in
    /// [-1e18, -1e-18] m and not the sky, naming the pixel: NaN, 0 and what lies behind the eye.
    ZPyramid(const Image<float>& z_m, ZFilter filter, int coarsest) {
        Build(z_m, filter, coarsest);
    }
    ZPyramid() = default;

    /// Anew, in the memory there is if it is enough.
    void Build(const Image<float>& z_m, ZFilter filter, int coarsest);

    int Coarsest() const { return coarsest_; }
    const Level& At(int level) const { return levels_[std::size_t(level)]; }

    float operator()(int level, int i, int j) const {
        return Data()[At(level).offset + j * pitch_ + i];
    }

    /// All levels in one piece: texel (i, j) of a level is at offset + j Pitch() + i. The coarser
    /// ones stand side by side below the finest: their offsets are Strip() - (2 Span() >> level).
    const float* Data() const { return texels_.get() + kMargin; }
    std::int32_t Pitch() const { return pitch_; }
    std::int32_t Span() const { return span_; }
    std::int32_t Strip() const { return levels_[0].height * pitch_ + span_; }

    /// Data() may be read, if only to be thrown away, this far beyond both ends.
    static constexpr std::int32_t kMargin = 64;

  private:
    void CopyFinest(const Image<float>& z_m);
    void Minify(ZFilter filter, int level);
    float* Row(int level, int j) {
        return texels_.get() + kMargin + At(level).offset + j * pitch_;
    }

    int coarsest_ = 0;
    std::int32_t pitch_ = 0, span_ = 0;
    std::array<Level, kMostLevels> levels_{};
    std::size_t capacity_ = 0;
    std::unique_ptr<float[]> texels_;
};

}  // namespace plumb
