#include "score/regions.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/error.h"

namespace plumb {
namespace {

bool Breaks(const Image<float>& z, const Image<Vec3f>& normal, int i, int j, int di, int dj,
            const RegionOptions& options) {
    const auto inside = [&](int x, int y) {
        return 0 <= x && x < z.Width() && 0 <= y && y < z.Height();
    };
    const int back_i = i - di, back_j = j - dj, next_i = i + di, next_j = j + dj;
    const bool has_back = inside(back_i, back_j), has_next = inside(next_i, next_j);
    if (has_back && !std::isfinite(z(back_i, back_j))) return true;
    if (has_next && !std::isfinite(z(next_i, next_j))) return true;
    if (has_back && has_next) {
        const double bend = 1.0 / z(back_i, back_j) - 2.0 / z(i, j) + 1.0 / z(next_i, next_j);
        if (std::abs(bend * z(i, j)) > options.depth_jump) return true;
    }
    if (normal.Empty()) return false;
    const double least = std::cos(options.normal_turn_rad);
    const auto turns = [&](int x, int y) {
        return double(normal(i, j).dot(normal(x, y))) < least;
    };
    return (has_back && turns(back_i, back_j)) || (has_next && turns(next_i, next_j));
}

/// What lies within `reach` of a pixel that counts, by rows, then by columns.
Mask Grown(const Mask& mask, int reach) {
    const auto along_rows = [&](const Mask& in) {
        Mask out(in.Width(), in.Height(), 0);
        for (int j = 0; j < in.Height(); ++j) {
            for (int i = 0; i < in.Width(); ++i) {
                if (in(i, j) == 0) continue;
                const int first = std::max(0, i - reach);
                const int last = std::min(in.Width() - 1, i + reach);
                for (int x = first; x <= last; ++x) out(x, j) = 1;
            }
        }
        return out;
    };
    const auto transposed = [](const Mask& in) {
        Mask out(in.Height(), in.Width(), 0);
        for (int j = 0; j < in.Height(); ++j)
            for (int i = 0; i < in.Width(); ++i) out(j, i) = in(i, j);
        return out;
    };
    return transposed(along_rows(transposed(along_rows(mask))));
}

}  // namespace

void Validate(const RegionOptions& options) {
    if (!(options.depth_jump > 0))
        throw Error(MustBe("RegionOptions::depth_jump", options.depth_jump, "> 0"));
    if (!(options.normal_turn_rad > 0 && options.normal_turn_rad <= std::numbers::pi))
        throw Error(
            MustBe("RegionOptions::normal_turn_rad", options.normal_turn_rad, "in (0, pi]"));
    if (options.reach_px < 0 || options.reach_px > 256)
        throw Error(MustBe("RegionOptions::reach_px", options.reach_px, "in [0, 256]"));
    if (options.border_px < 0 || options.border_px > 65536)
        throw Error(MustBe("RegionOptions::border_px", options.border_px, "in [0, 65536]"));
}

Regions FindRegions(const Image<float>& z, const Image<Vec3f>& normal,
                    const RegionOptions& options) {
    Validate(options);
    const int width = z.Width(), height = z.Height();
    if (!normal.Empty() && (normal.Width() != width || normal.Height() != height))
        throw Error(MustBe("normals: pixels", double(normal.Pixels().size()), "those of z"));
    Regions regions;
    regions.seen = regions.edges = regions.interiors = regions.border = regions.centre =
        Mask(width, height, 0);

    Mask breaks(width, height, 0);
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
            if (!std::isfinite(z(i, j))) continue;
            regions.seen(i, j) = 1;
            breaks(i, j) = Breaks(z, normal, i, j, 1, 0, options) ||
                           Breaks(z, normal, i, j, 0, 1, options);
        }
    }
    const Mask near_breaks = Grown(breaks, options.reach_px);
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
            if (regions.seen(i, j) == 0) continue;
            const int to_frame = std::min({i, j, width - 1 - i, height - 1 - j});
            (near_breaks(i, j) ? regions.edges : regions.interiors)(i, j) = 1;
            (to_frame < options.border_px ? regions.border : regions.centre)(i, j) = 1;
        }
    }
    return regions;
}

Mask Both(const Mask& a, const Mask& b) {
    if (a.Empty()) return b;
    if (b.Empty()) return a;
    assert(a.Width() == b.Width() && a.Height() == b.Height());
    Mask both = a;
    for (std::size_t k = 0; k < both.Pixels().size(); ++k) {
        both.Pixels()[k] = a.Pixels()[k] != 0 && b.Pixels()[k] != 0;
    }
    return both;
}

std::int64_t CountOf(const Mask& mask) {
    return std::count_if(mask.Pixels().begin(), mask.Pixels().end(),
                         [](std::uint8_t pixel) { return pixel != 0; });
}

}  // namespace plumb
