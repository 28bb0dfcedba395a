#include "screen_space/raster/draw_in_tile.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "screen_space/raster/draw_in_tile.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace plumb::HWY_NAMESPACE {
namespace {

#include "screen_space/simd/lanes.inc"

// The covered pixels [first, last] of each row of the tile.
struct Spans {
    alignas(64) std::array<std::int32_t, kTileStride> first, last;
};

// Row by row F - dy i >= 0 bounds i by F / dy. Float finds the nearest whole number, and F there,
// exact, tells on which side of it the bound is.
void FindSpans(const TileTriangle& t, Spans& spans) {
    const Ints di;
    const Floats df;
    const auto zero = hn::Zero(di), one = hn::Set(di, 1);
    for (int j = t.j_0; j <= t.j_1; j += int(hn::Lanes(di))) {
        const auto row = hn::Iota(di, j);
        auto first = hn::Set(di, t.i_0), last = hn::Set(di, t.i_1);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto edge = hn::Add(hn::Set(di, t.F[k]), hn::Mul(hn::Set(di, t.dx[k]), row));
            if (t.dy[k] == 0) {
                last = hn::IfThenElse(hn::Lt(edge, zero), hn::Set(di, -1), last);
                continue;
            }
            const auto quotient =
                hn::Mul(hn::ConvertTo(df, edge), hn::Set(df, 1 / float(t.dy[k])));
            const auto inside =
                hn::Min(hn::Max(quotient, hn::Set(df, -1.f)), hn::Set(df, float(kTilePx + 1)));
            const auto i = hn::ConvertTo(di, hn::Add(inside, hn::Set(df, 0.5f)));
            const auto edge_i = hn::Sub(edge, hn::Mul(hn::Set(di, t.dy[k]), i));
            const auto off = hn::IfThenElseZero(hn::Lt(edge_i, zero), one);
            if (t.dy[k] > 0) {
                last = hn::Min(last, hn::Sub(i, off));
            } else {
                first = hn::Max(first, hn::Add(i, off));
            }
        }
        hn::StoreU(first, di, spans.first.data() + j - t.j_0);
        hn::StoreU(last, di, spans.last.data() + j - t.j_0);
    }
}

template <DepthFormat kFormat, class V>
V Key(V e) {
    const Floats d;
    if constexpr (kFormat == DepthFormat::kD16) {
        return hn::Round(hn::Mul(e, hn::Set(d, 65535.f)));
    } else if constexpr (kFormat == DepthFormat::kD24) {
        return hn::Round(hn::Mul(e, hn::Set(d, 16777215.f)));
    } else if constexpr (kFormat == DepthFormat::kD32F) {
        return hn::Sub(e, hn::Set(d, 1.f));
    } else {
        return e;
    }
}

// What is the same for all pixels of a triangle, and the depth test of as many as there are lanes.
template <DepthFormat kFormat, bool kWithTriangles>
class Pixels {
  public:
    Pixels(const TileTriangle& t, Tile& tile)
        : e_x_(hn::Set(Floats(), t.e_x)),
          e_min_(hn::Set(Floats(), t.e_min)),
          e_max_(hn::Set(Floats(), t.e_max)),
          number_(hn::Set(Bits(), t.triangle)),
          lane_(hn::Iota(Floats(), 0.f)),
          tile_(tile) {}

    /// From (i, j) on, where `covered`. e_row is e of the row's first pixel.
    template <class Mask>
    HWY_INLINE void Draw(int i, int j, float e_row, Mask covered) const {
        const Floats d;
        const Bits du;
        const auto x = hn::Add(lane_, hn::Set(d, float(i)));
        const auto e = hn::Add(hn::Set(d, e_row), hn::Mul(e_x_, x));
        const auto key = Key<kFormat>(hn::Min(hn::Max(e, e_min_), e_max_));
        float* const at = tile_.key.data() + j * kTileStride + i;
        const auto old = hn::LoadU(d, at);
        const auto drawn = hn::And(covered, hn::Gt(key, old));
        hn::StoreU(hn::IfThenElse(drawn, key, old), d, at);
        if constexpr (kWithTriangles) {
            std::uint32_t* const seen = tile_.triangle.data() + j * kTileStride + i;
            hn::StoreU(hn::IfThenElse(hn::RebindMask(du, drawn), number_, hn::LoadU(du, seen)),
                       du, seen);
        }
    }

  private:
    hn::Vec<Floats> e_x_, e_min_, e_max_;
    hn::Vec<Bits> number_;
    hn::Vec<Floats> lane_;
    Tile& tile_;
};

