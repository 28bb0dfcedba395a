// Triangles to depth and triangle number: what is seen at the centre of each pixel.
//
// Vertices are transformed, triangles sorted into tiles of 64 x 64 pixels in the order of the
// mesh, and each tile is drawn by one thread: the same bits on any number of threads. At equal
// depth the triangle that comes first in the mesh stays.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/camera.h"
#include "core/image.h"
#include "core/mesh.h"
#include "screen_space/raster/bins.h"
#include "screen_space/raster/raster_options.h"
#include "screen_space/raster/vertex_stage.h"
#include "screen_space/view.h"

namespace plumb {

/// What a depth pass leaves behind. Images are of the drawn size.
struct VisibilityBuffer {
    View view;
    DepthFormat format = DepthFormat::kD32FReversed;
    DepthRange range;
    Image<std::uint32_t> depth;     ///< As stored: see DecodeDepth.
    Image<std::uint32_t> triangle;  ///< 2 face + half; GBuffer::kSky for the sky.
};

/// Surfaces with holes.
struct AlphaTest {
    /// Of a face: might a pixel of it be no surface?
    std::function<bool(std::uint32_t face)> tested;
    /// Is there a surface at b_1, b_2 of the triangle?
    std::function<bool(std::uint32_t triangle, double b_1, double b_2)> solid;
};

/// Keeps its memory from one picture to the next.
class Rasterizer {
  public:
    /// Draws depth, and triangle numbers if `with_triangles`. Throws Error if options, camera or
    /// mesh are not valid. The result stays until the next call.
    const VisibilityBuffer& Draw(const Mesh& mesh, const Camera& camera,
                                 const RasterOptions& options, bool with_triangles = true,
                                 const AlphaTest* alpha_test = nullptr);

    /// The last picture's vertices.
    const std::vector<ScreenVertex>& Vertices() const { return vertices_; }

  private:
    void SortIntoTiles(const Mesh& mesh, const RasterOptions& options,
                       const AlphaTest* alpha_test);
    void DrawTile(const Mesh& mesh, int column, int row, bool with_triangles,
                  const AlphaTest* alpha_test);
    std::array<Vec3, 3> CornersM(const Mesh& mesh, std::uint32_t triangle) const;

    VisibilityBuffer out_;
    std::vector<ScreenVertex> vertices_;
    std::vector<Bins> chunks_;
};

}  // namespace plumb
