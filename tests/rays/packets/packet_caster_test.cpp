#include "rays/packets/packet_caster.h"

#include <gmock/gmock.h>

#include <cstring>

#include "core/error.h"
#include "rays/packets/packet_walk.h"
#include "rays/packets/projected_test.h"
#include "tests/rays/packets/brute_force.h"
#include "tests/rays/packets/shapes.h"

namespace plumb {
namespace {

struct Case {
    const char* name;
    Mesh mesh;
};

std::vector<Case> StrainedMeshes() {
    return {{"soup", Soup(150, 0.6)},
            {"small soup", Soup(600, 0.1)},
            {"hills", Hills(12)},
            {"fence", FenceAndFloor()},
            {"sliver ball", SliverBall(4, 60)},
            {"plane", Sheet(10, [](double, double) { return 0.25; })},
            {"hills at 1e6", Moved(Sheet(10, [](double x, double y) { return x * y; }), 1e6)},
            {"soup at 1000", Moved(Soup(150, 0.6), 1000)}};
}

bool SameBits(const Hit& a, const Hit& b) {
    return a.triangle == b.triangle && std::memcmp(&a.t, &b.t, 4) == 0 &&
           (!a.Met() || (a.b_1 == b.b_1 && a.b_2 == b.b_2));
}

std::string Told(const Hit& hit) {
    return std::to_string(hit.triangle) + " at " + std::to_string(hit.t);
}

std::vector<Hit> ClosestOf(const PacketCaster& caster, const std::vector<Ray>& rays) {
    std::vector<Hit> hits(rays.size());
    caster.Closest(rays, hits);
    return hits;
}

std::vector<std::uint64_t> AnyOf(const PacketCaster& caster, const std::vector<Ray>& rays) {
    std::vector<std::uint64_t> met(BitWords(rays.size()), ~std::uint64_t{0});
    caster.Any(rays, met);
    return met;
}

// Expected: the least (t, triangle) over all triangles by the same test, bit for bit. No
// tolerance: the walk's margin pays for all rounding (rays/packets/walk_ray.h).
TEST(PacketCaster, MeetsWhatALoopOverAllTrianglesMeets) {
    for (const Case& one : StrainedMeshes()) {
        const std::vector<Ray> rays = RaysAt(one.mesh, 6000, 21);
        std::vector<Hit> expected;
        int met = 0;
        for (const Ray& ray : rays) {
            expected.push_back(NearestOfAll<WatertightTest>(one.mesh, ray));
            met += expected.back().Met();
        }
        EXPECT_GT(met, 1000) << one.name;
        for (const int together : {1, 16}) {
            const PacketCaster caster(one.mesh, {.rays = together});
            const std::vector<Hit> hits = ClosestOf(caster, rays);
            const std::vector<std::uint64_t> any = AnyOf(caster, rays);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                ASSERT_TRUE(SameBits(hits[i], expected[i]))
                    << one.name << ", ray " << i << ": " << Told(hits[i])
                    << ", all: " << Told(expected[i]);
                ASSERT_EQ((any[i / 64] >> (i % 64)) & 1, expected[i].Met() ? 1u : 0u)
                    << one.name << ", ray " << i;
            }
        }
    }
}

// A packet of any size, on any number of lanes, by any test, gives the bits of its rays alone.
TEST(PacketCaster, APacketGivesTheBitsOfItsSingleRays) {
    for (const Case& one : StrainedMeshes()) {
        // Not a multiple of any packet.
        const std::vector<Ray> rays = RaysAt(one.mesh, 6011, 22);
        for (const TriangleTest test :
             {TriangleTest::kWatertight, TriangleTest::kPluecker, TriangleTest::kProjected}) {
            const PacketCaster single(one.mesh, {.test = test, .rays = 1});
            const std::vector<Hit> hits = ClosestOf(single, rays);
            const std::vector<std::uint64_t> any = AnyOf(single, rays);
            for (const int together : {4, 16, 64}) {
                for (const int lanes : {4, 8, 16}) {
                    const PacketCaster packets(
                        one.mesh, {.test = test, .rays = together, .lanes = lanes});
                    const std::vector<Hit> others = ClosestOf(packets, rays);
                    for (std::size_t i = 0; i < rays.size(); ++i) {
                        ASSERT_TRUE(SameBits(hits[i], others[i]))
                            << one.name << ", test " << int(test) << ", " << together << " on "
                            << lanes << ", ray " << i << ": " << Told(hits[i]) << ", together "
                            << Told(others[i]);
                    }
                    ASSERT_EQ(any, AnyOf(packets, rays)) << one.name << int(test) << together;
                }
            }
        }
    }
}

// What is asked of the lanes is what ReadyToWalk says, bit for bit, rays that are not to walk
// among them.
TEST(Packet, IsMadeReadyAsSingleRaysAre) {
    if (MostLanes() < 4) GTEST_SKIP() << "a machine without lanes";
    const Mesh mesh = Soup(50, 0.5);
    std::vector<Ray> rays = RaysAt(mesh, 64 * 40, 23);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < rays.size(); i += 5) {
        const float odd[] = {nan, infinity, -infinity, 0, -0.0f, 1e-45f, 3e38f, 1e-25f, 2e18f};
        const float value = odd[i / 5 % 9];
        Ray& ray = rays[i];
        const std::size_t field = i / 45 % 5;
        if (field == 0) ray.near = value;
        if (field == 1) ray.far = value;
        if (field == 2) ray.origin_m[int(i % 3)] = value;
        if (field == 3) ray.direction[int(i % 3)] = value;
        if (field == 4) ray.direction.setConstant(value);
    }
    const BspBox box{{0, 0, 0}, {1.5f, 1.25f, 1}};
    int enter = 0, unfit = 0;
    for (std::size_t begin = 0; begin < rays.size(); begin += 64) {
        Packet packet;
        packet.rays = 64;
        for (std::size_t i = 0; i < 64; ++i) packet.Put(i, rays[begin + i]);
        const std::uint64_t bits = MakeReady(box, packet);
        for (std::size_t i = 0; i < 64; ++i) {
            const WalkRay ray = ReadyToWalk(rays[begin + i], box);
            ASSERT_EQ((bits >> i) & 1, ray.EntersBox() ? 1u : 0u) << "ray " << begin + i;
            unfit += !ray.EntersBox();
            if (!ray.EntersBox()) continue;
            ++enter;
            EXPECT_EQ(packet.kinds[i], ray.kind);
            EXPECT_EQ(packet.near[i], ray.near);
            EXPECT_EQ(packet.best[i], ray.far);
            EXPECT_EQ(packet.begin[i], ray.begin);
            EXPECT_EQ(packet.end[i], ray.end);
            EXPECT_EQ(packet.per_length[i], ray.per_length);
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_EQ(packet.direction[k][i], ray.direction[k]);
                EXPECT_EQ(packet.inverse[k][i], ray.inverse[k]);
                EXPECT_EQ(packet.margin[k][i], ray.margin[k]);
            }
        }
    }
    EXPECT_GT(enter, 1000);
    EXPECT_GT(unfit, 200);
}

