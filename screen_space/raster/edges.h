// Which pixels a triangle covers, in whole numbers.
//
//       E(p) = dx (p_y - a_y) - dy (p_x - a_x)  of the edge from a to b, (dx, dy) = b - a
//       covered:  E > 0 for all three edges,  or E = 0 on a top or a left edge
//
// with p the pixel's centre and the corners in order such that E > 0 inside. A pixel of 256
// steps moves E by multiples of 256, so floor(E / 256) tells its sign, exactly, and near the
// edge it fits 32 bits:
//
//       F(i, j) = floor(E / 256) = F_0 + dx j - dy i,    covered: F >= 0 for all three
//
// With y downwards such corners run clockwise: an edge that goes up is a left edge, a level edge
// that goes right is a top edge. On all others 1 is taken from E, so that E = 0 is outside.
//
// Source   the top-left rule of Direct3D and of most OpenGL drivers; 8 sub-pixel bits.
#pragma once

#include <array>
#include <cstdint>

#include "screen_space/raster/vertex_stage.h"

namespace plumb {

struct Edge {
    std::int32_t dx = 0, dy = 0;  ///< At most 2^23 with kReachPx.
    std::int64_t F_0 = 0;         ///< F of pixel (0, 0).

    Edge() = default;
    Edge(const FixedPoint& a, const FixedPoint& b) : dx(b.x - a.x), dy(b.y - a.y) {
        constexpr int kCentre = kSubPixels / 2;
        const bool top_left = dy < 0 || (dy == 0 && dx > 0);
        const std::int64_t E = std::int64_t{dx} * (kCentre - a.y) -
                               std::int64_t{dy} * (kCentre - a.x) - (top_left ? 0 : 1);
        F_0 = E >> 8;
    }

    std::int64_t At(int i, int j) const {
        return F_0 + std::int64_t{dx} * j - std::int64_t{dy} * i;
    }

    /// The largest and the smallest F over the pixels (i, j) to (i + w, j + h).
    std::int64_t Most(int i, int j, int w, int h) const {
        return At(dy < 0 ? i + w : i, dx > 0 ? j + h : j);
    }
    std::int64_t Least(int i, int j, int w, int h) const {
        return At(dy < 0 ? i : i + w, dx > 0 ? j : j + h);
    }
};

/// Twice the area in (1/256 pixel)^2; > 0 if the corners run clockwise in the picture.
inline std::int64_t TwiceArea(const FixedPoint& a, const FixedPoint& b, const FixedPoint& c) {
    return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
}

/// The first and the last pixel whose centre lies within [low, high] in fixed point.
inline int FirstPixel(std::int32_t low) {
    return (low + kSubPixels / 2 - 1) >> 8;
}
inline int LastPixel(std::int32_t high) {
    return (high - kSubPixels / 2) >> 8;
}

using TriangleEdges = std::array<Edge, 3>;

inline TriangleEdges EdgesOf(const std::array<FixedPoint, 3>& p) {
    return {Edge(p[0], p[1]), Edge(p[1], p[2]), Edge(p[2], p[0])};
}

}  // namespace plumb
