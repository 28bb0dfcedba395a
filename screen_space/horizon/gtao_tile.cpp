#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "screen_space/horizon/slice_tile.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "screen_space/horizon/gtao_tile.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace plumb::HWY_NAMESPACE {

#include "screen_space/horizon/slice_lanes.inc"

namespace {

void Gtao(const SliceTask& task, const GtaoOptions& options, const PixelRect& where,
          Image<float>& A) {
    const double radius = options.sampling.radius_m, start = options.falloff_start * radius;
    const bool falls = options.falloff_start < 1;
    const F r = Set(float(radius)), per_fall = Set(float(falls ? 1 / (radius - start) : 0));
    const bool behind = options.fade == HorizonFade::kBehind;
    const bool lifts = options.length_lift > 0;
    const F lift = Set(float(options.length_lift));
    const bool thins = options.thickness_blend > 0;
    const F blend = Set(float(options.thickness_blend));
    EachBlock(task, where, A, [&](const Block& b, F cos_0, F sin_0) {
        F sum = Zero(), open = Zero();
        for (int k = 0; k < task.sampling.slices; ++k) {
            const LaneSlice slice = SliceOf(task, b, cos_0, sin_0, k);
            const F L =
                lifts ? hn::Add(slice.L, hn::Mul(lift, hn::Sub(Set(1), slice.L))) : slice.L;
            for (const float side : {1.0f, -1.0f}) {
                const F c_low = hn::Mul(Set(-side), slice.sin_gamma);
                const F c_far = behind ? Set(-1) : c_low;
                F cos_h = c_low;
                March(task, b, slice, side, [&](M counts, F x, F y, F d2) {
                    F c = hn::Mul(y, PerLength(x, y));
                    if (falls) {
                        const F w =
                            hn::Min(hn::Mul(hn::Sub(r, hn::Sqrt(d2)), per_fall), Set(1));
                        c = hn::Add(c_far, hn::Mul(w, hn::Sub(c, c_far)));
                    }
                    F next = hn::Max(c, cos_h);
                    if (thins) {
                        const F lower =
                            hn::Add(cos_h, hn::Mul(hn::Sub(hn::Max(c, c_low), cos_h), blend));
                        next = hn::IfThenElse(hn::Ge(c, cos_h), c, lower);
                    }
                    cos_h = hn::IfThenElse(counts, next, cos_h);
                });
                cos_h = Clamp(cos_h, Set(-1), Set(1));
                sum = hn::Add(sum, hn::Mul(L, Integral(cos_h, side, slice)));
            }
            if (options.normalize) open = hn::Add(open, hn::Mul(L, Open(slice)));
        }
        if (!options.normalize) open = Set(float(task.sampling.slices));
        return hn::Max(hn::Div(sum, open), Zero());
    });
}

}  // namespace
}  // namespace plumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace plumb {
namespace {

HWY_EXPORT(Gtao);

}  // namespace

void GtaoTile(const SliceTask& task, const GtaoOptions& options, const PixelRect& where,
              Image<float>& A) {
    HWY_DYNAMIC_DISPATCH(Gtao)(task, options, where, A);
}

}  // namespace plumb

#endif
