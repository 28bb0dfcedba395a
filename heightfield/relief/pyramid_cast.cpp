#include "heightfield/relief/pyramid_cast.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

#include "heightfield/relief/lane_rays.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "heightfield/relief/pyramid_cast.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace plumb::HWY_NAMESPACE {

#include "heightfield/relief/pyramid_lanes.inc"

namespace {

// Rays on their way over a field, one a lane.
template <class T>
class Casters : public Walkers<T> {
  public:
    using W = Walkers<T>;
    using typename W::Corners;
    using typename W::D;
    using typename W::DI;
    using typename W::F;
    using typename W::I;
    using typename W::M;
    using typename W::Square;
    using typename W::TI;
    static constexpr std::size_t kMostLanes = 64 / sizeof(T);

    Casters(const HeightPyramid<T>& over, const LaneRays<T>& rays, std::size_t& next)
        : W(over), rays_(rays), next_(next) {
        z = dz = t_end = t_hit = hn::Zero(D());
        half = W::Whole(-1);
        live = met = met_lower = W::None();
        std::ranges::fill(ray_, TI(0));
    }

    // One after the other gives a machine that works ahead two independent steps at a time.
    template <bool kBilinear, bool kWhere>
    static void RunBoth(Casters& a, Casters& b, LaneHits<T>& hits) {
        bool more_a = a.template Refill<kWhere>(hits), more_b = b.template Refill<kWhere>(hits);
        while (more_a && more_b) {
            do {
                a.template Step<kBilinear, kWhere>();
                b.template Step<kBilinear, kWhere>();
            } while (a.Busy() && b.Busy());
            if (!a.Busy()) more_a = a.template Refill<kWhere>(hits);
            if (!b.Busy()) more_b = b.template Refill<kWhere>(hits);
        }
        if (more_a) a.template Finish<kBilinear, kWhere>(hits);
        if (more_b) b.template Finish<kBilinear, kWhere>(hits);
    }

  private:
    template <bool kBilinear, bool kWhere>
    HWY_NOINLINE void Finish(LaneHits<T>& hits) {
        do {
            while (Busy()) Step<kBilinear, kWhere>();
        } while (Refill<kWhere>(hits));
    }

    // Whether so many lanes are on their way that it is too early to fill the others again.
    bool Busy() const {
        const std::size_t lanes = hn::Lanes(D());
        return hn::CountTrue(D(), live) > (next_ < rays_.count ? lanes - lanes / 2 : 0);
    }

    // Writes down what became of lanes that are done and gives them new rays; false if none are
    // left.
    template <bool kWhere>
    HWY_NOINLINE bool Refill(LaneHits<T>& hits) {
        const std::size_t lanes = hn::Lanes(D());
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(D(), live, bits);
        const unsigned busy = bits[0] | unsigned(bits[1]) << 8;
        bits[0] = bits[1] = 0;
        hn::StoreMaskBits(D(), met, bits);
        const unsigned hit = bits[0] | unsigned(bits[1]) << 8;
        const unsigned all = (1u << lanes) - 1;
        unsigned done = filled_ & ~busy;
        if constexpr (kWhere) {
            alignas(64) T where[kMostLanes];
            alignas(64) TI column[kMostLanes], row[kMostLanes];
            hn::Store(t_hit, D(), where);
            hn::Store(this->i, DI(), column);
            hn::Store(this->j, DI(), row);
            bits[0] = bits[1] = 0;
            hn::StoreMaskBits(D(), met_lower, bits);
            const unsigned lower = bits[0] | unsigned(bits[1]) << 8;
            for (; done != 0; done &= done - 1) {
                const int lane = std::countr_zero(done);
                const std::size_t ray = std::size_t(ray_[lane]);
                hits.met[ray] = hit >> lane & 1;
                hits.t[ray] = where[lane];
                hits.i[ray] = std::int32_t(column[lane]), hits.j[ray] = std::int32_t(row[lane]);
                hits.upper[ray] = std::uint8_t(~lower >> lane & 1);
            }
        } else {
            for (; done != 0; done &= done - 1) {
                const int lane = std::countr_zero(done);
                hits.met[std::size_t(ray_[lane])] = hit >> lane & 1;
            }
        }

        unsigned fresh = 0;
        for (unsigned idle = all & ~busy; idle != 0 && next_ < rays_.count; idle &= idle - 1) {
            const int lane = std::countr_zero(idle);
            ray_[lane] = TI(next_++);
            fresh |= 1u << lane;
        }
        filled_ = busy | fresh;
        if (filled_ == 0) return false;
        if (fresh != 0) Take(fresh);
        return true;
    }

