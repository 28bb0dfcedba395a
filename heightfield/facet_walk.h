// The walk of a vertical plane across the facets: every crossing of an edge, in order, exactly.
//
// In units of the spacing, u = x / s_x and v = y / s_y, the edges of a field with rising
// diagonals are the three families of parallel lines
//
//       u = integer,     v = integer,     u - v = integer,
//
// so a straight horizontal line crosses from facet to facet by comparing two of three
// distances, with no step length: nothing can be stepped through. At a crossing at horizontal
// distance t the surface stands at a height z interpolated along the edge; between two
// crossings it is straight. A line of sight of slope m from height z_0 therefore meets the
// surface in the first facet that it leaves with z >= z_0 + m t, and the slope (z - z_0) / t of
// the surface as seen from the start is monotone within a facet.
//
// Blocks of B, B^2, ... cells know their highest height. A block that lies wholly below the
// line of sight is crossed in one step; that is exact too, not a bound on quality.
//
// Symbols  t horizontal distance (m), z height (m), m slope of a line of sight (unitless).
// Beware   Facets are chosen by topology (which edges can a line leave a facet through), not by
//          rounding coordinates: a line through a vertex may visit a facet for a length of
//          zero, but never leaves the surface. A falling field is walked as its mirror image in
//          y; facet numbers are translated back.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/vec.h"
#include "heightfield/height_field.h"

namespace plumb {

/// A height field laid out for walking: corner heights without folding, and the block maxima.
/// Memory: 8 bytes a texel and about 0.6 more for the blocks.
class WalkGrid {
  public:
    explicit WalkGrid(const HeightField& field);

    /// Where a walk begins: on a facet (of HeightField's numbering), at x, y in metres from the
    /// corner of the tile's cell (0, 0) (texel (0, 0) is at x = y = 0 here), heading along
    /// (cos azimuth, sin azimuth).
    struct Start {
        std::int64_t facet;
        double x_m, y_m, z_m;
        double cos_azimuth, sin_azimuth;
    };

    /// Where a walk leaves a facet.
    struct Crossing {
        std::int64_t facet;  ///< The facet just crossed.
        double t_m;          ///< Distance from the start.
        double rise_m;       ///< The surface's height above the start.
        double grade;        ///< Slope of that facet's plane in the walk's vertical plane.
    };

    /// How a walk ended.
    enum class End {
        kStopped,  ///< The visitor said so.
        kSky,      ///< Nothing ahead can reach the line of sight.
        kBorder,   ///< The line left an open field.
        kTooFar,   ///< max_distance_m was reached.
    };

    /// Walks from `start` along a line of sight whose slope is `slope` to begin with. At each
    /// crossing with an edge after the starting facet, and before the walk goes on, calls
    ///
    ///     bool visit(const Crossing& crossing, double& slope)
    ///
    /// which may raise the slope (a new horizon) and returns false to stop. Crossings in blocks
    /// below the line of sight are left out: there rise < slope * t. Ends once all that the
    /// surface can still rise above the line of sight is thinner than `tolerance_rad`, seen from
    /// the start: 0 for a ray, which must know. A slope's angle changes by 1 / (1 + m^2), which on
    /// the way up from below the horizontal is 1 at most.
    template <class Visitor>
    End Walk(const Start& start, double slope, double max_distance_m, double tolerance_rad,
             Visitor&& visit) const;

    double HighestM() const { return highest_m_; }

  private:
    static constexpr int kBlockBits = 2;  ///< A block of level l is (4^(l+1))^2 cells.

    struct Level {
        int bits = 0;     ///< log2 of the cells along a block's side.
        int columns = 0;  ///< Blocks along x.
        std::vector<double> highest_m;
    };

    double Corner(int i, int j) const {
        return corners_m_[std::size_t(j) * (cells_x_ + 1) + i];
    }
    std::int64_t FacetNumber(int i, int j, int upper) const {
        return falling_ ? 2 * (std::int64_t(cells_y_ - 1 - j) * cells_x_ + i) + (1 - upper)
                        : 2 * (std::int64_t(j) * cells_x_ + i) + upper;
    }

