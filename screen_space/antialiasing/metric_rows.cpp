#include "screen_space/antialiasing/metric_rows.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "screen_space/antialiasing/windows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "screen_space/antialiasing/metric_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace plumb::HWY_NAMESPACE {
namespace {

#include "screen_space/simd/lanes.inc"

// Half as many numbers at once, in double.
using Doubles = hn::CappedTag<double, 8>;
using HalfFloats = hn::Rebind<float, Doubles>;
using HalfInts = hn::Rebind<std::int32_t, Doubles>;
using D = hn::Vec<Doubles>;
using Vector = LaneVector<D>;

inline D SetD(double value) {
    return hn::Set(Doubles(), value);
}

/// A block of pixels of a row, from pixel x on; lanes beyond the row repeat its last pixel.
class Block {
  public:
    Block(int x, int width) : x_(x), last_(width - 1) {}

    /// values[(x + lane) * step + offset]
    D Gather(const float* values, int step, int offset) const {
        const HalfInts ints;
        const auto pixel =
            hn::Min(hn::Add(hn::Iota(ints, 0), hn::Set(ints, x_)), hn::Set(ints, last_));
        const auto at = hn::Add(hn::Mul(pixel, hn::Set(ints, step)), hn::Set(ints, offset));
        return hn::PromoteTo(Doubles(), hn::GatherIndex(HalfFloats(), values, at));
    }

    void Store(D values, float* to) const {
        const HalfFloats df;
        const auto narrow = hn::DemoteTo(df, values);
        if (x_ + int(hn::Lanes(df)) <= last_ + 1) {
            hn::StoreU(narrow, df, to + x_);
            return;
        }
        alignas(64) float lanes[8];
        hn::Store(narrow, df, lanes);
        std::copy(lanes, lanes + (last_ + 1 - x_), to + x_);
    }

  private:
    int x_, last_;
};

/// EncodedDepth of a vector, rounded to float as it is there.
class Encoder {
  public:
    explicit Encoder(const DepthMetric& metric)
        : metric_(metric), levels_(metric.bits > 0 ? double((1 << metric.bits) - 1) : 0) {}

    D operator()(D z_m) const {
        const D near = SetD(metric_.near_m), far = SetD(metric_.far_m);
        const D away = hn::Neg(z_m);
        const D d = hn::IfThenElse(hn::Lt(away, far), hn::Max(near, away), far);
        const D range = SetD(metric_.far_m - metric_.near_m);
        D encoded = d;
        if (metric_.encoding == DepthEncoding::kLinear) {
            encoded = hn::Div(hn::Sub(d, near), range);
        } else if (metric_.encoding == DepthEncoding::kDevice) {
            encoded = hn::Div(hn::Mul(far, hn::Sub(d, near)), hn::Mul(d, range));
        }
        if (metric_.bits > 0) {
            const D level = hn::Floor(hn::Add(hn::Mul(encoded, SetD(levels_)), SetD(0.5)));
            encoded = hn::Div(level, SetD(levels_));
        }
        return hn::PromoteTo(Doubles(), hn::DemoteTo(HalfFloats(), encoded));
    }

  private:
    const DepthMetric& metric_;
    double levels_;
};

void Depths(const DepthMetric& metric, const Image<float>& z_m, int m, int y, float* k) {
    const Encoder encode(metric);
    const D n = SetD(m * m);
    const int width = z_m.Width() / m, lanes = int(hn::Lanes(Doubles()));
    alignas(64) double kept[kMaxSamples * 8];
    for (int x = 0; x < width; x += lanes) {
        const Block block(x, width);
        D sum = SetD(0);
        for (int j = 0; j < m; ++j) {
            const float* row = &z_m(0, y * m + j);
            for (int i = 0; i < m; ++i) {
                const D d = encode(block.Gather(row, m, i));
                sum = hn::Add(sum, d);
                hn::Store(d, Doubles(), kept + std::size_t(j * m + i) * 8);
            }
        }
        const D mean = hn::Div(sum, n);
        D squares = SetD(0);
        for (int i = 0; i < m * m; ++i) {
            const D off = hn::Sub(hn::Load(Doubles(), kept + std::size_t(i) * 8), mean);
            squares = hn::Add(squares, hn::Mul(off, off));
        }
        const D samples = hn::Mul(SetD(metric.c), hn::Div(squares, n));
        block.Store(hn::Max(SetD(0), samples), k);
    }
}

void Normals(const NormalMetric& metric, const Image<Vec3f>& normals, int m, int y, float* k) {
    const int width = normals.Width() / m, lanes = int(hn::Lanes(Doubles()));
    const bool unit = metric.mean == MeanNormal::kUnit;
    Vector kept[kMaxSamples];
    for (int x = 0; x < width; x += lanes) {
        const Block block(x, width);
        Vector sum{SetD(0), SetD(0), SetD(0)};
        // 1 where every normal, and where some normal, is 0: the sky's.
        D all_sky = SetD(1), some_sky = SetD(0);
        for (int j = 0; j < m; ++j) {
            const float* row = normals(0, y * m + j).data();
            for (int i = 0; i < m; ++i) {
                Vector& n = kept[j * m + i];
                n = {block.Gather(row, 3 * m, 3 * i), block.Gather(row, 3 * m, 3 * i + 1),
                     block.Gather(row, 3 * m, 3 * i + 2)};
                sum = Plus(sum, n);
                const auto sky = hn::And(hn::And(hn::Eq(n.x, SetD(0)), hn::Eq(n.y, SetD(0))),
                                         hn::Eq(n.z, SetD(0)));
                all_sky = hn::IfThenElseZero(sky, all_sky);
                some_sky = hn::IfThenElse(sky, SetD(1), some_sky);
            }
        }
        Vector mean = Over(sum, SetD(m * m));
        const D length = hn::Sqrt(Dot(mean, mean));
        if (unit) mean = Over(mean, length);
        D most = SetD(0);
        for (int i = 0; i < m * m; ++i) {
            const Vector& n = kept[i];
            if (unit) {
                const Vector apart = Minus(mean, n), together = Plus(mean, n);
                const D least = hn::Min(Dot(apart, apart), Dot(together, together));
                most = hn::Max(most, hn::Mul(least, SetD(0.5)));
            } else {
                const D less = Dot(Minus(n, mean), n);
                most = hn::Max(most, hn::Min(less, hn::Sub(SetD(2), less)));
            }
        }
        const auto widest = hn::Or(hn::Eq(some_sky, SetD(1)), hn::Not(hn::Gt(length, SetD(0))));
        most = hn::IfThenElse(widest, SetD(1), hn::Min(most, SetD(1)));
        most = hn::IfThenZeroElse(hn::Eq(all_sky, SetD(1)), most);
        block.Store(hn::Mul(SetD(metric.c), hn::Sqrt(most)), k);
    }
}

}  // namespace
}  // namespace plumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace plumb {
namespace {

HWY_EXPORT(Depths);
HWY_EXPORT(Normals);

}  // namespace

void DepthRow(const DepthMetric& metric, const Image<float>& z_m, int m, int y, float* k) {
    HWY_DYNAMIC_DISPATCH(Depths)(metric, z_m, m, y, k);
}

void NormalRow(const NormalMetric& metric, const Image<Vec3f>& normals, int m, int y,
               float* k) {
    HWY_DYNAMIC_DISPATCH(Normals)(metric, normals, m, y, k);
}

}  // namespace plumb

#endif
