// The innermost loop: one triangle over the pixels of one tile.
//
//       covered:  F(i, j) = F + dx j - dy i >= 0 for the three edges        (screen_space/raster/edges.h)
//       e(i, j) = (e + e_y j) + e_x i, kept within [e_min, e_max]
//       drawn where its key is greater than the tile's                 (screen_space/raster/depth_format.h)
//
// All of it in 32 bits, the same bits with any instruction set: whole numbers, or float with
// every product and sum rounded by itself, from the tile's corner.
//
// e is off the exact plane's by at most 2^-24 (3 e + 320 (|e_x| + |e_y|)): C, both products and both
// sums round once each, of numbers up to e + 64 (|e_x| + |e_y|).
//
// Symbols  (i, j) a pixel from the tile's upper left.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "screen_space/raster/bins.h"
#include "screen_space/raster/depth_format.h"

namespace plumb {

/// Pixels from one row of a tile to the next: vectors may reach past its right side.
inline constexpr int kTileStride = kTilePx + 16;

/// Depth keys and triangles of one tile while it is drawn.
struct alignas(64) Tile {
    std::array<float, kTileStride * kTilePx> key;
    std::array<std::uint32_t, kTileStride * kTilePx> triangle;
};

/// A triangle as a tile sees it.
struct TileTriangle {
    std::int32_t i_0 = 0, i_1 = 0, j_0 = 0,
                 j_1 = 0;                         ///< Pixels that may be covered, all included.
    std::array<std::int32_t, 3> F{}, dx{}, dy{};  ///< All 0 where the tile is inside the edge.
    float e = 0, e_x = 0, e_y = 0, e_min = 0, e_max = 0;
    std::uint32_t triangle = 0;
};

/// What the tile at (column, row) sees of the triangle; i_0 > i_1 or j_0 > j_1 if nothing.
TileTriangle InTile(const ScreenTriangle& triangle, int column, int row);

/// Draws the triangles in order; their numbers only if `with_triangles`.
void DrawInTile(std::span<const TileTriangle> triangles, DepthFormat format,
                bool with_triangles, Tile& tile);

/// What the depth buffer holds for `pixels` of row j.
void StoreDepthRow(const Tile& tile, int j, int pixels, DepthFormat format, std::uint32_t* out);

/// The least key of the tile: what lies behind it everywhere need not be drawn.
float LeastKey(const Tile& tile);

}  // namespace plumb