TEST(PacketCaster, OnePointAsksTheSameAsManyRays) {
    const PacketCaster caster(Soup(200, 0.3));
    Ray common;
    common.origin_m = {0.5f, 0.6f, 0.4f};
    common.far = 0.5f;
    std::vector<Vec3f> directions;
    std::vector<Ray> rays;
    for (std::uint64_t i = 0; i < 1000; ++i) {
        directions.push_back((RandomPoint(8, i, 0) - Vec3::Constant(0.5)).cast<float>());
        rays.push_back(common);
        rays.back().direction = directions.back();
    }
    std::vector<std::uint64_t> from(BitWords(1000), ~std::uint64_t{0});
    caster.AnyFromPoint(common, directions, from);
    EXPECT_EQ(from, AnyOf(caster, rays));
    EXPECT_EQ(from.back() >> (1000 % 64), 0u);
    const int met = int(std::popcount(from[0]) + std::popcount(from[7]));
    EXPECT_GT(met, 10);
    EXPECT_LT(met, 118);
}

// Expected: mailboxes spare tests and change no bit.
TEST(PacketCaster, MailboxesOnlySpareTests) {
    const Mesh mesh = Soup(400, 0.5);
    const std::vector<Ray> rays = RaysAt(mesh, 4000, 24);
    for (const int together : {1, 16}) {
        const PacketCaster with(mesh, {.rays = together});
        const PacketCaster without(mesh, {.rays = together, .mailboxes = false});
        std::vector<Hit> a(rays.size()), b(rays.size());
        const WalkCounts spared = with.CountedClosest(rays, a);
        const WalkCounts all = without.CountedClosest(rays, b);
        for (std::size_t i = 0; i < rays.size(); ++i) ASSERT_TRUE(SameBits(a[i], b[i])) << i;
        EXPECT_LT(spared.tests, 0.9 * double(all.tests));
        EXPECT_EQ(spared.nodes, all.nodes);
        EXPECT_EQ(spared.leaves, all.leaves);
    }
}

