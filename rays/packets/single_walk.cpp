#include "rays/packets/single_walk.h"

#include <algorithm>

#include "core/surface.h"
#include "rays/packets/pluecker_test.h"
#include "rays/packets/projected_test.h"

namespace plumb {
namespace {

struct Best {
    float t;
    std::uint32_t triangle = Hit::kNone;
    float b_1 = 0, b_2 = 0;
};

// Returns whether the ray has found enough.
template <class Test, bool kAny>
bool TestLeaf(const PacketScene& scene, const BspNode& leaf, const WalkRay& ray,
              const Test& test, Mailboxes& mailboxes, WalkCounts& counts, Best& best) {
    for (std::uint32_t i = 0; i < leaf.Count(); ++i) {
        const std::uint32_t place = scene.Place(leaf, i);
        if (scene.mailboxes && mailboxes.WereTested(place)) continue;
        ++counts.tests;
        const TriangleRecord& record = scene.records[place];
        Meeting at;
        if (!test.Meets(record, at) || !(at.t >= ray.near)) continue;
        if (!(at.t < best.t || (at.t == best.t && record.id < best.triangle))) continue;
        if (record.holes && !IsSolidAt(*scene.holes, record.id, double(at.b_1), double(at.b_2)))
            continue;
        best = {at.t, record.id, at.b_1, at.b_2};
        if (kAny) return true;
    }
    return false;
}

template <class Test, bool kAny>
Best Walk(const PacketScene& scene, const WalkRay& ray, Mailboxes& mailboxes,
          WalkCounts& counts) {
    struct Later {
        std::uint32_t node;
        float begin, end;
    };
    std::array<Later, BspTree::kMostDepth + 1> later;
    int waiting = 0;
    Best best{.t = ray.far};
    if (!ray.EntersBox()) return best;
    mailboxes.Next();
    const Test test(ray.origin_m, ray.direction);
    const BspNode* const nodes = scene.tree.nodes.data();
    std::uint32_t at = 0;
    float begin = ray.begin, end = ray.end;
    for (;;) {
        ++counts.nodes;
        const BspNode node = nodes[at];
        if (!node.IsLeaf()) {
            const std::size_t k = node.Axis();
            const float t = (node.SplitM() - ray.origin_m[k]) * ray.inverse[k];
            const float near_end = std::min(end, t + ray.margin[k]);
            const float far_begin = std::max(begin, t - ray.margin[k]);
            const std::uint32_t right_first = (ray.kind >> k) & 1;
            at = node.Left() + right_first;
            if (!(far_begin <= end)) continue;
            if (!(begin <= near_end)) {
                at ^= 1;
                continue;
            }
            later[std::size_t(waiting++)] = {at ^ 1, far_begin, end};
            end = near_end;
            continue;
        }
        ++counts.leaves;
        if (TestLeaf<Test, kAny>(scene, node, ray, test, mailboxes, counts, best)) return best;
        do {
            if (waiting == 0) return best;
            const Later& next = later[std::size_t(--waiting)];
            at = next.node;
            begin = next.begin;
            end = std::min(next.end, best.t);
        } while (!(begin <= end));
    }
}

template <bool kAny>
Best WalkBy(const PacketScene& scene, const WalkRay& ray, Mailboxes& mailboxes,
            WalkCounts& counts) {
    switch (scene.test) {
        case TriangleTest::kPluecker:
            return Walk<PlueckerTest, kAny>(scene, ray, mailboxes, counts);
        case TriangleTest::kProjected:
            return Walk<ProjectedTest, kAny>(scene, ray, mailboxes, counts);
        case TriangleTest::kWatertight:
            break;
    }
    return Walk<WatertightTest, kAny>(scene, ray, mailboxes, counts);
}

}  // namespace

Hit ClosestOfSingle(const PacketScene& scene, const WalkRay& ray, Mailboxes& mailboxes,
                    WalkCounts& counts) {
    const Best best = WalkBy<false>(scene, ray, mailboxes, counts);
    if (best.triangle == Hit::kNone) return {};
    return {best.triangle, best.b_1, best.b_2, best.t * ray.per_length};
}

bool AnyOfSingle(const PacketScene& scene, const WalkRay& ray, Mailboxes& mailboxes,
                 WalkCounts& counts) {
    return WalkBy<true>(scene, ray, mailboxes, counts).triangle != Hit::kNone;
}

}  // namespace plumb
