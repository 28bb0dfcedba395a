#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "screen_space/horizon/slice_tile.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "screen_space/horizon/bitmask_tile.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace plumb::HWY_NAMESPACE {

#include "screen_space/horizon/slice_lanes.inc"

namespace {

/// The first `count` of 32 sectors.
inline U FirstSectors(I count) {
    const Ints di;
    const Bits du;
    const U one = hn::Set(du, 1u);
    const auto all = hn::Gt(count, hn::Set(di, 31));
    const I shift = hn::Min(hn::Max(count, hn::Zero(di)), hn::Set(di, 31));
    const U some = hn::Sub(one << hn::BitCast(du, shift), one);
    return hn::IfThenElse(hn::RebindMask(du, all), hn::Set(du, ~0u), some);
}

void Bitmask(const SliceTask& task, const BitmaskOptions& options, const PixelRect& where,
             Image<float>& A) {
    const Ints di;
    const Bits du;
    const bool cosine = options.measure == SectorMeasure::kCosine;
    const bool ceil = options.rounding == SectorRounding::kCeil;
    const bool endless = std::isinf(options.thickness_m);
    const F thickness = Set(endless ? 0 : float(options.thickness_m));
    const F S = Set(float(options.sectors));
    const I sectors = hn::Set(di, options.sectors);
    EachBlock(task, where, A, [&](const Block& b, F cos_0, F sin_0) {
        F sum = Zero(), weights = Zero();
        for (int k = 0; k < task.sampling.slices; ++k) {
            const LaneSlice slice = SliceOf(task, b, cos_0, sin_0, k);
            const F gamma = Gamma(slice);
            const F open = hn::Add(slice.cos_gamma, hn::Mul(gamma, slice.sin_gamma));
            // a(gamma - pi/2, gamma), whose cosine is sin gamma.
            const F below = Integral(slice.sin_gamma, -1, slice);
            const auto share = [&](F x, F y, float side) {
                const F c_low = hn::Mul(Set(-side), slice.sin_gamma);
                const F c = hn::Max(hn::Mul(y, PerLength(x, y)), c_low);
                F h;
                if (cosine) {
                    const F to =
                        hn::Mul(Set(side), Integral(Clamp(c, Set(-1), Set(1)), side, slice));
                    h = hn::Div(hn::Add(below, to), open);
                } else {
                    const F th = hn::Mul(Set(side), ArcCosine(Clamp(c, Set(-1), Set(1))));
                    h = hn::Mul(hn::Add(hn::Sub(th, gamma), Set(kHalfPi)), Set(1 / kPi));
                }
                return Clamp(h, Zero(), Set(1));
            };
            U closed = hn::Zero(du);
            for (const float side : {1.0f, -1.0f}) {
                March(task, b, slice, side, [&](M counts, F x, F y, F) {
                    const F front = share(x, y, side);
                    const F back =
                        endless ? Set(side > 0 ? 1 : 0) : share(x, hn::Sub(y, thickness), side);
                    const F h_1 = hn::Mul(hn::Min(front, back), S);
                    const F h_2 = hn::Mul(hn::Max(front, back), S);
                    I from, to;
                    if (ceil) {
                        from = hn::ConvertTo(di, hn::Floor(h_1));
                        to = hn::Add(from, hn::ConvertTo(di, hn::Ceil(hn::Sub(h_2, h_1))));
                    } else {
                        from = hn::ConvertTo(di, hn::Floor(hn::Add(h_1, Set(0.5f))));
                        to = hn::ConvertTo(di, hn::Floor(hn::Add(h_2, Set(0.5f))));
                    }
                    to = hn::Min(to, sectors);
                    const U bits = hn::AndNot(FirstSectors(from), FirstSectors(to));
                    closed =
                        hn::Or(closed, hn::IfThenElseZero(hn::RebindMask(du, counts), bits));
                });
            }
            const F shut =
                hn::ConvertTo(Floats(), hn::BitCast(di, hn::PopulationCount(closed)));
            const F T = cosine ? hn::Mul(slice.L, open) : Set(1);
            sum = hn::Add(sum, hn::Mul(T, hn::Sub(Set(1), hn::Div(shut, S))));
            weights = hn::Add(weights, T);
        }
        if (!options.normalize) weights = Set(float(task.sampling.slices));
        return hn::Div(sum, weights);
    });
}

}  // namespace
}  // namespace plumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace plumb {
namespace {

HWY_EXPORT(Bitmask);

}  // namespace

void BitmaskTile(const SliceTask& task, const BitmaskOptions& options, const PixelRect& where,
                 Image<float>& A) {
    HWY_DYNAMIC_DISPATCH(Bitmask)(task, options, where, A);
}

}  // namespace plumb

#endif