    void Take(unsigned fresh) {
        const std::uint8_t bits[8] = {std::uint8_t(fresh), std::uint8_t(fresh >> 8)};
        const M mask = hn::LoadMaskBits(D(), bits);
        const I at = hn::Load(DI(), ray_);
        const auto take = [&](F& to, const T* from) {
            to = hn::IfThenElse(mask, hn::GatherIndex(D(), from, at), to);
        };
        const auto take_whole = [&](I& to, const TI* from) {
            to = W::Choose(mask, hn::GatherIndex(DI(), from, at), to);
        };
        take(this->u, rays_.u.data()), take(this->v, rays_.v.data()), take(z, rays_.z.data());
        take(this->du, rays_.du.data()), take(this->dv, rays_.dv.data());
        take(dz, rays_.dz.data()), take(t_end, rays_.t_end.data());
        take_whole(this->i, rays_.i.data()), take_whole(this->j, rays_.j.data());
        take_whole(half, rays_.half.data());
        this->t = hn::IfThenElse(mask, hn::Zero(D()), this->t);
        this->level = W::Choose(mask, W::Whole(0), this->level);
        this->Aim();
        live = hn::Or(live, mask);
        met = hn::AndNot(mask, met);
    }

    template <bool kBilinear, bool kWhere>
    HWY_INLINE void Step() {
        const Square s = this->Ahead();
        const F z_in = Height(this->t), z_out = Height(s.t_out);
        const M below = hn::Lt(this->Top(s), hn::Min(z_in, z_out));
        const M cell = W::Of(hn::Eq(this->level, W::Whole(0)));
        const M ahead = hn::AndNot(below, live);
        const M tried = hn::And(cell, ahead);
        M hit = W::None();
        if (!hn::AllFalse(D(), tried)) {
            hit = hn::And(tried, kBilinear ? MeetPatch<kWhere>(s, tried)
                                           : MeetTriangles<kWhere>(s, tried, z_in, z_out));
        }
        this->level =
            W::Choose(hn::AndNot(cell, ahead), hn::Sub(this->level, W::Whole(1)), this->level);
        const M on = hn::AndNot(hit, hn::Or(tried, hn::And(below, live)));
        half = W::Choose(on, W::Whole(-1), half);
        M gone = this->Leave(on, s);
        gone = hn::Or(gone, hn::Ge(this->t, t_end));
        met = hn::Or(met, hit);
        live = hn::AndNot(hn::Or(hit, hn::And(on, gone)), live);
    }

    F Height(F at) const { return hn::Add(z, hn::Mul(at, dz)); }

    template <bool kWhere>
    HWY_INLINE M MeetTriangles(const Square& s, M tried, F z_in, F z_out) {
        const F zero = hn::Zero(D());
        const Corners c = this->OfCell();
        const F fu_in = this->InCellU(this->t), fv_in = this->InCellV(this->t);
        const F fu_out = this->InCellU(s.t_out), fv_out = this->InCellV(s.t_out);
        const M first = W::Of(hn::Gt(half, W::Whole(-1)));
        const M in_lower = W::Of(hn::Eq(half, W::Whole(0)));
        const auto h = this->Halve(s, c, fu_in, fv_in, fu_out, fv_out, first, in_lower);
        const F gap_diagonal = hn::Sub(Height(h.t_diagonal), h.z_diagonal);
        const F gap_out = hn::Sub(z_out, h.z_out);
        const M on_first = hn::AndNot(first, hn::And(h.crosses, hn::Le(gap_diagonal, zero)));
        const M on_last = hn::And(hn::Le(gap_out, zero), hn::Or(h.crosses, hn::Not(first)));
        const M hit = hn::Or(on_first, on_last);
        if constexpr (kWhere) {
            // The half that was met, from where it was entered to where it ends.
            const M late = hn::AndNot(on_first, h.crosses);
            const F t_0 = hn::IfThenElse(late, h.t_diagonal, this->t);
            const F t_1 = hn::IfThenElse(on_first, h.t_diagonal, s.t_out);
            const F gap_in = hn::Sub(z_in, W::OnTriangle(c, h.lower_in, fu_in, fv_in));
            const F gap_0 = hn::Max(hn::IfThenElse(late, gap_diagonal, gap_in), zero);
            const F gap_1 = hn::IfThenElse(on_first, gap_diagonal, gap_out);
            const F fall = hn::Sub(gap_0, gap_1);
            const F share = hn::IfThenElseZero(hn::Gt(fall, zero), hn::Div(gap_0, fall));
            const F where = hn::Add(t_0, hn::Mul(W::Unit(share), hn::Sub(t_1, t_0)));
            const M now = hn::And(hit, tried);
            t_hit = hn::IfThenElse(now, where, t_hit);
            const M lower =
                hn::Or(hn::And(on_first, h.lower_in), hn::AndNot(on_first, h.lower_out));
            met_lower = hn::Or(hn::And(now, lower), hn::AndNot(now, met_lower));
        }
        return hit;
    }

