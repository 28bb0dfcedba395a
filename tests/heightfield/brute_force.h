// An independent intersector for height fields: all triangles of the unfolded field one by one, in
// long double, no walk, no blocks, no tiles folded; and rays that try it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/conventions.h"
#include "core/random.h"
#include "heightfield/facet.h"
#include "heightfield/ray_cast.h"
#include "tests/closed_forms/analytic_fields.h"

namespace plumb {

using Real = long double;
using RealVec = Eigen::Matrix<Real, 3, 1>;

// A ray that passes an edge nearer than this may fall on either side of it.
inline constexpr Real kEdge = 1e-9L;

struct Ray {
    std::int64_t facet;
    Vec3 origin_m, direction;
};

inline int Floor(int i, int n) {
    return i >= 0 ? i / n : -((n - 1 - i) / n);
}

// The unfolded field, triangle by triangle.
class BruteForce {
  public:
    explicit BruteForce(const HeightField& field) : f_(field) {}

    struct Answer {
        std::int64_t facet = kSky;
        bool near_edge = false;    // An edge within kEdge could have changed the answer.
        bool from_above = true;    // What was met was met from above.
        Real distance = INFINITY;  // In units of the direction.
    };

    // The first of all triangles whose cells lie within `reach_m` of the start.
    Answer Cast(const Ray& ray, double reach_m) const {
        const RealVec o = ray.origin_m.cast<Real>(), d = ray.direction.cast<Real>();
        Answer sure;
        Real unsure = INFINITY;
        const auto meet = [&](int i, int j) {
            for (int half = 0; half < 2; ++half) {
                const auto [corners, number, home] = TriangleAt(i, j, half);
                if (home && number == ray.facet) continue;
                const auto [met, near_edge, t, above] = Meet(corners, o, d);
                if (!met && !near_edge) continue;
                if (near_edge) {
                    unsure = std::min(unsure, t);
                } else if (t < sure.distance) {
                    sure.distance = t, sure.facet = number, sure.from_above = above;
                }
            }
        };
        ForEachCell(o, d, reach_m, meet);
        sure.near_edge = std::isfinite(unsure) && unsure <= sure.distance;
        return sure;
    }

  private:
    struct Placed {
        std::array<RealVec, 3> corners;
        std::int64_t number;
        bool home;  // In the middle tile, where rays start.
    };

    RealVec Corner(int i, int j) const {
        return {Real(i) * f_.SpacingXM(), Real(j) * f_.SpacingYM(),
                Real(f_.At(Texel(i, f_.Width()), Texel(j, f_.Height())))};
    }
    int Texel(int i, int n) const {
        if (f_.GetBoundary() == Boundary::kWrap) return i - n * Floor(i, n);
        const int tile = Floor(i, n - 1), k = i - tile * (n - 1);
        return tile % 2 == 0 ? k : n - 1 - k;
    }

    // Half 0 touches the bottom edge of the cell, half 1 the top edge.
    Placed TriangleAt(int i, int j, int half) const {
        const int cells_x = f_.CellsX(), cells_y = f_.CellsY();
        const int tile_i = Floor(i, cells_x), tile_j = Floor(j, cells_y);
        int ci = i - tile_i * cells_x, cj = j - tile_j * cells_y;
        const bool mirrors = f_.GetBoundary() == Boundary::kMirror;
        const bool flip_x = mirrors && tile_i % 2 != 0, flip_y = mirrors && tile_j % 2 != 0;
        if (flip_x) ci = cells_x - 1 - ci;
        if (flip_y) cj = cells_y - 1 - cj;
        const bool rising = (f_.GetDiagonal() == Diagonal::kRising) != (flip_x != flip_y);
        const RealVec a = Corner(i, j), b = Corner(i + 1, j);
        const RealVec c = Corner(i + 1, j + 1), d = Corner(i, j + 1);
        Placed out;
        if (half == 0) {
            out.corners = {a, b, rising ? c : d};
        } else {
            out.corners = {rising ? a : b, c, d};
        }
        // Mirrored in y, the half at the bottom is the one at the top of the original.
        out.number = 2 * (std::int64_t(cj) * cells_x + ci) + (flip_y ? 1 - half : half);
        out.home = tile_i == 0 && tile_j == 0;
        return out;
    }

