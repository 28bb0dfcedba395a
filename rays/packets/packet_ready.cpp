#include <cassert>
#include <limits>

#include "rays/packets/packet_walk.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rays/packets/packet_ready.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace plumb::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<float, 16>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
using U = hn::RebindToUnsigned<D>;

int Most() {
    return int(hn::MaxLanes(D()));
}

// 1 where the mask is set.
HWY_INLINE hn::Vec<U> Bit(M mask, int shift) {
    return hn::IfThenElseZero(hn::RebindMask(U(), mask),
                              hn::Set(U(), std::uint32_t{1} << shift));
}

// ReadyToWalk of walk_ray.h, by the same operations in the same order.
std::uint64_t Ready(const BspBox& box, Packet& packet) {
    const D d;
    const U u;
    std::uint64_t enter = 0;
    for (std::size_t i = 0; i < std::size_t(packet.rays); i += hn::MaxLanes(d)) {
        const auto load = [&](const Packet::Each<float>& of)
                              HWY_ATTR { return hn::Load(d, of.data() + i); };
        const auto store = [&](V v, Packet::Each<float>& in)
                               HWY_ATTR { hn::Store(v, d, in.data() + i); };
        const V zero = hn::Zero(d), one = hn::Set(d, 1);
        const V least = hn::Set(d, WalkRay::kShortest);
        const V most = hn::Set(d, WalkRay::kMostDirection);
        const std::array<V, 3> o{load(packet.origin_m[0]), load(packet.origin_m[1]),
                                 load(packet.origin_m[2])};
        std::array<V, 3> w{load(packet.direction[0]), load(packet.direction[1]),
                           load(packet.direction[2])};
        const V x = hn::Abs(w[0]), y = hn::Abs(w[1]), z = hn::Abs(w[2]);
        const M first = hn::And(hn::Ge(x, y), hn::Ge(x, z));
        const M second = hn::AndNot(first, hn::Ge(y, z));
        const auto choose = [&](V a, V b, V c) HWY_ATTR {
            return hn::IfThenElse(first, a, hn::IfThenElse(second, b, c));
        };
        const V longest = choose(w[0], w[1], w[2]);
        const V power = hn::And(longest, hn::BitCast(d, hn::Set(u, 0x7f800000u)));
        const V near = load(packet.near), far = load(packet.best);
        M fit = hn::And(hn::And(hn::Gt(power, zero), hn::Le(power, most)), hn::Le(near, far));
        V reach = zero;
        for (std::size_t k = 0; k < 3; ++k) {
            fit = hn::And(fit, hn::And(hn::Le(hn::Abs(o[k]), hn::Set(d, WalkRay::kMostOriginM)),
                                       hn::Le(hn::Abs(w[k]), most)));
            reach = hn::Max(reach, hn::Max(hn::Abs(hn::Sub(hn::Set(d, box.low_m[k]), o[k])),
                                           hn::Abs(hn::Sub(hn::Set(d, box.high_m[k]), o[k]))));
        }
        const V per_length = hn::Div(one, power);
        store(per_length, packet.per_length);
        V begin = hn::Mul(near, power), end = hn::Mul(far, power);
        store(begin, packet.near);
        store(end, packet.best);
        auto kind = hn::Or(Bit(second, 3), Bit(hn::Not(hn::Or(first, second)), 4));
        for (std::size_t k = 0; k < 3; ++k) {
            w[k] = hn::Mul(w[k], per_length);
            const V walked =
                hn::IfThenElse(hn::Ge(hn::Abs(w[k]), least), w[k], hn::CopySign(least, w[k]));
            const V inverse = hn::Div(one, walked);
            const V margin =
                hn::Mul(hn::Mul(hn::Set(d, WalkRay::kMargin), reach), hn::Abs(inverse));
            const V a = hn::Mul(hn::Sub(hn::Set(d, box.low_m[k]), o[k]), inverse);
            const V b = hn::Mul(hn::Sub(hn::Set(d, box.high_m[k]), o[k]), inverse);
            begin = hn::Max(begin, hn::Sub(hn::Min(a, b), margin));
            end = hn::Min(end, hn::Add(hn::Max(a, b), margin));
            kind = hn::Or(kind,
                          hn::ShiftLeftSame(hn::ShiftRight<31>(hn::BitCast(u, w[k])), int(k)));
            store(w[k], packet.direction[k]);
            store(inverse, packet.inverse[k]);
            store(margin, packet.margin[k]);
        }
        store(hn::IfThenElseZero(fit, begin), packet.begin);
        store(hn::IfThenElse(fit, end, hn::Set(d, -1)), packet.end);
        hn::Store(kind, u, packet.kinds.data() + i);
        hn::Store(hn::Set(u, Hit::kNone), u, packet.triangle.data() + i);
        // ShearAxes::Of: the two axes after the longest, swapped where it is run backwards.
        const V w_z = choose(w[0], w[1], w[2]);
        const V next = choose(w[1], w[2], w[0]), after = choose(w[2], w[0], w[1]);
        const M backwards = hn::MaskFromVec(
            hn::BitCast(d, hn::BroadcastSignBit(hn::BitCast(hn::RebindToSigned<D>(), w_z))));
        store(hn::Div(hn::IfThenElse(backwards, after, next), w_z), packet.shear_x);
        store(hn::Div(hn::IfThenElse(backwards, next, after), w_z), packet.shear_y);
        std::uint64_t bits = 0;
        hn::StoreMaskBits(d, hn::And(fit, hn::Le(begin, end)),
                          reinterpret_cast<std::uint8_t*>(&bits));
        enter |= bits << i;
    }
    return packet.rays == 64 ? enter : enter & ((std::uint64_t{1} << packet.rays) - 1);
}

}  // namespace
}  // namespace plumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace plumb {
namespace {

HWY_EXPORT(Most);
HWY_EXPORT(Ready);

}  // namespace

int MostLanes() {
    return HWY_DYNAMIC_DISPATCH(Most)();
}

std::uint64_t MakeReady(const BspBox& box, Packet& packet) {
    return HWY_DYNAMIC_DISPATCH(Ready)(box, packet);
}

}  // namespace plumb

#endif
