#include "rays/packets/packet_walk.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cassert>
#include <limits>

#include "core/surface.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rays/packets/packet_walk.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace plumb::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_SCALAR

// Without lanes there are no packets: see MostLanes().
void Closest(const PacketScene&, int, Packet&, Mailboxes&, WalkCounts&) {
    assert(false);
}
void Any(const PacketScene&, int, Packet&, Mailboxes&, WalkCounts&) {
    assert(false);
}

#else

#include "rays/packets/lane_tests.inc"

// kVectors of D hold the packet; 0: as many as it takes.
template <class D, int kVectors, template <class> class Test, bool kAny>
class Walk {
    using V = hn::Vec<D>;
    using M = hn::Mask<D>;
    using U = hn::RebindToUnsigned<D>;
    static constexpr std::size_t kLanes = hn::MaxLanes(D());
    static constexpr std::size_t kMostVectors = kVectors > 0 ? std::size_t(kVectors)
                                                             : Packet::kMost / kLanes;

  public:
    Walk(const PacketScene& scene, Packet& packet, Mailboxes& mailboxes, WalkCounts& counts)
        : scene_(scene),
          packet_(packet),
          mailboxes_(mailboxes),
          counts_(counts),
          test_(packet),
          vectors_(kVectors > 0 ? std::size_t(kVectors) : std::size_t(packet.rays) / kLanes) {}

    HWY_INLINE void Run() {
        mailboxes_.Next();
        const D d;
        const BspNode* const nodes = scene_.tree.nodes.data();
        Later part;  // What lies in the cell at hand.
        M any = hn::FirstN(d, 0);
        for (std::size_t v = 0; v < vectors_; ++v) {
            part.begin[v] = hn::Load(d, packet_.begin.data() + v * kLanes);
            part.end[v] = hn::Load(d, packet_.end.data() + v * kLanes);
            any = hn::Or(any, hn::Le(part.begin[v], part.end[v]));
        }
        if (hn::AllFalse(d, any)) return;
        part.node = 0;
        std::size_t waiting = 0;
        std::int64_t visited = 0, leaves = 0;
        for (;;) {
            ++visited;
            const BspNode node = nodes[part.node];
            if (!node.IsLeaf()) {
                const std::size_t k = node.Axis();
                const V at = hn::Set(d, node.SplitM());
                Later& far = later_[waiting];
                std::array<V, kMostVectors> near_end;
                M to_near = hn::FirstN(d, 0), to_far = to_near;
                for (std::size_t v = 0; v < vectors_; ++v) {
                    const std::size_t i = v * kLanes;
                    const V o = hn::Load(d, packet_.origin_m[k].data() + i);
                    const V inverse = hn::Load(d, packet_.inverse[k].data() + i);
                    const V margin = hn::Load(d, packet_.margin[k].data() + i);
                    const V t = hn::Mul(hn::Sub(at, o), inverse);
                    near_end[v] = hn::Min(part.end[v], hn::Add(t, margin));
                    far.begin[v] = hn::Max(part.begin[v], hn::Sub(t, margin));
                    to_near = hn::Or(to_near, hn::Le(part.begin[v], near_end[v]));
                    to_far = hn::Or(to_far, hn::Le(far.begin[v], part.end[v]));
                }
                part.node = node.Left() + std::uint32_t(packet_.IsNegative(k));
                if (hn::AllFalse(d, to_far)) continue;
                if (hn::AllFalse(d, to_near)) {
                    part.node ^= 1;
                    continue;
                }
                far.node = part.node ^ 1;
                FetchAhead(nodes[far.node]);
                for (std::size_t v = 0; v < vectors_; ++v) {
                    far.end[v] = part.end[v];
                    part.end[v] = near_end[v];
                }
                ++waiting;
                continue;
            }
            ++leaves;
            if (node.Count() > 0) TestLeaf(node, part);
            M left;
            do {
                if (waiting == 0) {
                    counts_.nodes += visited;
                    counts_.leaves += leaves;
                    return;
                }
                const Later& next = later_[--waiting];
                part.node = next.node;
                left = hn::FirstN(d, 0);
                for (std::size_t v = 0; v < vectors_; ++v) {
                    part.begin[v] = next.begin[v];
                    part.end[v] =
                        hn::Min(next.end[v], hn::Load(d, packet_.best.data() + v * kLanes));
                    left = hn::Or(left, hn::Le(part.begin[v], part.end[v]));
                }
            } while (hn::AllFalse(d, left));
        }
    }