    struct Met {
        bool met, near_edge;
        Real t;
        bool from_above;
    };

    // On which side of each edge the line passes, by the sign of a volume; how near, by the
    // distance of two lines (of a line and a point where they are parallel).
    static Met Meet(const std::array<RealVec, 3>& p, const RealVec& o, const RealVec& d) {
        const RealVec normal = (p[1] - p[0]).cross(p[2] - p[0]);
        const Real t = (p[0] - o).dot(normal) / d.dot(normal);
        Met out{true, false, t, d.dot(normal) < 0};
        bool near = false;
        int left = 0, right = 0;
        for (int k = 0; k < 3; ++k) {
            const RealVec a = p[k] - o, e = p[(k + 1) % 3] - p[k];
            const RealVec common = d.cross(e);
            const Real volume = common.dot(a), apart = common.norm();
            const bool parallel = apart < 1e-12L * d.norm() * e.norm();
            const Real distance =
                parallel ? a.cross(d).norm() / d.norm() : std::abs(volume) / apart;
            if (distance < kEdge) {
                near = true;
            } else {
                ++(volume > 0 ? left : right);
            }
        }
        out.met = !near && (left == 0 || right == 0) && t > 0;
        out.near_edge = near && (left == 0 || right == 0) && !(t < -kEdge);
        return out;
    }

    // Cells over which the ray may pass, with one more on every side; all of an open field.
    template <class Visit>
    void ForEachCell(const RealVec& o, const RealVec& d, double reach_m, Visit visit) const {
        if (f_.GetBoundary() == Boundary::kOpen) {
            for (int j = 0; j < f_.CellsY(); ++j)
                for (int i = 0; i < f_.CellsX(); ++i) visit(i, j);
            return;
        }
        const Real level = std::hypot(d.x(), d.y()), T = reach_m / level;
        const Real v_0 = o.y() / f_.SpacingYM(), v_1 = (o.y() + T * d.y()) / f_.SpacingYM();
        const int first = int(std::floor(std::min(v_0, v_1))) - 1;
        const int last = int(std::floor(std::max(v_0, v_1))) + 1;
        for (int j = first; j <= last; ++j) {
            Real t_0 = 0, t_1 = T;
            if (v_0 != v_1) {
                const Real per_v = T / (v_1 - v_0);
                const Real low = (j - 1 - v_0) * per_v, high = (j + 2 - v_0) * per_v;
                t_0 = std::clamp<Real>(std::min(low, high), 0, T);
                t_1 = std::clamp<Real>(std::max(low, high), 0, T);
            }
            const Real u_0 = (o.x() + t_0 * d.x()) / f_.SpacingXM();
            const Real u_1 = (o.x() + t_1 * d.x()) / f_.SpacingXM();
            const int left = int(std::floor(std::min(u_0, u_1))) - 1;
            const int right = int(std::floor(std::max(u_0, u_1))) + 1;
            for (int i = left; i <= right; ++i) visit(i, j);
        }
    }

    const HeightField& f_;
};

inline HeightField Rough(int width, int height, double amplitude_m, double s_x, double s_y,
                         Boundary boundary, Diagonal diagonal, std::uint64_t seed) {
    Image<double> heights(width, height);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i)
            heights(i, j) = amplitude_m * RandomUnit(seed, std::uint64_t(j * width + i), 0, 0);
    return HeightField(std::move(heights), s_x, s_y, boundary, diagonal);
}

// From texel (0, 0), as CastFromFacet has it.
inline Vec3 PointOn(const HeightField& field, std::int64_t facet, double b_0, double b_1) {
    const Facet f = FacetOf(field, facet);
    const Vec3 corner(0.5 * field.SpacingXM(), 0.5 * field.SpacingYM(), 0);
    return b_0 * f.corners_m[0] + b_1 * f.corners_m[1] + (1 - b_0 - b_1) * f.corners_m[2] -
           corner;
}

