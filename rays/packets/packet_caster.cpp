#include "rays/packets/packet_caster.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>

#include "core/error.h"
#include "core/surface.h"
#include "rays/packets/packet_walk.h"
#include "rays/packets/projected_test.h"
#include "rays/packets/single_walk.h"
#include "rays/triangle.h"

namespace plumb {
namespace {

// Fewer rays of a kind travel one by one.
constexpr int kFewest = 3;

// The rays of a span on their way: sorted into packets, each walked, answers handed out.
class Journey {
  public:
    Journey(const PacketScene& scene, const PacketOptions& options)
        : scene_(scene), options_(options) {}

    /// rays(i) is ray i of `count`; answer(i, hit or whether any) takes its answer.
    template <bool kAny, class Rays, class Answer>
    WalkCounts Go(std::size_t count, const Rays& rays, const Answer& answer) {
        if (options_.rays == 1 || MostLanes() < 4) {
            for (std::size_t i = 0; i < count; ++i) Single<kAny>(i, rays, answer);
            return counts_;
        }
        const std::size_t size = std::size_t(options_.rays);
        packet_.rays = options_.rays;
        for (std::size_t begin = 0; begin < count; begin += size) {
            const std::size_t together = std::min(size, count - begin);
            for (std::size_t i = 0; i < together; ++i) packet_.Put(i, rays(begin + i));
            for (std::size_t i = together; i < size; ++i) packet_.Put(i, kNobody);
            const std::uint64_t enter = MakeReady(scene_.tree.box, packet_);
            std::uint64_t singly = 0;
            if (enter != 0) singly = WalkByKind<kAny>(enter);
            for (std::size_t i = 0; i < together; ++i) {
                if ((singly >> i) & 1) {
                    Single<kAny>(begin + i, rays, answer);
                } else {
                    answer(begin + i, Found<kAny>(i));
                }
            }
        }
        return counts_;
    }

  private:
    static inline const Ray kNobody{.far = -1};

    // Returns those that are to travel one by one.
    template <bool kAny>
    std::uint64_t WalkByKind(std::uint64_t enter) {
        std::uint64_t alike = AlikeFirst(enter), singly = 0;
        if (alike == enter) {
            Walk<kAny>(alike);
            return 0;
        }
        const Packet::Each<float> end = packet_.end;
        for (std::uint64_t open = enter; open != 0; open &= ~alike) {
            alike = AlikeFirst(open);
            if (std::popcount(alike) < kFewest) {
                singly |= alike;
                continue;
            }
            for (std::size_t i = 0; i < std::size_t(packet_.rays); ++i) {
                packet_.end[i] =
                    (alike >> i) & 1 ? end[i] : -std::numeric_limits<float>::infinity();
            }
            Walk<kAny>(alike);
        }
        return singly;
    }

    // Those of `open` that are of the kind of its first.
    std::uint64_t AlikeFirst(std::uint64_t open) const {
        const std::uint32_t kind = packet_.kinds[std::size_t(std::countr_zero(open))];
        std::uint64_t alike = 0;
        for (std::size_t i = 0; i < std::size_t(packet_.rays); ++i) {
            alike |= std::uint64_t(packet_.kinds[i] == kind) << i;
        }
        return alike & open;
    }

    template <bool kAny>
    void Walk(std::uint64_t alike) {
        packet_.kind = packet_.kinds[std::size_t(std::countr_zero(alike))];
        if constexpr (kAny) {
            AnyOfPacket(scene_, options_.lanes, packet_, mailboxes_, counts_);
        } else {
            ClosestOfPacket(scene_, options_.lanes, packet_, mailboxes_, counts_);
        }
    }

    template <bool kAny>
    auto Found(std::size_t i) const {
        const bool met = packet_.triangle[i] != Hit::kNone;
        if constexpr (kAny) {
            return met;
        } else {
            return met ? Hit{packet_.triangle[i], packet_.b_1[i], packet_.b_2[i],
                             packet_.best[i] * packet_.per_length[i]}
                       : Hit{};
        }
    }

    template <bool kAny, class Rays, class Answer>
    void Single(std::size_t i, const Rays& rays, const Answer& answer) {
        const WalkRay ray = ReadyToWalk(rays(i), scene_.tree.box);
        if constexpr (kAny) {
            answer(i, AnyOfSingle(scene_, ray, mailboxes_, counts_));
        } else {
            answer(i, ClosestOfSingle(scene_, ray, mailboxes_, counts_));
        }
    }