  private:
    struct Later {
        std::array<V, kMostVectors> begin, end;
        std::uint32_t node;
    };

    HWY_INLINE static std::uint64_t BitsOf(M mask) {
        std::uint64_t bits = 0;
        hn::StoreMaskBits(D(), mask, reinterpret_cast<std::uint8_t*>(&bits));
        return bits;
    }

    // Begins to load what a node that is put off points to; the node itself came with its
    // sibling.
    HWY_INLINE void FetchAhead(const BspNode& node) const {
        if (!node.IsLeaf()) {
            hwy::Prefetch(scene_.tree.nodes.data() + node.Left());
        } else if (node.IsRun()) {
            hwy::Prefetch(scene_.records.data() + node.First());
        } else {
            hwy::Prefetch(scene_.tree.lists.data() + node.First());
        }
    }

    HWY_INLINE void TestLeaf(const BspNode& leaf, const Later& part) {
        const D d;
        const std::uint32_t count = leaf.Count();
        const TriangleRecord* const records = scene_.records.data();
        for (std::uint32_t i = 0; i < count; ++i)
            hwy::Prefetch(records + scene_.Place(leaf, i));
        std::uint64_t rays = 0;
        std::array<M, kMostVectors> active;
        for (std::size_t v = 0; v < vectors_; ++v) {
            active[v] = hn::Le(part.begin[v], part.end[v]);
            if (scene_.mailboxes) rays |= BitsOf(active[v]) << (v * kLanes);
        }
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t place = scene_.Place(leaf, i);
            if (scene_.mailboxes && mailboxes_.WereTested(place, rays)) continue;
            ++counts_.tests;
            const TriangleRecord& record = records[place];
            for (std::size_t v = 0; v < vectors_; ++v) {
                if (kVectors != 1 && hn::AllFalse(d, active[v])) continue;
                LaneMeeting<D> at;
                if (test_.Meets(record, v * kLanes, active[v], at)) Take(record, v, at);
            }
        }
    }

    HWY_INLINE void Take(const TriangleRecord& record, std::size_t v,
                         const LaneMeeting<D>& at) {
        const D d;
        const U u;
        const std::size_t i = v * kLanes;
        const V near = hn::Load(d, packet_.near.data() + i);
        const V best = hn::Load(d, packet_.best.data() + i);
        const auto id = hn::Set(u, record.id);
        const auto triangle = hn::Load(u, packet_.triangle.data() + i);
        const M nearer =
            hn::Or(hn::Lt(at.t, best),
                   hn::And(hn::Eq(at.t, best), hn::RebindMask(d, hn::Lt(id, triangle))));
        M taken = hn::And(at.meets, hn::And(hn::Le(near, at.t), nearer));
        if (hn::AllFalse(d, taken)) return;
        if (record.holes) taken = Solid(record, at, taken);
        hn::Store(hn::IfThenElse(hn::RebindMask(u, taken), id, triangle), u,
                  packet_.triangle.data() + i);
        if constexpr (kAny) {
            const V met = hn::Set(d, -std::numeric_limits<float>::infinity());
            hn::Store(hn::IfThenElse(taken, met, best), d, packet_.best.data() + i);
        } else {
            hn::Store(hn::IfThenElse(taken, at.t, best), d, packet_.best.data() + i);
            const V b_1 = hn::Load(d, packet_.b_1.data() + i);
            const V b_2 = hn::Load(d, packet_.b_2.data() + i);
            hn::Store(hn::IfThenElse(taken, at.b_1, b_1), d, packet_.b_1.data() + i);
            hn::Store(hn::IfThenElse(taken, at.b_2, b_2), d, packet_.b_2.data() + i);
        }
    }

    // Those of `taken` where the surface has no hole.
    HWY_NOINLINE M Solid(const TriangleRecord& record, const LaneMeeting<D>& at,
                         M taken) const {
        const D d;
        alignas(64) std::array<float, 16> b_1, b_2, solid;
        hn::Store(at.b_1, d, b_1.data());
        hn::Store(at.b_2, d, b_2.data());
        const std::uint64_t bits = BitsOf(taken);
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const bool is_solid =
                ((bits >> lane) & 1) &&
                IsSolidAt(*scene_.holes, record.id, double(b_1[lane]), double(b_2[lane]));
            solid[lane] = is_solid ? 1.0f : 0.0f;
        }
        return hn::Gt(hn::Load(d, solid.data()), hn::Zero(d));
    }

    const PacketScene& scene_;
    Packet& packet_;
    Mailboxes& mailboxes_;
    WalkCounts& counts_;
    const Test<D> test_;
    const std::size_t vectors_;
    std::array<Later, BspTree::kMostDepth + 1> later_;
};

