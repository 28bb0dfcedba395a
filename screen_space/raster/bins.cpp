#include "screen_space/raster/bins.h"

#include <algorithm>
#include <cmath>

#include "screen_space/raster/clip.h"

namespace plumb {
namespace {

// Beyond this a slope is edge-on to the last bit and means nothing; far below float's overflow.
constexpr double kSteepest = 1e25;

// e = a / t + b over the picture: 1 / t is linear there, n . w / (n . P) for the plane's normal n
// and the pixel's direction w.
void SetDepth(const std::array<Vec3, 3>& P, const PictureMap& map, const DepthCurve& curve,
              ScreenTriangle& out) {
    const Vec3 n = (P[1] - P[0]).cross(P[2] - P[0]);
    const double scale = curve.a / n.dot(P[0]);
    const double w_x = 1 / map.k_x, w_y = -1 / map.k_y;  // Of w, by one pixel.
    out.e_x = scale * n.x() * w_x;
    out.e_y = scale * n.y() * w_y;
    out.e_0 = scale * (-n.z() - n.x() * map.c_x * w_x - n.y() * map.c_y * w_y) + curve.b;
    // Written so that NaN counts as too steep.
    if (!(std::abs(out.e_x) < kSteepest && std::abs(out.e_y) < kSteepest &&
          std::abs(out.e_0) < kSteepest)) {
        out.e_x = out.e_y = 0;
        out.e_0 = 0.5 * (double(out.e_min) + double(out.e_max));
    }
}

}  // namespace

void Bins::Clear() {
    triangles_.clear();
    references_.clear();
    first_.clear();
    sorted_.clear();
}

void Bins::Add(const std::array<const ScreenVertex*, 3>& corners, std::uint32_t triangle,
               bool alpha_tested, const PictureFrame& frame) {
    const ScreenVertex &a = *corners[0], &b = *corners[1], &c = *corners[2];
    if ((a.outcode & b.outcode & c.outcode & ~outcode::kBeyondReach) != 0) return;
    const PictureMap& map = frame.map;
    const DepthCurve& curve = frame.curve;
    const std::array<Vec3, 3> P{a.P, b.P, c.P};
    ScreenTriangle out;
    out.triangle = triangle;
    out.alpha_tested = alpha_tested;
    const auto set_depth = [&](double t_min, double t_max) {
        out.e_min = float(curve.E(t_max));
        out.e_max = float(curve.E(t_min));
        SetDepth(P, map, curve, out);
    };
    if (((a.outcode | b.outcode | c.outcode) & outcode::kBeyondReach) == 0) {
        out.corners = {a.at, b.at, c.at};
        const std::int64_t area = TwiceArea(a.at, b.at, c.at);
        if (area == 0) return;
        if (area < 0) std::swap(out.corners[1], out.corners[2]);
        const auto [z_min, z_max] = std::minmax({a.P.z(), b.P.z(), c.P.z()});
        set_depth(-z_max, -z_min);
        AddOnScreen(out, frame);
        return;
    }
    const ClippedPolygon polygon = ClipTriangle(P, map, frame.near_m);
    if (polygon.size < 3) return;
    double t_min = -polygon.corners[0].z(), t_max = t_min;
    for (const Vec3& Q : polygon.Corners()) {
        t_min = std::min(t_min, -Q.z());
        t_max = std::max(t_max, -Q.z());
    }
    set_depth(t_min, t_max);
    const FixedPoint first = ToFixedWithinReach(map, polygon.corners[0]);
    for (int k = 1; k + 1 < polygon.size; ++k) {
        FixedPoint p = ToFixedWithinReach(map, polygon.corners[std::size_t(k)]);
        FixedPoint q = ToFixedWithinReach(map, polygon.corners[std::size_t(k + 1)]);
        const std::int64_t area = TwiceArea(first, p, q);
        if (area == 0) continue;
        if (area < 0) std::swap(p, q);
        out.corners = {first, p, q};
        AddOnScreen(out, frame);
    }
}

void Bins::AddOnScreen(const ScreenTriangle& triangle, const PictureFrame& frame) {
    const PictureMap& map = frame.map;
    const TileGrid& grid = frame.grid;
    const auto& [a, b, c] = triangle.corners;
    const auto [x_min, x_max] = std::minmax({a.x, b.x, c.x});
    const auto [y_min, y_max] = std::minmax({a.y, b.y, c.y});
    const int i_0 = std::max(FirstPixel(x_min), 0), j_0 = std::max(FirstPixel(y_min), 0);
    const int i_1 = std::min(LastPixel(x_max), map.width_px - 1);
    const int j_1 = std::min(LastPixel(y_max), map.height_px - 1);
    if (i_0 > i_1 || j_0 > j_1) return;
    const std::uint32_t number = std::uint32_t(triangles_.size());
    triangles_.push_back(triangle);
    const int column_0 = i_0 / kTilePx, column_1 = i_1 / kTilePx;
    const int row_0 = j_0 / kTilePx, row_1 = j_1 / kTilePx;
    if (column_0 == column_1 && row_0 == row_1) {
        references_.push_back({std::uint32_t(row_0 * grid.columns + column_0), number});
        return;
    }
    const TriangleEdges edges = EdgesOf(triangle.corners);
    constexpr int kSpan = kTilePx - 1;
    for (int row = row_0; row <= row_1; ++row) {
        for (int column = column_0; column <= column_1; ++column) {
            const bool outside = std::any_of(edges.begin(), edges.end(), [&](const Edge& e) {
                return e.Most(column * kTilePx, row * kTilePx, kSpan, kSpan) < 0;
            });
            if (outside) continue;
            references_.push_back({std::uint32_t(row * grid.columns + column), number});
        }
    }
}

void Bins::SortByTile(const TileGrid& grid) {
    first_.assign(std::size_t(grid.Tiles()) + 1, 0);
    for (const Reference& r : references_) ++first_[r.tile + 1];
    for (std::size_t tile = 1; tile < first_.size(); ++tile) first_[tile] += first_[tile - 1];
    sorted_.resize(references_.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (const Reference& r : references_) sorted_[next[r.tile]++] = r.triangle;
}

}  // namespace plumb
