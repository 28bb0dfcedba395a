#include <algorithm>
#include <cstring>

#include "screen_space/raster/draw_in_tile.h"

namespace plumb {

namespace {

constexpr int kLast = kTilePx - 1;

// Corners so near to the tile that products of their coordinates fit 32 bits: most are.
constexpr std::int32_t kNear = kTilePx * kSubPixels;

bool IsNear(const FixedPoint& p) {
    return -kNear <= p.x && p.x <= kNear && -kNear <= p.y && p.y <= kNear;
}

// The same as Edge, from the tile's corner, in 32 bits.
void SetNearEdge(const FixedPoint& a, const FixedPoint& b, std::size_t k, TileTriangle& out) {
    constexpr int kCentre = kSubPixels / 2;
    const std::int32_t dx = b.x - a.x, dy = b.y - a.y;
    const std::int32_t top_left = dy < 0 || (dy == 0 && dx > 0) ? 0 : 1;
    out.F[k] = (dx * (kCentre - a.y) - dy * (kCentre - a.x) - top_left) >> 8;
    out.dx[k] = dx;
    out.dy[k] = dy;
}

void SetFarEdge(const Edge& edge, int i, int j, std::size_t k, TileTriangle& out) {
    if (edge.Least(i, j, kLast, kLast) >= 0) return;
    if (edge.Most(i, j, kLast, kLast) < 0) out.i_1 = -1;
    out.F[k] = std::int32_t(edge.At(i, j));
    out.dx[k] = edge.dx;
    out.dy[k] = edge.dy;
}

}  // namespace

void StoreDepthRow(const Tile& tile, int j, int pixels, DepthFormat format,
                   std::uint32_t* out) {
    const float* const key = tile.key.data() + j * kTileStride;
    if (format == DepthFormat::kD32FReversed) {
        std::memcpy(out, key, sizeof(float) * std::size_t(pixels));
        return;
    }
    for (int i = 0; i < pixels; ++i) out[i] = BitsOfKey(format, key[i]);
}

TileTriangle InTile(const ScreenTriangle& triangle, int column, int row) {
    TileTriangle out;
    const int i = column * kTilePx, j = row * kTilePx;
    std::array<FixedPoint, 3> p = triangle.corners;
    for (FixedPoint& corner : p) {
        corner.x -= i * kSubPixels;
        corner.y -= j * kSubPixels;
    }
    const std::int32_t x_min = std::min(std::min(p[0].x, p[1].x), p[2].x);
    const std::int32_t x_max = std::max(std::max(p[0].x, p[1].x), p[2].x);
    const std::int32_t y_min = std::min(std::min(p[0].y, p[1].y), p[2].y);
    const std::int32_t y_max = std::max(std::max(p[0].y, p[1].y), p[2].y);
    out.i_0 = std::max(FirstPixel(x_min), 0);
    out.i_1 = std::min(LastPixel(x_max), kLast);
    out.j_0 = std::max(FirstPixel(y_min), 0);
    out.j_1 = std::min(LastPixel(y_max), kLast);
    if (IsNear(p[0]) && IsNear(p[1]) && IsNear(p[2])) {
        for (std::size_t k = 0; k < 3; ++k) SetNearEdge(p[k], p[(k + 1) % 3], k, out);
    } else {
        const TriangleEdges edges = EdgesOf(triangle.corners);
        for (std::size_t k = 0; k < 3; ++k) SetFarEdge(edges[k], i, j, k, out);
    }
    out.e = float(triangle.e_0 + triangle.e_x * (i + 0.5) + triangle.e_y * (j + 0.5));
    out.e_x = float(triangle.e_x);
    out.e_y = float(triangle.e_y);
    out.e_min = triangle.e_min;
    out.e_max = triangle.e_max;
    out.triangle = triangle.triangle;
    return out;
}

}  // namespace plumb
