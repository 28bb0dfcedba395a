// Triangles ready to be drawn, sorted by the tiles of the picture that they may touch.
//
// A mesh is cut into chunks of faces; each chunk has its own lists, so chunks are made by any
// number of threads, and a tile that takes them in order draws in the order of the mesh.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh.h"
#include "screen_space/raster/edges.h"
#include "screen_space/raster/raster_options.h"
#include "screen_space/raster/vertex_stage.h"

namespace plumb {

inline constexpr int kTilePx = 64;

/// What one tile needs to know of a triangle. One cache line.
struct alignas(64) ScreenTriangle {
    std::array<FixedPoint, 3> corners;  ///< Clockwise in the picture.
    std::uint32_t triangle = 0;         ///< 2 face + half.
    std::uint32_t alpha_tested = 0;
    double e_0 = 0, e_x = 0, e_y = 0;  ///< e = e_0 + e_x x_px + e_y y_px
    float e_min = 0, e_max = 0;        ///< Over the corners: rounding may not leave them.
};

struct TileGrid {
    int columns = 0, rows = 0;

    explicit TileGrid(const View& view)
        : columns((view.DrawnWidth() + kTilePx - 1) / kTilePx),
          rows((view.DrawnHeight() + kTilePx - 1) / kTilePx) {}
    int Tiles() const { return columns * rows; }
};

/// What all triangles of a picture share.
struct PictureFrame {
    PictureMap map;
    TileGrid grid;
    DepthCurve curve;
    double near_m;

    PictureFrame(const View& view, const DepthRange& range)
        : map(view), grid(view), curve(range), near_m(range.near_m) {}
};

/// The triangles of one chunk of faces.
class Bins {
  public:
    /// Starts again. Keeps its memory.
    void Clear();

    /// Adds what is visible of a triangle.
    void Add(const std::array<const ScreenVertex*, 3>& corners, std::uint32_t triangle,
             bool alpha_tested, const PictureFrame& frame);

    /// To be called after the last Add.
    void SortByTile(const TileGrid& grid);

    /// Numbers of the triangles of a tile, in the order in which they were added.
    std::span<const std::uint32_t> OfTile(int tile) const {
        return {sorted_.data() + first_[std::size_t(tile)],
                first_[std::size_t(tile) + 1] - first_[std::size_t(tile)]};
    }
    const ScreenTriangle& operator[](std::uint32_t number) const { return triangles_[number]; }
    std::size_t Size() const { return triangles_.size(); }

  private:
    void AddOnScreen(const ScreenTriangle& triangle, const PictureFrame& frame);

    struct Reference {
        std::uint32_t tile, triangle;
    };
    std::vector<ScreenTriangle> triangles_;
    std::vector<Reference> references_;
    std::vector<std::uint32_t> first_, sorted_;
};

}  // namespace plumb