    int cells_x_, cells_y_;
    double spacing_x_m_, spacing_y_m_;
    Boundary boundary_;
    bool falling_;
    double highest_m_;
    std::vector<double> corners_m_;
    std::vector<Level> levels_;
};

template <class Visitor>
WalkGrid::End WalkGrid::Walk(const Start& start, double slope, double max_distance_m,
                             double tolerance_rad, Visitor&& visit) const {
    constexpr double kInf = std::numeric_limits<double>::infinity();
    const std::int64_t cell = start.facet / 2;
    int i = int(cell % cells_x_), j = int(cell / cells_x_), upper = int(start.facet % 2);
    double u0 = start.x_m / spacing_x_m_, v0 = start.y_m / spacing_y_m_;
    double du = start.cos_azimuth / spacing_x_m_, dv = start.sin_azimuth / spacing_y_m_;
    if (falling_) {
        j = cells_y_ - 1 - j;
        v0 = cells_y_ - v0;
        dv = -dv;
        upper = 1 - upper;
    }
    double per_u = 1 / du, per_v = 1 / dv, per_w = 1 / (du - dv);
    double t = 0;
    bool first = true;  // The starting facet lies in its own plane: it hides nothing.
    const double headroom_m = highest_m_ - start.z_m;
    const auto slack = [tolerance_rad](double m) {
        if (tolerance_rad == 0) return 0.0;  // Not 0 times the square of an upright slope.
        const double above = std::max(m, 0.0);
        return tolerance_rad * (1 + above * above);
    };
    const int top = int(levels_.size()) - 1;
    int level = 0;  // Goes up after a success, down after a failure.

    while (true) {
        // 1. Skip blocks that lie below the line of sight.
        while (!first && level >= 0) {
            const Level& blocks = levels_[level];
            const int bi = i >> blocks.bits, bj = j >> blocks.bits;
            const double rise =
                blocks.highest_m[std::size_t(bj) * blocks.columns + bi] - start.z_m;
            const int i0 = bi << blocks.bits, i1 = std::min(i0 + (1 << blocks.bits), cells_x_);
            const int j0 = bj << blocks.bits, j1 = std::min(j0 + (1 << blocks.bits), cells_y_);
            const double t_u = du == 0 ? kInf : ((du > 0 ? i1 : i0) - u0) * per_u;
            const double t_v = dv == 0 ? kInf : ((dv > 0 ? j1 : j0) - v0) * per_v;
            const double t_out = std::max(t, std::min(t_u, t_v));
            if (rise > slope * (slope >= 0 ? t : t_out)) {
                --level;
                continue;
            }
            t = t_out;
            const int i_before = i, j_before = j;
            if (t_u <= t_v) {
                i = du > 0 ? i1 : i0 - 1;
                j = std::clamp(int(std::floor(v0 + t * dv)), j0, j1 - 1);
                upper = du > 0 ? 1 : 0;
            } else {
                j = dv > 0 ? j1 : j0 - 1;
                i = std::clamp(int(std::floor(u0 + t * du)), i0, i1 - 1);
                upper = dv > 0 ? 0 : 1;
            }
            if (unsigned(i) >= unsigned(cells_x_) || unsigned(j) >= unsigned(cells_y_)) break;
            if (headroom_m <= (slope + slack(slope)) * t) return End::kSky;
            // A larger block is worth a try only where one begins.
            if (level < top && (((i ^ i_before) | (j ^ j_before)) >> levels_[level + 1].bits)) {
                ++level;
            }
        }

        // 2. Cross the facets of a block that may hold something.
        if (unsigned(i) < unsigned(cells_x_) && unsigned(j) < unsigned(cells_y_)) {
            const int block_i = i >> kBlockBits, block_j = j >> kBlockBits;
            do {
                double t_edge = kInf;
                int edge = -1;
                if (upper) {
                    // 0 left, 1 top, 2 diagonal.
                    if (du < 0) t_edge = (i - u0) * per_u, edge = 0;
                    if (dv > 0) {
                        const double t_v = (j + 1 - v0) * per_v;
                        if (t_v < t_edge) t_edge = t_v, edge = 1;
                    }
                    if (du - dv > 0) {
                        const double t_w = (i - j - (u0 - v0)) * per_w;
                        if (t_w < t_edge) t_edge = t_w, edge = 2;
                    }
                } else {
                    // 3 right, 4 bottom, 5 diagonal.
                    if (du > 0) t_edge = (i + 1 - u0) * per_u, edge = 3;
                    if (dv < 0) {
                        const double t_v = (j - v0) * per_v;
                        if (t_v < t_edge) t_edge = t_v, edge = 4;
                    }
                    if (du - dv < 0) {
                        const double t_w = (i - j - (u0 - v0)) * per_w;
                        if (t_w < t_edge) t_edge = t_w, edge = 5;
                    }
                }
                t = std::max(t, t_edge);
                const double* row = &corners_m_[std::size_t(j) * (cells_x_ + 1) + i];
                const double* next = row + cells_x_ + 1;
                double z_a, z_b, f;
                int next_i = i, next_j = j;
                switch (edge) {
                    case 0:
                        z_a = row[0], z_b = next[0], f = v0 + t * dv - j, next_i = i - 1;
                        break;
                    case 1:
                        z_a = next[0], z_b = next[1], f = u0 + t * du - i, next_j = j + 1;
                        break;
                    case 3:
                        z_a = row[1], z_b = next[1], f = v0 + t * dv - j, next_i = i + 1;
                        break;
                    case 4:
                        z_a = row[0], z_b = row[1], f = u0 + t * du - i, next_j = j - 1;
                        break;
                    default:
                        z_a = row[0], z_b = next[1], f = u0 + t * du - i;
                        break;
                }
                f = std::clamp(f, 0.0, 1.0);
                const double rise = z_a + f * (z_b - z_a) - start.z_m;
                // The two legs of the facet along the grid.
                const double along_u = upper ? next[1] - next[0] : row[1] - row[0];
                const double along_v = upper ? next[0] - row[0] : next[1] - row[1];
                const Crossing crossing{FacetNumber(i, j, upper), t, rise,
                                        along_u * du + along_v * dv};
                if (!first && !visit(crossing, slope)) return End::kStopped;
                first = false;
                upper ^= 1;
                i = next_i, j = next_j;
            } while ((i >> kBlockBits) == block_i && (j >> kBlockBits) == block_j &&
                     i < cells_x_ && j < cells_y_);
            level = 0;
        }

        // 3. Beyond the border: fold the walk back into the tile.
        if (i < 0 || i >= cells_x_ || j < 0 || j >= cells_y_) {
            if (boundary_ == Boundary::kOpen) return End::kBorder;
            if (boundary_ == Boundary::kWrap) {
                if (i < 0) i += cells_x_, u0 += cells_x_;
                if (i >= cells_x_) i -= cells_x_, u0 -= cells_x_;
                if (j < 0) j += cells_y_, v0 += cells_y_;
                if (j >= cells_y_) j -= cells_y_, v0 -= cells_y_;
            } else {
                // Reflected at the border row of texels, the line re-enters the facet it left.
                if (i < 0 || i >= cells_x_) {
                    u0 = (i < 0 ? 0 : 2 * cells_x_) - u0, du = -du, per_u = -per_u;
                    i = i < 0 ? 0 : cells_x_ - 1;
                    upper ^= 1;
                }
                if (j < 0 || j >= cells_y_) {
                    v0 = (j < 0 ? 0 : 2 * cells_y_) - v0, dv = -dv, per_v = -per_v;
                    j = j < 0 ? 0 : cells_y_ - 1;
                    upper ^= 1;
                }
                per_w = 1 / (du - dv);
            }
        }
        if (headroom_m <= (slope + slack(slope)) * t) return End::kSky;
        if (t > max_distance_m) return End::kTooFar;
    }
}

}  // namespace plumb
