#include "screen_space/draw_in_tile.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "screen_space/draw_in_tile.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace plumb::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// As many lanes as the machine has, but not more than a tile's rows are padded for.
using Floats = hn::CappedTag<float, 16>;
using Ints = hn::RebindToSigned<Floats>;
using Numbers = hn::RebindToUnsigned<Floats>;

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
            const auto F = hn::Add(hn::Set(di, t.F[k]), hn::Mul(hn::Set(di, t.dx[k]), row));
            if (t.dy[k] == 0) {
                last = hn::IfThenElse(hn::Lt(F, zero), hn::Set(di, -1), last);
                continue;
            }
            const auto quotient =
                hn::Mul(hn::ConvertTo(df, F), hn::Set(df, 1 / float(t.dy[k])));
            const auto inside =
                hn::Min(hn::Max(quotient, hn::Set(df, -1.f)), hn::Set(df, float(kTilePx + 1)));
            const auto i = hn::ConvertTo(di, hn::Add(inside, hn::Set(df, 0.5f)));
            const auto F_i = hn::Sub(F, hn::Mul(hn::Set(di, t.dy[k]), i));
            const auto off = hn::IfThenElseZero(hn::Lt(F_i, zero), one);
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

template <DepthFormat kFormat, bool kWithTriangles>
void Draw(std::span<const TileTriangle> triangles, Tile& tile) {
    const Floats d;
    const Numbers du;
    const int lanes = int(hn::Lanes(d));
    const auto lane = hn::Iota(d, 0.f);
    Spans spans;
    for (const TileTriangle& t : triangles) {
        if (t.i_0 > t.i_1) continue;
        FindSpans(t, spans);
        const auto e_x = hn::Set(d, t.e_x);
        const auto e_min = hn::Set(d, t.e_min), e_max = hn::Set(d, t.e_max);
        const auto number = hn::Set(du, t.triangle);
        for (int j = t.j_0; j <= t.j_1; ++j) {
            const int last = spans.last[std::size_t(j - t.j_0)];
            const auto e_row = hn::Set(d, t.e + t.e_y * float(j));
            for (int i = spans.first[std::size_t(j - t.j_0)]; i <= last; i += lanes) {
                const auto x = hn::Add(lane, hn::Set(d, float(i)));
                const auto e = hn::Add(e_row, hn::Mul(e_x, x));
                const auto key = Key<kFormat>(hn::Min(hn::Max(e, e_min), e_max));
                const std::size_t at = std::size_t(j * kTileStride + i);
                const auto old = hn::LoadU(d, tile.key.data() + at);
                const auto drawn =
                    hn::And(hn::FirstN(d, std::size_t(last - i + 1)), hn::Gt(key, old));
                hn::StoreU(hn::IfThenElse(drawn, key, old), d, tile.key.data() + at);
                if constexpr (kWithTriangles) {
                    std::uint32_t* const seen = tile.triangle.data() + at;
                    hn::StoreU(
                        hn::IfThenElse(hn::RebindMask(du, drawn), number, hn::LoadU(du, seen)),
                        du, seen);
                }
            }
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