// A triangle no wider than a vector: one vector a row, which asks the edges themselves. Lanes
// beyond the triangle's last column are outside an edge, or in the padding.
template <DepthFormat kFormat, bool kWithTriangles>
HWY_INLINE void DrawNarrow(const TileTriangle& t, Tile& tile) {
    const Ints di;
    const Pixels<kFormat, kWithTriangles> pixels(t, tile);
    const auto column = hn::Iota(di, t.i_0);
    const auto edge = [&](std::size_t k) {
        return hn::Sub(hn::Set(di, t.F[k] + t.dx[k] * t.j_0),
                       hn::Mul(hn::Set(di, t.dy[k]), column));
    };
    auto F_0 = edge(0), F_1 = edge(1), F_2 = edge(2);
    const auto dx_0 = hn::Set(di, t.dx[0]), dx_1 = hn::Set(di, t.dx[1]),
               dx_2 = hn::Set(di, t.dx[2]);
    for (int j = t.j_0; j <= t.j_1; ++j) {
        const auto inside = hn::Gt(hn::Or(F_0, hn::Or(F_1, F_2)), hn::Set(di, -1));
        pixels.Draw(t.i_0, j, t.e + t.e_y * float(j), hn::RebindMask(Floats(), inside));
        F_0 = hn::Add(F_0, dx_0);
        F_1 = hn::Add(F_1, dx_1);
        F_2 = hn::Add(F_2, dx_2);
    }
}

template <DepthFormat kFormat, bool kWithTriangles>
HWY_INLINE void DrawWide(const TileTriangle& t, Spans& spans, Tile& tile) {
    const Floats d;
    const int lanes = int(hn::Lanes(d));
    const Pixels<kFormat, kWithTriangles> pixels(t, tile);
    FindSpans(t, spans);
    for (int j = t.j_0; j <= t.j_1; ++j) {
        const int last = spans.last[std::size_t(j - t.j_0)];
        const float e_row = t.e + t.e_y * float(j);
        for (int i = spans.first[std::size_t(j - t.j_0)]; i <= last; i += lanes) {
            pixels.Draw(i, j, e_row, hn::FirstN(d, std::size_t(last - i + 1)));
        }
    }
}

template <DepthFormat kFormat, bool kWithTriangles>
void Draw(std::span<const TileTriangle> triangles, Tile& tile) {
    Spans spans;
    for (const TileTriangle& t : triangles) {
        if (t.i_0 > t.i_1) continue;
        if (t.i_1 - t.i_0 < int(hn::Lanes(Floats()))) {
            DrawNarrow<kFormat, kWithTriangles>(t, tile);
        } else {
            DrawWide<kFormat, kWithTriangles>(t, spans, tile);
        }
    }
}

template <DepthFormat kFormat>
void DrawEither(std::span<const TileTriangle> triangles, bool with_triangles, Tile& tile) {
    if (with_triangles) {
        Draw<kFormat, true>(triangles, tile);
    } else {
        Draw<kFormat, false>(triangles, tile);
    }
}

void DrawFormat(std::span<const TileTriangle> triangles, DepthFormat format,
                bool with_triangles, Tile& tile) {
    switch (format) {
        case DepthFormat::kD16:
            return DrawEither<DepthFormat::kD16>(triangles, with_triangles, tile);
        case DepthFormat::kD24:
            return DrawEither<DepthFormat::kD24>(triangles, with_triangles, tile);
        case DepthFormat::kD32F:
            return DrawEither<DepthFormat::kD32F>(triangles, with_triangles, tile);
        case DepthFormat::kD32FReversed:
            return DrawEither<DepthFormat::kD32FReversed>(triangles, with_triangles, tile);
    }
}

float FindLeastKey(const Tile& tile) {
    const Floats d;
    auto least = hn::Set(d, std::numeric_limits<float>::infinity());
    for (std::size_t j = 0; j < kTilePx; ++j) {
        for (std::size_t i = 0; i < kTilePx; i += hn::Lanes(d)) {
            least = hn::Min(least, hn::LoadU(d, tile.key.data() + j * kTileStride + i));
        }
    }
    return hn::GetLane(hn::MinOfLanes(d, least));
}

}  // namespace
}  // namespace plumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace plumb {
namespace {

HWY_EXPORT(DrawFormat);
HWY_EXPORT(FindLeastKey);

}  // namespace

void DrawInTile(std::span<const TileTriangle> triangles, DepthFormat format,
                bool with_triangles, Tile& tile) {
    HWY_DYNAMIC_DISPATCH(DrawFormat)(triangles, format, with_triangles, tile);
}

float LeastKey(const Tile& tile) {
    return HWY_DYNAMIC_DISPATCH(FindLeastKey)(tile);
}

}  // namespace plumb

#endif
