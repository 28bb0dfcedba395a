#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "screen_space/horizon/slice_tile.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "screen_space/horizon/hbao_tile.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace plumb::HWY_NAMESPACE {

#include "screen_space/horizon/slice_lanes.inc"

namespace {

void Hbao(const SliceTask& task, const HbaoOptions& options, const PixelRect& where,
          Image<float>& A) {
    const float r2 = float(options.sampling.radius_m * options.sampling.radius_m);
    const F cos_bias = Set(float(std::cos(options.bias_rad)));
    const F sin_bias = Set(float(std::sin(options.bias_rad)));
    const F fall = Set(options.attenuate ? 1 / r2 : 0);
    EachBlock(task, where, A, [&](const Block& b, F cos_0, F sin_0) {
        F rise = Zero();
        for (int k = 0; k < task.sampling.slices; ++k) {
            const LaneSlice slice = SliceOf(task, b, cos_0, sin_0, k);
            const F forward =
                hn::Sub(hn::Mul(slice.t.z, slice.cos_gamma), hn::Mul(b.V.z, slice.sin_gamma));
            for (const float side : {1.0f, -1.0f}) {
                const F sin_t = Clamp(hn::Mul(Set(side), forward), Set(-1), Set(1));
                F sin_h = sin_t;
                if (options.bias_rad > 0) {
                    const F cos_t = hn::Sqrt(hn::Sub(Set(1), hn::Mul(sin_t, sin_t)));
                    sin_h = hn::IfThenElse(
                        hn::Ge(sin_t, cos_bias), Set(1),
                        hn::Add(hn::Mul(sin_t, cos_bias), hn::Mul(cos_t, sin_bias)));
                }
                March(task, b, slice, side, [&](M counts, F x, F y, F d2) {
                    const F sin_s = hn::Mul(hn::Add(hn::Mul(x, slice.t.z), hn::Mul(y, b.V.z)),
                                            PerLength(x, y));
                    const M rises = hn::And(counts, hn::Gt(sin_s, sin_h));
                    const F W = hn::Sub(Set(1), hn::Mul(d2, fall));
                    rise = hn::Add(
                        rise, hn::IfThenElseZero(rises, hn::Mul(W, hn::Sub(sin_s, sin_h))));
                    sin_h = hn::IfThenElse(rises, sin_s, sin_h);
                });
            }
        }
        const float factor = float(options.strength / (2 * task.sampling.slices));
        return Clamp(hn::Sub(Set(1), hn::Mul(Set(factor), rise)), Zero(), Set(1));
    });
}

}  // namespace
}  // namespace plumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace plumb {
namespace {

HWY_EXPORT(Hbao);

}  // namespace

void HbaoTile(const SliceTask& task, const HbaoOptions& options, const PixelRect& where,
              Image<float>& A) {
    HWY_DYNAMIC_DISPATCH(Hbao)(task, options, where, A);
}

}  // namespace plumb

#endif
