#include "screen_space/sao/blur_rows.h"

#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "screen_space/sao/blur_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace plumb::HWY_NAMESPACE {
namespace {

#include "screen_space/simd/lanes.inc"

using Vector = LaneVector<F>;

/// A block of pixels of a row that is `width` long, from pixel x on; lanes beyond it hold 0.
struct Block {
    Block(int first, int row_width)
        : x(first), width(row_width), whole(x >= 0 && x + int(hn::Lanes(Floats())) <= width) {}

    F Of(const float* row) const {
        const Floats df;
        if (whole) return hn::LoadU(df, row + x);
        alignas(64) float lanes[16] = {};
        for (int i = 0; i < int(hn::Lanes(df)); ++i) {
            if (0 <= x + i && x + i < width) lanes[i] = row[x + i];
        }
        return hn::Load(df, lanes);
    }

    Vector Of(const Vec3f* row) const {
        const Floats df;
        Vector v;
        if (whole) {
            hn::LoadInterleaved3(df, row[x].data(), v.x, v.y, v.z);
            return v;
        }
        alignas(64) float lanes[3][16] = {};
        for (int i = 0; i < int(hn::Lanes(df)); ++i) {
            if (0 > x + i || x + i >= width) continue;
            for (int axis = 0; axis < 3; ++axis) lanes[axis][i] = row[x + i][axis];
        }
        return {hn::Load(df, lanes[0]), hn::Load(df, lanes[1]), hn::Load(df, lanes[2])};
    }

    F Places() const { return hn::Add(hn::Iota(Floats(), 0), Set(x)); }

    F Kept(F weight) const {
        if (whole) return weight;
        const F place = Places();
        const auto inside = hn::And(hn::Ge(place, Zero()), hn::Lt(place, Set(width)));
        return hn::IfThenElseZero(inside, weight);
    }

    int x, width;
    bool whole;
};

/// What a block of pixels lies on.
struct Surface {
    Vector C, n;
};

Surface SurfaceOf(const BlurGuide& guide, const Block& block, F key, int y) {
    const View& view = guide.view;
    const F z = hn::Mul(key, Set(guide.z_min_m));
    const double a = -2 * view.tan_half_width / view.width_px;
    const double b = view.tan_half_width * (1 + 2.0 * view.guard_px / view.width_px);
    const double s_y = view.Point(0, y + 0.5, 1).y();
    const F s_x = hn::Add(hn::Mul(hn::Add(block.Places(), Set(0.5)), Set(a)), Set(b));
    return {.C = {hn::Mul(z, s_x), hn::Mul(z, Set(s_y)), z},
            .n = block.Of(&(*guide.normal)(0, y))};
}

F SurfaceWeight(const Surface& centre, const Surface& tap, const BlurOptions& options) {
    F weight = Set(1);
    if (options.normal_weight) weight = hn::Min(hn::Max(Zero(), Dot(centre.n, tap.n)), Set(1));
    if (options.plane_weight) {
        const Vector across = Minus(centre.C, tap.C);
        const F d2 = Dot(across, across);
        const auto far = hn::Ge(d2, Set(options.near_m2));
        const F off = hn::Max(hn::Abs(Dot(across, tap.n)), hn::Abs(Dot(across, centre.n)));
        const F d = hn::Sqrt(hn::IfThenElse(far, d2, Set(1)));
        const F in = hn::Max(Zero(), hn::Sub(Set(1), hn::Mul(Set(2), hn::Div(off, d))));
        weight = hn::Mul(weight, hn::IfThenElse(far, hn::Mul(in, in), Set(1)));
    }
    return weight;
}

void Row(BlurAxis axis, const Image<float>& A, const BlurGuide& guide,
         const BlurOptions& options, int y, int x0, int x1, float* to) {
    const Floats df;
    const int lanes = int(hn::Lanes(df));
    const bool surfaces = options.normal_weight || options.plane_weight;
    alignas(64) float part[16];
    for (int x = x0; x < x1; x += lanes) {
        const Block centre(x, A.Width());
        const F key = centre.Of(&guide.key(0, y)), a = centre.Of(&A(0, y));
        Surface here;
        if (surfaces) here = SurfaceOf(guide, centre, key, y);
        F weights = Set(options.kernel[0]), sum = hn::Mul(weights, a);
        for (const int side : {-1, 1}) {
            F nearest = Set(1);
            for (int k = 1; k <= options.taps_each_side; ++k) {
                const int step = side * k * options.stride_px;
                const int j = axis == BlurAxis::kY ? y + step : y;
                if (j < 0 || j >= A.Height()) continue;
                const Block tap(axis == BlurAxis::kX ? x + step : x, A.Width());
                const F tap_key = tap.Of(&guide.key(0, j));
                const F off =
                    hn::Mul(Set(options.edge_sharpness), hn::Abs(hn::Sub(tap_key, key)));
                F share = hn::Max(Zero(), hn::Sub(Set(1), off));
                if (surfaces) {
                    const Surface there = SurfaceOf(guide, tap, tap_key, j);
                    share = hn::Mul(share, SurfaceWeight(here, there, options));
                    share = hn::IfThenElseZero(hn::Gt(share, Zero()), share);  // NaN
                }
                if (options.monotonic) share = nearest = hn::Min(nearest, share);
                const F g = Set(options.lift + options.kernel[std::size_t(k)]);
                const F weight = tap.Kept(hn::Mul(share, g));
                sum = hn::Add(sum, hn::Mul(weight, tap.Of(&A(0, j))));
                weights = hn::Add(weights, weight);
            }
        }
        const F mean = hn::Div(sum, hn::Add(weights, Set(options.tiny)));
        const F blurred = hn::IfThenElse(hn::Eq(key, Set(1)), a, mean);
        if (x + lanes <= x1) {
            hn::StoreU(blurred, df, to + x);
        } else {
            hn::Store(blurred, df, part);
            for (int i = x; i < x1; ++i) to[i] = part[i - x];
        }
    }
}

}  // namespace
}  // namespace plumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace plumb {
namespace {

HWY_EXPORT(Row);

}  // namespace

void BlurRow(BlurAxis axis, const Image<float>& A, const BlurGuide& guide,
             const BlurOptions& options, int y, int x0, int x1, float* to) {
    HWY_DYNAMIC_DISPATCH(Row)(axis, A, guide, options, y, x0, x1, to);
}

}  // namespace plumb

#endif