// Expected, by hand: the fence's texture has stripes as wide as its holes, 2 u in (2k, 2k + 1)
// solid; behind it is a board without holes.
TEST(PacketCaster, SeesThroughHoles) {
    Scene scene;
    AddFace(scene.mesh, {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}});
    AddFace(scene.mesh, {{0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}});
    scene.mesh.uvs = {{0, 0}, {3, 0}, {3, 1}, {0, 1}, {0, 0}, {3, 0}, {3, 1}, {0, 1}};
    scene.material_of_face = {0, 1};
    scene.materials = {{.name = "fence", .texture = 0, .alpha_tested = true},
                       {.name = "board", .texture = 0}};
    Texture stripes{.name = "", .albedo = Image<Rgb>(2, 1, Rgb{1, 1, 1}), .opacity = {}};
    stripes.opacity = Image<float>(2, 1);
    stripes.opacity(0, 0) = 1;
    scene.textures = {stripes};
    std::vector<Ray> rays;
    std::vector<bool> solid;
    for (std::uint64_t i = 0; i < 4000; ++i) {
        const Vec3 p = RandomPoint(3, i, 0);
        const double stripe = std::fmod(6 * p.x(), 2);
        if (std::abs(stripe - std::round(stripe)) < 6e-3) continue;
        Ray ray;
        ray.origin_m = Vec3(p.x(), p.y(), 0).cast<float>();
        rays.push_back(ray);
        solid.push_back(stripe < 1);
    }
    for (const int together : {1, 16}) {
        const PacketCaster caster(scene, {.rays = together});
        const std::vector<Hit> hits = ClosestOf(caster, rays);
        int through = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            ASSERT_TRUE(hits[i].Met());
            ASSERT_EQ(hits[i].triangle / 2, solid[i] ? 0u : 1u) << rays[i].origin_m.transpose();
            ASSERT_EQ(hits[i].t, solid[i] ? 1 : 2);
            through += !solid[i];
        }
        EXPECT_GT(through, 1000);
        for (Ray& ray : rays) ray.far = 1.5f;
        const std::vector<std::uint64_t> any = AnyOf(caster, rays);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            ASSERT_EQ((any[i / 64] >> (i % 64)) & 1, solid[i] ? 1u : 0u);
        }
        for (Ray& ray : rays) ray.far = std::numeric_limits<float>::infinity();
    }
}