// Ray k of a test: a random point of a random facet and a direction above it; every fourth
// along a grid line, every fourth along or across the diagonal, every eighth nearly upright.
inline Ray RandomRay(const HeightField& field, std::uint64_t seed, std::uint64_t k) {
    const auto u = [&](int dimension) {
        return RandomUnit(seed, k, 1, std::uint64_t(dimension));
    };
    Ray ray;
    ray.facet = std::int64_t(u(0) * double(field.Facets()));
    double b_0 = u(1), b_1 = u(2);
    if (b_0 + b_1 > 1) b_0 = 1 - b_0, b_1 = 1 - b_1;
    ray.origin_m = PointOn(field, ray.facet, b_0, b_1);
    const double s_x = field.SpacingXM(), s_y = field.SpacingYM();
    Vec3 d(std::cos(2 * kPi * u(3)), std::sin(2 * kPi * u(3)), 0);
    const int sign = u(4) < 0.5 ? 1 : -1, other = u(5) < 0.5 ? 1 : -1;
    if (k % 4 == 1) d = u(6) < 0.5 ? Vec3(sign, 0, 0) : Vec3(0, sign, 0);
    if (k % 4 == 2) d = Vec3(sign * s_x, other * s_y, 0);
    const Vec3 n = FacetOf(field, ray.facet).normal;
    // Above the facet's own plane by a slope from 1e-4 to 1e2, or nearly upright.
    const double level = std::hypot(d.x(), d.y()),
                 plane = -(n.x() * d.x() + n.y() * d.y()) / n.z();
    d.z() = plane + level * std::pow(10, -4 + 6 * u(7));
    if (k % 8 == 7) d.z() = level * std::pow(10, 2 + 10 * u(7));
    ray.direction = d;
    return ray;
}

struct Tally {
    int same = 0, near_edge = 0, out_of_reach = 0, sky = 0, below_horizon = 0;
};

// Casts `rays` rays both ways, one of them by `cast(ray)`. A ray whose answer the brute force
// cannot know within its reach (too level, no hit so far) is counted, not judged.
template <class CastOne>
Tally CompareWith(const HeightField& field, int rays, std::uint64_t seed, CastOne cast) {
    const BruteForce brute(field);
    const double relief = field.HighestM() - field.LowestM();
    const double most_m = 20 * (field.WidthM() + field.HeightM());
    Tally tally;
    for (int k = 0; k < rays; ++k) {
        const Ray ray = RandomRay(field, seed, std::uint64_t(k));
        const double slope =
            ray.direction.z() / std::hypot(ray.direction.x(), ray.direction.y());
        const double ends_m = slope == 0 ? INFINITY : relief / std::abs(slope);
        const auto expected = brute.Cast(ray, std::min(ends_m, most_m) + 1e-6);
        const bool known =
            expected.facet != kSky || ends_m < most_m || field.GetBoundary() == Boundary::kOpen;
        const std::int64_t found = cast(ray);
        if (expected.near_edge) {
            ++tally.near_edge;
        } else if (!known) {
            ++tally.out_of_reach;
        } else {
            EXPECT_EQ(found, expected.facet)
                << "ray " << k << " from facet " << ray.facet << " at "
                << ray.origin_m.transpose() << " along " << ray.direction.transpose();
            EXPECT_TRUE(expected.from_above) << "ray " << k;
            ++tally.same;
            tally.sky += found == kSky;
            tally.below_horizon += slope < 0;
        }
        if (::testing::Test::HasFailure()) break;
    }
    return tally;
}

inline Tally Compare(const HeightField& field, int rays, std::uint64_t seed) {
    const WalkGrid grid(field);
    return CompareWith(field, rays, seed, [&](const Ray& ray) {
        return CastFromFacet(grid, ray.facet, ray.origin_m, ray.direction, FarDistanceM(field));
    });
}

inline std::string Name(Boundary boundary, Diagonal diagonal, double amplitude) {
    const char* const names[] = {"wrap", "mirror", "open"};
    return std::string(names[int(boundary)]) + ", " +
           (diagonal == Diagonal::kRising ? "rising" : "falling") + ", amplitude " +
           std::to_string(amplitude);
}

}  // namespace plumb