    template <bool kWhere>
    HWY_INLINE M MeetPatch(const Square& s, M tried) {
        const F zero = hn::Zero(D());
        const Corners c = this->OfCell();
        const F fu = this->InCellU(this->t), fv = this->InCellV(this->t);
        const F along_u = hn::Sub(c.z_10, c.z_00), along_v = hn::Sub(c.z_01, c.z_00);
        const F twist = hn::Sub(hn::Sub(c.z_11, c.z_10), along_v);
        const auto surface = [&](F at_u, F at_v) {
            return hn::Add(c.z_00,
                           hn::Add(hn::Add(hn::Mul(at_u, along_u), hn::Mul(at_v, along_v)),
                                   hn::Mul(hn::Mul(at_u, at_v), twist)));
        };
        const M first = W::Of(hn::Gt(half, W::Whole(-1)));
        // The ray's height above the patch is A s^2 + B s + C at s = t - t_in.
        const F A = hn::Neg(hn::Mul(twist, hn::Mul(this->du, this->dv)));
        const F grade =
            hn::Add(hn::Add(hn::Mul(along_u, this->du), hn::Mul(along_v, this->dv)),
                    hn::Mul(twist, hn::Add(hn::Mul(fu, this->dv), hn::Mul(fv, this->du))));
        const F B = hn::Sub(dz, grade);
        const F C = hn::IfThenElse(first, zero,
                                   hn::Max(hn::Sub(Height(this->t), surface(fu, fv)), zero));
        const F length = hn::Sub(s.t_out, this->t);
        const F gap_out =
            hn::Sub(Height(s.t_out), surface(this->InCellU(s.t_out), this->InCellV(s.t_out)));
        // Of a start on the patch only the other root counts.
        const M returns =
            hn::And(hn::Lt(hn::Add(B, hn::Mul(length, A)), zero), hn::Gt(length, zero));
        const F discriminant = hn::Sub(hn::Mul(B, B), hn::Mul(W::Set(4), hn::Mul(A, C)));
        const M dips =
            hn::And(hn::And(hn::Gt(A, zero), hn::Lt(B, zero)),
                    hn::And(hn::Lt(hn::Neg(B), hn::Mul(W::Set(2), hn::Mul(A, length))),
                            hn::Ge(discriminant, zero)));
        const M hit = hn::Or(hn::And(first, returns),
                             hn::AndNot(first, hn::Or(hn::Le(gap_out, zero), dips)));
        if constexpr (kWhere) {
            const F root = hn::Sqrt(hn::Max(discriminant, zero));
            const M falling = hn::Lt(B, zero);
            const F by_c = hn::Div(hn::Mul(W::Set(2), C), hn::Sub(root, B));
            const F by_a = hn::Div(hn::Neg(hn::Add(B, root)), hn::Mul(W::Set(2), A));
            F way = hn::IfThenElse(falling, by_c, by_a);
            way = hn::IfThenElse(first, hn::Div(hn::Neg(B), A), way);
            // C = 0: it enters on the surface. NaN, from 0 / 0, is not > 0 either.
            way = hn::IfThenElseZero(hn::And(hn::Gt(way, zero), hn::Or(first, hn::Gt(C, zero))),
                                     hn::Min(way, length));
            const M now = hn::And(hit, tried);
            t_hit = hn::IfThenElse(now, hn::Add(this->t, way), t_hit);
            met_lower = hn::Or(now, met_lower);
        }
        return hit;
    }

