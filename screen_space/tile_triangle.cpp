#include <algorithm>

#include "screen_space/draw_in_tile.h"

namespace plumb {

TileTriangle InTile(const ScreenTriangle& triangle, int column, int row) {
    TileTriangle out;
    const int i = column * kTilePx, j = row * kTilePx;
    const auto& [a, b, c] = triangle.corners;
    const auto [x_min, x_max] = std::minmax({a.x, b.x, c.x});
    const auto [y_min, y_max] = std::minmax({a.y, b.y, c.y});
    constexpr int kLast = kTilePx - 1;
    out.i_0 = std::max(FirstPixel(x_min) - i, 0);
    out.i_1 = std::min(LastPixel(x_max) - i, kLast);
    out.j_0 = std::max(FirstPixel(y_min) - j, 0);
    out.j_1 = std::min(LastPixel(y_max) - j, kLast);
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

}  // namespace plumb