    const PacketScene& scene_;
    const PacketOptions& options_;
    Mailboxes mailboxes_;
    WalkCounts counts_;
    Packet packet_;
};

// Leaves whose list counts up by ones need none. Lists of the others move together.
void MakeRuns(BspTree& tree) {
    std::vector<std::uint32_t> lists;
    for (BspNode& node : tree.nodes) {
        if (!node.IsLeaf()) continue;
        const std::span<const std::uint32_t> list(tree.lists.data() + node.First(),
                                                  node.Count());
        bool is_run = !list.empty();
        for (std::size_t i = 1; i < list.size(); ++i) is_run &= list[i] == list[i - 1] + 1;
        if (is_run) {
            node = BspNode::Run(list[0], node.Count());
        } else {
            node = BspNode::Leaf(std::uint32_t(lists.size()), node.Count());
            lists.insert(lists.end(), list.begin(), list.end());
        }
    }
    tree.lists = std::move(lists);
    tree.lists.shrink_to_fit();
}

template <class Rays>
WalkCounts FindAny(const PacketScene& scene, const PacketOptions& options, std::size_t count,
                   const Rays& rays, std::span<std::uint64_t> met) {
    assert(met.size() >= BitWords(count));
    std::ranges::fill(met, 0);
    return Journey(scene, options).Go<true>(count, rays, [&](std::size_t i, bool is_met) {
        met[i / 64] |= std::uint64_t(is_met) << (i % 64);
    });
}

}  // namespace

void Validate(const PacketOptions& options) {
    const auto check = [](bool fits, const char* field, double value, const char* rule) {
        if (!fits) throw Error(MustBe(std::string("PacketOptions::") + field, value, rule));
    };
    const int rays = options.rays, lanes = options.lanes;
    check(rays == 1 || rays == 4 || rays == 16 || rays == 64, "rays", rays, "1, 4, 16 or 64");
    check(lanes == 4 || lanes == 8 || lanes == 16, "lanes", lanes, "4, 8 or 16");
    const BspCosts& costs = options.build.costs;
    check(costs.step > 0, "build.costs.step", costs.step, "> 0");
    check(costs.test > 0, "build.costs.test", costs.test, "> 0");
    check(costs.empty >= 0 && costs.empty < 1, "build.costs.empty", costs.empty, "in [0, 1)");
    check(options.build.most_copies >= 1, "build.most_copies", options.build.most_copies,
          ">= 1");
}

PacketCaster::PacketCaster(const Mesh& mesh, const PacketOptions& options, Monitor& monitor)
    : PacketCaster(mesh, nullptr, options, monitor) {}

PacketCaster::PacketCaster(const Scene& scene, const PacketOptions& options, Monitor& monitor)
    : PacketCaster(scene.mesh, &scene, options, monitor) {}

PacketCaster::PacketCaster(const Mesh& mesh, const Scene* holes, const PacketOptions& options,
                           Monitor& monitor)
    : options_(options) {
    Validate(options);
    Validate(mesh);
    counts_.faces = std::int64_t(mesh.quads.size());
    std::vector<Corners> corners;
    std::vector<std::uint32_t> ids;
    corners.reserve(2 * mesh.quads.size());
    ids.reserve(2 * mesh.quads.size());
    for (std::uint32_t id = 0; id < 2 * mesh.quads.size(); ++id) {
        const std::array<std::uint32_t, 4>& face = mesh.quads[id / 2];
        if (id % 2 == 1 && face[2] == face[3]) continue;
        const Triangle triangle = TriangleOf(mesh, id);
        if (!(triangle.Cross().squaredNorm() > 0)) {
            ++counts_.zero_area;
            continue;
        }
        Corners& c = corners.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) c[i][std::size_t(k)] = float(triangle.corners_m[i][k]);
        }
        ids.push_back(id);
    }
    counts_.triangles = std::int64_t(ids.size());

    scene_.test = options.test;
    scene_.mailboxes = options.mailboxes;
    scene_.holes = holes;
    scene_.tree = BuildBspTree(corners, options.build, monitor);
    // Records in the order in which leaves name them first: what is near lies near.
    std::vector<std::uint32_t> place(ids.size(), Hit::kNone);
    scene_.records.reserve(ids.size());
    for (std::uint32_t& entry : scene_.tree.lists) {
        std::uint32_t& at = place[entry];
        if (at == Hit::kNone) {
            at = std::uint32_t(scene_.records.size());
            TriangleRecord record = options.test == TriangleTest::kProjected
                                        ? RecordOfPlanes(corners[entry])
                                        : RecordOfCorners(corners[entry]);
            record.id = ids[entry];
            record.holes = holes != nullptr && IsAlphaTested(*holes, record.id / 2) ? 1 : 0;
            scene_.records.push_back(record);
        }
        entry = at;
    }
    MakeRuns(scene_.tree);
}

WalkCounts PacketCaster::CountedClosest(std::span<const Ray> rays, std::span<Hit> hits) const {
    assert(hits.size() >= rays.size());
    return Journey(scene_, options_)
        .Go<false>(
            rays.size(), [&](std::size_t i) -> const Ray& { return rays[i]; },
            [&](std::size_t i, const Hit& hit) { hits[i] = hit; });
}

WalkCounts PacketCaster::CountedAny(std::span<const Ray> rays,
                                    std::span<std::uint64_t> met) const {
    return FindAny(
        scene_, options_, rays.size(), [&](std::size_t i) -> const Ray& { return rays[i]; },
        met);
}

void PacketCaster::Closest(std::span<const Ray> rays, std::span<Hit> hits) const {
    CountedClosest(rays, hits);
}

void PacketCaster::Any(std::span<const Ray> rays, std::span<std::uint64_t> met) const {
    CountedAny(rays, met);
}

void PacketCaster::AnyFromPoint(const Ray& common, std::span<const Vec3f> directions,
                                std::span<std::uint64_t> met) const {
    FindAny(
        scene_, options_, directions.size(),
        [&](std::size_t i) {
            Ray ray = common;
            ray.direction = directions[i];
            return ray;
        },
        met);
}

PacketTreeSize PacketCaster::Size() const {
    PacketTreeSize size;
    size.nodes = std::int64_t(scene_.tree.nodes.size()) - 1;
    size.leaves = (size.nodes + 1) / 2;
    size.entries = std::int64_t(scene_.tree.lists.size());
    size.bytes = std::int64_t(scene_.tree.nodes.size() * sizeof(BspNode) +
                              scene_.tree.lists.size() * sizeof(std::uint32_t) +
                              scene_.records.size() * sizeof(TriangleRecord));
    size.depth = scene_.tree.depth;
    return size;
}

}  // namespace plumb