    const LaneRays<T>& rays_;
    std::size_t& next_;    // The next ray that no lane has taken.
    unsigned filled_ = 0;  // Lanes whose ray's answer is not written down yet.
    alignas(64) TI ray_[kMostLanes];
    F z, dz, t_end, t_hit;
    I half;  // Of the cell that the ray starts in, while it is there; else -1.
    M live, met, met_lower;
};

template <class T>
void RunRays(const HeightPyramid<T>& field, ReliefSurface surface, bool where,
             const LaneRays<T>& rays, LaneHits<T>& hits) {
    std::size_t next = 0;
    Casters<T> a(field, rays, next), b(field, rays, next);
    if (surface == ReliefSurface::kTriangles) {
        where ? Casters<T>::template RunBoth<false, true>(a, b, hits)
              : Casters<T>::template RunBoth<false, false>(a, b, hits);
    } else {
        where ? Casters<T>::template RunBoth<true, true>(a, b, hits)
              : Casters<T>::template RunBoth<true, false>(a, b, hits);
    }
}

void RunFloat(const HeightPyramid<float>& field, ReliefSurface surface, bool where,
              const LaneRays<float>& rays, LaneHits<float>& hits) {
    RunRays(field, surface, where, rays, hits);
}
void RunDouble(const HeightPyramid<double>& field, ReliefSurface surface, bool where,
               const LaneRays<double>& rays, LaneHits<double>& hits) {
    RunRays(field, surface, where, rays, hits);
}

}  // namespace
}  // namespace plumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace plumb {
namespace {

HWY_EXPORT(RunFloat);
HWY_EXPORT(RunDouble);

void RunOnAnyMachine(const HeightPyramid<float>& field, ReliefSurface surface, bool where,
                     const LaneRays<float>& rays, LaneHits<float>& hits) {
    HWY_DYNAMIC_DISPATCH(RunFloat)(field, surface, where, rays, hits);
}
void RunOnAnyMachine(const HeightPyramid<double>& field, ReliefSurface surface, bool where,
                     const LaneRays<double>& rays, LaneHits<double>& hits) {
    HWY_DYNAMIC_DISPATCH(RunDouble)(field, surface, where, rays, hits);
}

}  // namespace

template <class T>
void CastRays(const HeightPyramid<T>& field, ReliefSurface surface,
              std::span<const FieldRay> rays, std::span<FieldHit> hits) {
    assert(hits.size() >= rays.size());
    LaneRays<T> block;
    LaneHits<T> found;
    RayStart<T> starts[kLaneRays];
    std::size_t number[kLaneRays];
    for (std::size_t begin = 0; begin < rays.size();) {
        block.count = 0;
        std::size_t k = begin;
        for (; k < rays.size() && block.count < kLaneRays; ++k) {
            const RayStart<T> start = StartOf(field, surface, rays[k]);
            if (start.decided) {
                hits[k] = start.hit;
                continue;
            }
            starts[block.count] = start, number[block.count] = k;
            block.Add(start);
        }
        begin = k;
        RunOnAnyMachine(field, surface, true, block, found);
        for (std::size_t n = 0; n < block.count; ++n) {
            FieldHit& hit = hits[number[n]];
            if (!found.met[n]) {
                hit = {starts[n].ends_lost ? kLost : kSky, 0};
                continue;
            }
            const int upper = surface == ReliefSurface::kTriangles ? found.upper[n]
                              : field.Falling()                    ? 1
                                                                   : 0;
            hit = {field.FacetNumber(found.i[n], found.j[n], upper),
                   starts[n].t_before + double(found.t[n])};
        }
    }
}

template <class T>
void MeetFromPoint(const HeightPyramid<T>& field, ReliefSurface surface, const FieldRay& point,
                   std::span<const Vec3f> directions, std::span<std::uint64_t> met) {
    assert(met.size() >= (directions.size() + 63) / 64);
    assert(point.facet != FieldRay::kNoFacet);
    std::ranges::fill(met, 0);
    LaneRays<T> block;
    LaneHits<T> found;
    const PointStart<T> start(field, surface, point);
    for (std::size_t begin = 0; begin < directions.size(); begin += kLaneRays) {
        block.count = 0;
        const std::size_t end = std::min(directions.size(), begin + kLaneRays);
        start.AddAll(directions.subspan(begin, end - begin), block);
        RunOnAnyMachine(field, surface, false, block, found);
        for (std::size_t n = 0; n < block.count; ++n) {
            const bool counts = found.met[n] || block.ends_lost[n];
            met[(begin + n) / 64] |= std::uint64_t(counts) << ((begin + n) % 64);
        }
    }
}

template void CastRays(const HeightPyramid<float>&, ReliefSurface, std::span<const FieldRay>,
                       std::span<FieldHit>);
template void CastRays(const HeightPyramid<double>&, ReliefSurface, std::span<const FieldRay>,
                       std::span<FieldHit>);
template void MeetFromPoint(const HeightPyramid<float>&, ReliefSurface, const FieldRay&,
                            std::span<const Vec3f>, std::span<std::uint64_t>);
template void MeetFromPoint(const HeightPyramid<double>&, ReliefSurface, const FieldRay&,
                            std::span<const Vec3f>, std::span<std::uint64_t>);

}  // namespace plumb

#endif
