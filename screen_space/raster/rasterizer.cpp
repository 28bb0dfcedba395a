#include "screen_space/raster/rasterizer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/error.h"
#include "core/parallel.h"
#include "core/surface.h"
#include "screen_space/gbuffer.h"
#include "screen_space/raster/draw_in_tile.h"
#include "screen_space/raster/seen_triangle.h"

namespace plumb {
namespace {

constexpr std::int64_t kFacesAtATime = 8192;
constexpr std::size_t kTrianglesAtATime = 32;

void CheckIndices(const Mesh& mesh, std::int64_t face) {
    const std::size_t vertices = mesh.vertices_m.size();
    for (std::size_t k = 0; k < 4; ++k) {
        const std::uint32_t index = mesh.quads[std::size_t(face)][k];
        if (index >= vertices) {
            throw Error(
                MustBe("mesh: quads[" + std::to_string(face) + "][" + std::to_string(k) + "]",
                       index, "< " + std::to_string(vertices) + ", the vertices"));
        }
    }
}

// The same as DrawInTile for one triangle, asking at each pixel that passes the depth test.
template <class Solid>
void DrawWithHoles(const TileTriangle& t, DepthFormat format, bool with_triangles,
                   const Solid& solid, Tile& tile) {
    for (int j = t.j_0; j <= t.j_1; ++j) {
        for (int i = t.i_0; i <= t.i_1; ++i) {
            bool covered = true;
            for (std::size_t k = 0; k < 3; ++k) {
                covered &= t.F[k] + t.dx[k] * j - t.dy[k] * i >= 0;
            }
            if (!covered) continue;
            const float e = (t.e + t.e_y * float(j)) + t.e_x * float(i);
            const float key = KeyOf(format, std::min(std::max(e, t.e_min), t.e_max));
            const std::size_t at = std::size_t(j) * kTileStride + std::size_t(i);
            if (!(key > tile.key[at]) || !solid(i, j)) continue;
            tile.key[at] = key;
            if (with_triangles) tile.triangle[at] = t.triangle;
        }
    }
}

// Pixels of the tile beyond the picture are nearer than anything, so that they hide nothing.
void Clear(DepthFormat format, int width, int height, Tile& tile) {
    tile.key.fill(std::numeric_limits<float>::infinity());
    for (int j = 0; j < height; ++j) {
        std::fill_n(tile.key.data() + j * kTileStride, width, KeyOf(format, 0));
    }
    tile.triangle.fill(GBuffer::kSky);
}

template <class T>
void Resize(Image<T>& image, int width, int height) {
    if (image.Width() != width || image.Height() != height) image = Image<T>(width, height);
}

}  // namespace

const VisibilityBuffer& Rasterizer::Draw(const Mesh& mesh, const Camera& camera,
                                         const RasterOptions& options, bool with_triangles,
                                         const AlphaTest* alpha_test) {
    Validate(options);
    out_.view = ViewOf(camera, options.guard_px);
    out_.format = options.depth;
    out_.range = options.range;
    Resize(out_.depth, out_.view.DrawnWidth(), out_.view.DrawnHeight());
    if (with_triangles) {
        Resize(out_.triangle, out_.view.DrawnWidth(), out_.view.DrawnHeight());
    } else {
        out_.triangle = {};
    }
    TransformVertices(mesh, camera, out_.view, options, vertices_);
    SortIntoTiles(mesh, options, alpha_test);
    const TileGrid grid(out_.view);
    ParallelFor(grid.Tiles(), 1, [&](std::int64_t tile, std::int64_t) {
        DrawTile(mesh, int(tile) % grid.columns, int(tile) / grid.columns, with_triangles,
                 alpha_test);
    });
    return out_;
}

void Rasterizer::SortIntoTiles(const Mesh& mesh, const RasterOptions& options,
                               const AlphaTest* alpha_test) {
    const PictureFrame frame(out_.view, options.range);
    const std::int64_t faces = std::int64_t(mesh.quads.size());
    chunks_.resize(std::size_t((faces + kFacesAtATime - 1) / kFacesAtATime));
    ParallelFor(faces, kFacesAtATime, [&](std::int64_t begin, std::int64_t end) {
        Bins& bins = chunks_[std::size_t(begin / kFacesAtATime)];
        bins.Clear();
        for (std::int64_t f = begin; f < end; ++f) {
            CheckIndices(mesh, f);
            const std::uint32_t face = std::uint32_t(f);
            const bool tested = alpha_test != nullptr && alpha_test->tested(face);
            const auto& quad = mesh.quads[face];
            const int halves = quad[2] == quad[3] ? 1 : 2;
            for (int half = 0; half < halves; ++half) {
                const std::uint32_t triangle = 2 * face + std::uint32_t(half);
                const auto corners = CornersOf(mesh, triangle);
                bins.Add(
                    {&vertices_[corners[0]], &vertices_[corners[1]], &vertices_[corners[2]]},
                    triangle, tested, frame);
            }
        }
        bins.SortByTile(frame.grid);
    });
}

std::array<Vec3, 3> Rasterizer::CornersM(const Mesh& mesh, std::uint32_t triangle) const {
    const auto corners = CornersOf(mesh, triangle);
    return {vertices_[corners[0]].P, vertices_[corners[1]].P, vertices_[corners[2]].P};
}

void Rasterizer::DrawTile(const Mesh& mesh, int column, int row, bool with_triangles,
                          const AlphaTest* alpha_test) {
    const DepthFormat format = out_.format;
    const int tile_number = row * TileGrid(out_.view).columns + column;
    const int i_0 = column * kTilePx, j_0 = row * kTilePx;
    const int width = std::min(kTilePx, out_.view.DrawnWidth() - i_0);
    const int height = std::min(kTilePx, out_.view.DrawnHeight() - j_0);
    Tile tile;
    Clear(format, width, height, tile);
    std::vector<TileTriangle> ready;
    float least = KeyOf(format, 0);
    const auto draw_ready = [&] {
        DrawInTile(ready, format, with_triangles, tile);
        ready.clear();
        least = LeastKey(tile);
    };
    for (const Bins& bins : chunks_) {
        for (const std::uint32_t number : bins.OfTile(tile_number)) {
            const ScreenTriangle& triangle = bins[number];
            if (!(KeyOf(format, triangle.e_max) > least)) continue;
            const TileTriangle here = InTile(triangle, column, row);
            if (triangle.alpha_tested == 0) {
                ready.push_back(here);
                if (ready.size() == kTrianglesAtATime) draw_ready();
                continue;
            }
            draw_ready();
            const SeenTriangle seen(CornersM(mesh, triangle.triangle));
            DrawWithHoles(
                here, format, with_triangles,
                [&](int i, int j) {
                    const Vec3 b = seen.Weights(out_.view, i_0 + i + 0.5, j_0 + j + 0.5);
                    return alpha_test->solid(triangle.triangle, b[1], b[2]);
                },
                tile);
        }
    }
    draw_ready();
    for (int j = 0; j < height; ++j) {
        StoreDepthRow(tile, j, width, format, &out_.depth(i_0, j_0 + j));
        if (!with_triangles) continue;
        std::copy_n(tile.triangle.data() + j * kTileStride, width,
                    &out_.triangle(i_0, j_0 + j));
    }
}

}  // namespace plumb
