#include "screen_space/draw_in_tile.h"

#include <algorithm>

namespace plumb {

TileTriangle InTile(const ScreenTriangle& triangle, int column, int row) {
    TileTriangle out;
    const int i = column * kTilePx, j = row * kTilePx;
    const auto& [a, b, c] = triangle.corners;
    const auto [x_min, x_max] = std::minmax({a.x, b.x, c.x});
    const auto [y_min, y_max] = std::minmax({a.y, b.y, c.y});
    constexpr int kLast = kTilePx - 1, kHalf = kSubPixels / 2;
    out.i_0 = std::max(((x_min + kHalf - 1) >> 8) - i, 0);
    out.i_1 = std::min(((x_max - kHalf) >> 8) - i, kLast);
    out.j_0 = std::max(((y_min + kHalf - 1) >> 8) - j, 0);
    out.j_1 = std::min(((y_max - kHalf) >> 8) - j, kLast);
    const TriangleEdges edges = EdgesOf(triangle.corners);
    for (std::size_t k = 0; k < 3; ++k) {
        const Edge& edge = edges[k];
        if (edge.Least(i, j, kLast, kLast) >= 0) continue;
        if (edge.Most(i, j, kLast, kLast) < 0) out.i_1 = -1;
        out.F[k] = std::int32_t(edge.At(i, j));
        out.dx[k] = edge.dx;
        out.dy[k] = edge.dy;
    }
    out.e = float(triangle.e_0 + triangle.e_x * (i + 0.5) + triangle.e_y * (j + 0.5));
    out.e_x = float(triangle.e_x);
    out.e_y = float(triangle.e_y);
    out.e_min = triangle.e_min;
    out.e_max = triangle.e_max;
    out.triangle = triangle.triangle;
    return out;
}

void DrawInTile(std::span<const TileTriangle> triangles, DepthFormat format,
                bool with_triangles, Tile& tile) {
    for (const TileTriangle& t : triangles) {
        for (int j = t.j_0; j <= t.j_1; ++j) {
            for (int i = t.i_0; i <= t.i_1; ++i) {
                const bool covered = t.F[0] + t.dx[0] * j - t.dy[0] * i >= 0 &&
                                     t.F[1] + t.dx[1] * j - t.dy[1] * i >= 0 &&
                                     t.F[2] + t.dx[2] * j - t.dy[2] * i >= 0;
                if (!covered) continue;
                const float e = (t.e + t.e_y * float(j)) + t.e_x * float(i);
                const float key = KeyOf(format, std::min(std::max(e, t.e_min), t.e_max));
                const std::size_t at = std::size_t(j) * kTileStride + std::size_t(i);
                if (!(key > tile.key[at])) continue;
                tile.key[at] = key;
                if (with_triangles) tile.triangle[at] = t.triangle;
            }
        }
    }
}

}  // namespace plumb