TEST(PacketCaster, OfNothingIsOpenSky) {
    Mesh points;
    for (int i = 0; i < 20; ++i) AddFace(points, {{1, 2, 3}, {1, 2, 3}, {2, 4, 6}});
    for (const Mesh& mesh : {Mesh{}, points}) {
        const PacketCaster caster(mesh);
        EXPECT_EQ(caster.Counts().triangles, 0);
        EXPECT_EQ(caster.Counts().zero_area, std::int64_t(mesh.quads.size()));
        const std::vector<Ray> rays(100);
        for (const Hit& hit : ClosestOf(caster, rays)) EXPECT_FALSE(hit.Met());
        for (const std::uint64_t word : AnyOf(caster, rays)) EXPECT_EQ(word, 0u);
    }
}

// Expected: one triangle is met; of 1e5 copies the first.
TEST(PacketCaster, OfCopiesNamesTheFirst) {
    for (const int copies : {1, 100'000}) {
        Mesh mesh;
        AddFace(mesh, {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}});
        mesh.quads.resize(std::size_t(copies), mesh.quads[0]);
        const PacketCaster caster(mesh);
        EXPECT_LE(caster.Size().entries, copies);
        Ray ray;
        ray.origin_m = {0.25f, 0.5f, 0};
        for (const Hit& hit : ClosestOf(caster, std::vector<Ray>(17, ray))) {
            EXPECT_EQ(hit.triangle, 0u);
            EXPECT_EQ(hit.t, 1);
            EXPECT_EQ(hit.b_1, 0.25f);
            EXPECT_EQ(hit.b_2, 0.5f);
        }
    }
}

TEST(PacketCaster, RefusesBadMeshesAndOptionsByName) {
    const auto message = [](const Mesh& mesh, const PacketOptions& options) {
        try {
            const PacketCaster caster(mesh, options);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    Mesh mesh, nan;
    AddFace(mesh, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
    nan = mesh;
    nan.vertices_m[2].y() = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(message(nan, {}), testing::StartsWith("mesh: vertices_m[2].y = nan, must be"));
    EXPECT_EQ(message(mesh, {.rays = 5}), "PacketOptions::rays = 5, must be 1, 4, 16 or 64");
    EXPECT_EQ(message(mesh, {.lanes = 32}), "PacketOptions::lanes = 32, must be 4, 8 or 16");
    EXPECT_EQ(message(mesh, {.build = {.costs = {.step = 0}}}),
              "PacketOptions::build.costs.step = 0, must be > 0");
}

// Rays from within a closed ball of slivers, at points, at edges and at corners.
// Expected: each meets it.
TEST(PacketCaster, NoRayLeavesAClosedBallOfSlivers) {
    for (const double at_m : {0.0, 30.0}) {
        const Mesh mesh = Moved(SliverBall(3, 5'000), at_m);
        const PacketCaster caster(mesh);
        std::vector<Ray> rays;
        for (std::uint64_t i = 0; i < 100'000; ++i) {
            Ray ray;
            ray.origin_m = (at_m * Vec3(1, -0.7, 0.4) + 0.3 * RandomPoint(9, i / 16, 0) +
                            0.01 * RandomPoint(9, i, 0))
                               .cast<float>();
            // At the poles 5000 slivers meet: few rays there, of the first and last ring.
            const std::size_t faces = mesh.quads.size();
            const auto& face =
                i % 100 == 0 ? mesh.quads[RandomBits(9, i, 1, 0) % faces]
                             : mesh.quads[faces / 3 + RandomBits(9, i, 1, 0) % (faces / 3)];
            const std::uint64_t side = i % 4;
            const Vec3f& p = mesh.vertices_m[face[side == 3 ? 1 : side]];
            const Vec3f& q = mesh.vertices_m[face[side == 3 ? 3 : side + 1]];
            const float along = i % 3 == 0 ? 0.0f : float(RandomUnit(9, i, 1, 2));
            ray.direction = p + along * (q - p) - ray.origin_m;
            rays.push_back(ray);
        }
        const std::vector<std::uint64_t> any = AnyOf(caster, rays);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            ASSERT_TRUE((any[i / 64] >> (i % 64)) & 1)
                << "ray " << i << " at " << at_m << ": " << rays[i].direction.transpose();
        }
    }
}

}  // namespace
}  // namespace plumb