template <class D, template <class> class Test, bool kAny>
void WalkOnLanes(const PacketScene& scene, Packet& packet, Mailboxes& mailboxes,
                 WalkCounts& counts) {
    if (std::size_t(packet.rays) == hn::MaxLanes(D())) {
        Walk<D, 1, Test, kAny>(scene, packet, mailboxes, counts).Run();
    } else {
        Walk<D, 0, Test, kAny>(scene, packet, mailboxes, counts).Run();
    }
}

template <template <class> class Test, bool kAny>
void WalkBy(const PacketScene& scene, int lanes, Packet& packet, Mailboxes& mailboxes,
            WalkCounts& counts) {
    const int most = std::min(lanes, packet.rays);
#if HWY_MAX_BYTES >= 64
    if (most >= 16) {
        WalkOnLanes<hn::CappedTag<float, 16>, Test, kAny>(scene, packet, mailboxes, counts);
        return;
    }
#endif
#if HWY_MAX_BYTES >= 32
    if (most >= 8) {
        WalkOnLanes<hn::CappedTag<float, 8>, Test, kAny>(scene, packet, mailboxes, counts);
        return;
    }
#endif
    WalkOnLanes<hn::CappedTag<float, 4>, Test, kAny>(scene, packet, mailboxes, counts);
}

template <bool kAny>
void WalkByTest(const PacketScene& scene, int lanes, Packet& packet, Mailboxes& mailboxes,
                WalkCounts& counts) {
    switch (scene.test) {
        case TriangleTest::kWatertight:
            WalkBy<LaneWatertight, kAny>(scene, lanes, packet, mailboxes, counts);
            break;
        case TriangleTest::kPluecker:
            WalkBy<LanePluecker, kAny>(scene, lanes, packet, mailboxes, counts);
            break;
        case TriangleTest::kProjected:
            WalkBy<LaneProjected, kAny>(scene, lanes, packet, mailboxes, counts);
            break;
    }
}

void Closest(const PacketScene& scene, int lanes, Packet& packet, Mailboxes& mailboxes,
             WalkCounts& counts) {
    WalkByTest<false>(scene, lanes, packet, mailboxes, counts);
}

void Any(const PacketScene& scene, int lanes, Packet& packet, Mailboxes& mailboxes,
         WalkCounts& counts) {
    WalkByTest<true>(scene, lanes, packet, mailboxes, counts);
}

#endif

}  // namespace
}  // namespace plumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace plumb {
namespace {

HWY_EXPORT(Closest);
HWY_EXPORT(Any);

}  // namespace

void ClosestOfPacket(const PacketScene& scene, int lanes, Packet& packet, Mailboxes& mailboxes,
                     WalkCounts& counts) {
    HWY_DYNAMIC_DISPATCH(Closest)(scene, lanes, packet, mailboxes, counts);
}

void AnyOfPacket(const PacketScene& scene, int lanes, Packet& packet, Mailboxes& mailboxes,
                 WalkCounts& counts) {
    HWY_DYNAMIC_DISPATCH(Any)(scene, lanes, packet, mailboxes, counts);
}

}  // namespace plumb

#endif
