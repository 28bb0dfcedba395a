// Pass 1 of SMAA: which pixels have an edge at their left or top border.
//
//       delta_left = |L - L_left|,  delta_top = |L - L_top|
//       edge if delta >= t and c delta >= m
//       m = max( delta_left, delta_top, |L - L_right|, |L - L_bottom|,
//                |L_left - L_leftleft|, |L_top - L_toptop| )
//
// Source   [Jimenez12]; both edges share one m, as in its shader.
// Beware   The border is repeated: there is no edge at the picture's own border.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/image.h"
#include "screen_space/antialiasing/smaa.h"

namespace plumb {

/// Edges as bits.
class SmaaEdges {
  public:
    static constexpr std::uint8_t kLeft = 1, kTop = 2;

    explicit SmaaEdges(Image<std::uint8_t> bits) : bits_(std::move(bits)) {}

    int Width() const { return bits_.Width(); }
    int Height() const { return bits_.Height(); }
    std::uint8_t Bits(int x, int y) const { return bits_(x, y); }

    /// Of any (x, y): outside, those of the nearest pixel.
    bool Left(int x, int y) const { return (Nearest(x, y) & kLeft) != 0; }
    bool Top(int x, int y) const { return (Nearest(x, y) & kTop) != 0; }

  private:
    std::uint8_t Nearest(int x, int y) const {
        return bits_(std::clamp(x, 0, bits_.Width() - 1), std::clamp(y, 0, bits_.Height() - 1));
    }

    Image<std::uint8_t> bits_;
};

/// The picture must not be empty.
SmaaEdges FindSmaaEdges(const Image<Rgb>& encoded, const SmaaOptions& options);

}  // namespace plumb
