// A texture and its smaller copies: level l has about 1/2^l of its edges.
//
//       level l + 1: each texel the mean of the part of level l that it covers
//
// Sizes are halved and rounded down, to 1 at least, as graphics libraries have them; where a size is
// odd a texel covers more than two of the level below it, weighted by area.
//
// Beware   Opacity has no levels: an alpha test needs the sharp one.
#pragma once

#include <vector>

#include "core/texture.h"

namespace plumb {

class MipChain {
  public:
    explicit MipChain(const Texture& texture);

    int Levels() const { return int(levels_.size()); }
    const Image<Rgb>& Level(int l) const { return levels_[std::size_t(l)].albedo; }

    /// Bilinear in the two levels around `level`, mixed by its fraction. Below 0: level 0; beyond
    /// the last: the last. Exactly SampleAlbedo at level 0.
    Rgb Trilinear(const Vec2f& uv, double level) const;

  private:
    std::vector<Texture> levels_;
};

}  // namespace plumb
