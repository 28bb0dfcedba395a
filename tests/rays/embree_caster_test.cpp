#include "rays/embree/embree_caster.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/conventions.h"
#include "core/error.h"
#include "core/random.h"
#include "core/warp.h"
#include "rays/leave_surface.h"
#include "rays/triangle.h"
#include "tests/truth/shapes.h"

namespace plumb {
namespace {

Vec3 RandomPoint(std::uint64_t seed, std::uint64_t i, std::uint64_t k) {
    return {RandomUnit(seed, i, k, 0), RandomUnit(seed, i, k, 1), RandomUnit(seed, i, k, 2)};
}

// Quads that are not flat and triangles, anywhere in the unit cube.
Mesh Soup(int faces) {
    Mesh mesh;
    for (int f = 0; f < faces; ++f) {
        const Vec3 at = RandomPoint(1, f, 0);
        const auto corner = [&](int k) -> Vec3 { return at + 0.5 * RandomPoint(1, f, k + 1); };
        if (f % 3 == 0) {
            AddTriangle(mesh, corner(0), corner(1), corner(2));
        } else {
            AddQuad(mesh, corner(0), corner(1), corner(2), corner(3));
        }
    }
    return mesh;
}

std::vector<Ray> RandomRays(int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        Ray ray;
        ray.origin_m = RandomPoint(2, i, 0).cast<float>();
        ray.direction = (RandomPoint(2, i, 1) - Vec3(0.5, 0.5, 0.5)).cast<float>();
        ray.far = i % 2 == 0 ? std::numeric_limits<float>::infinity() : 0.4f;
        rays.push_back(ray);
    }
    return rays;
}

struct Nearest {
    std::uint32_t triangle = Hit::kNone;
    double t = std::numeric_limits<double>::infinity();
    double edge_distance = 0;  // Of the nearest hit or miss: how clear the answer is.
};

// [Moeller97] in double over all triangles: nothing shared with Embree but the mesh.
Nearest ByHand(const Mesh& mesh, const Ray& ray) {
    Nearest nearest{.edge_distance = std::numeric_limits<double>::infinity()};
    const Vec3 o = ray.origin_m.cast<double>(), d = ray.direction.cast<double>();
    for (std::uint32_t i = 0; i < 2 * mesh.quads.size(); ++i) {
        if (i % 2 == 1 && mesh.quads[i / 2][2] == mesh.quads[i / 2][3]) continue;
        const auto [p] = TriangleOf(mesh, i);
        const Vec3 e1 = p[1] - p[0], e2 = p[2] - p[0], q = d.cross(e2);
        const double det = e1.dot(q);
        const Vec3 s = o - p[0], r = s.cross(e1);
        const double b_1 = s.dot(q) / det, b_2 = d.dot(r) / det, t = e2.dot(r) / det;
        const double inside = std::min({b_1, b_2, 1 - b_1 - b_2});
        nearest.edge_distance = std::min(
            {nearest.edge_distance, std::abs(inside), std::abs(t), std::abs(t - ray.far)});
        if (inside < 0 || t < 0 || t > ray.far || t >= nearest.t) continue;
        nearest.triangle = i;
        nearest.t = t;
    }
    return nearest;
}

// Expected: the nearest triangle by a loop over all of them in double. Tolerance: float
// coordinates of the order of 1 are off by 2^-24; rays that come nearer than 1e-5 to an edge or
// an end are left to either answer, and t is good to 1e-5 where the hit is not grazing.
TEST(EmbreeCaster, MeetsWhatALoopOverAllTrianglesMeets) {
    const Mesh mesh = Soup(60);
    const EmbreeCaster caster(mesh);
    const std::vector<Ray> rays = RandomRays(20000);
    std::vector<Hit> hits(rays.size());
    caster.Closest(rays, hits);
    int clear = 0, met = 0, second_halves = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Nearest expected = ByHand(mesh, rays[i]);
        if (expected.edge_distance < 1e-5) continue;
        ++clear;
        ASSERT_EQ(hits[i].triangle, expected.triangle) << "ray " << i;
        if (!hits[i].Met()) continue;
        ++met;
        second_halves += hits[i].triangle % 2;
        EXPECT_NEAR(hits[i].t, expected.t, 1e-3) << "ray " << i;
        // The barycentrics are those of the triangle named: they give the point on the ray.
        const Vec3 on_ray = (rays[i].origin_m + hits[i].t * rays[i].direction).cast<double>();
        const Vec3 on_triangle =
            TriangleOf(mesh, hits[i].triangle).PointM(hits[i].b_1, hits[i].b_2);
        EXPECT_LT((on_ray - on_triangle).norm(), 1e-3) << "ray " << i;
    }
    EXPECT_GT(clear, 19000);
    EXPECT_GT(met, 4000);
    EXPECT_GT(second_halves, 1000);
}

// Expected: the same bits by the three questions; all come from one tree.
TEST(EmbreeCaster, AnyAndClosestAgree) {
    const Mesh mesh = Soup(60);
    const EmbreeCaster caster(mesh);
    std::vector<Ray> rays = RandomRays(1000);
    for (Ray& ray : rays) {
        ray.origin_m = Vec3f(0.6f, 0.6f, 0.6f);
        ray.far = 0.4f;
    }
    std::vector<Hit> hits(rays.size());
    caster.Closest(rays, hits);
    std::vector<std::uint64_t> any(BitWords(rays.size()), ~std::uint64_t{0}), from = any;
    caster.Any(rays, any);
    std::vector<Vec3f> directions;
    for (const Ray& ray : rays) directions.push_back(ray.direction);
    caster.AnyFromPoint(rays[0], directions, from);
    EXPECT_EQ(any, from);
    int met = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const bool bit = (any[i / 64] >> (i % 64)) & 1;
        EXPECT_EQ(bit, hits[i].Met()) << "ray " << i;
        met += bit;
    }
    EXPECT_GT(met, 100);
    EXPECT_LT(met, 900);
    EXPECT_EQ(any.back() >> (rays.size() % 64), 0u);  // Bits beyond the last ray.

    EmbreeBareLoop bare(caster, rays);
    EXPECT_EQ(bare.Closest(0, rays.size()), met);
    EXPECT_EQ(bare.Any(0, rays.size()), met);
    EXPECT_EQ(bare.AnyStream(0, rays.size()), met);
}

// Expected: a texture of two texels, solid and hole, mixes to 1/2 half the way between their
// centres: what is solid are the stripes 2 u in (2 k, 2 k + 1) on the quad, and the same on the
// triangle beside it; the board behind the first quad has no holes. Rays within 1e-3 of an edge
// of a stripe are left to either answer.
TEST(EmbreeCaster, SeesThroughHoles) {
    Scene scene;
    AddQuad(scene.mesh, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1});
    AddTriangle(scene.mesh, {2, 0, 1}, {3, 0, 1}, {2, 1, 1});
    AddQuad(scene.mesh, {0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2});
    scene.mesh.uvs = {{0, 0}, {3, 0}, {3, 1}, {0, 1}, {0, 0}, {3, 0},
                      {0, 1}, {0, 0}, {3, 0}, {3, 1}, {0, 1}};
    scene.material_of_face = {0, 0, 1};
    scene.materials = {{.name = "fence", .texture = 0, .alpha_tested = true},
                       {.name = "board", .texture = 0}};
    Texture stripes{.name = "", .albedo = Image<Rgb>(2, 1, Rgb{1, 1, 1}), .opacity = {}};
    stripes.opacity = Image<float>(2, 1);
    stripes.opacity(0, 0) = 1;
    scene.textures = {stripes};
    const EmbreeCaster caster(scene);
    std::vector<Ray> rays;
    std::vector<std::uint32_t> expected;
    for (int i = 0; i < 4000; ++i) {
        const Vec3 p = RandomPoint(3, std::uint64_t(i), 0);
        const bool left = i % 2 == 0;
        if (!left && p.x() + p.y() > 0.999) continue;
        const double stripe = std::fmod(6 * p.x(), 2);
        if (std::abs(stripe - std::round(stripe)) < 6e-3) continue;
        Ray ray;
        ray.origin_m = Vec3(p.x() + (left ? 0 : 2), p.y(), 0).cast<float>();
        ray.far = left ? 5.0f : 1.5f;
        rays.push_back(ray);
        const std::uint32_t half = p.x() + p.y() > 1 ? 1 : 0;
        expected.push_back(stripe < 1 ? (left ? half : 2) : left ? 4 + half : Hit::kNone);
    }
    std::vector<Hit> hits(rays.size());
    caster.Closest(rays, hits);
    std::vector<std::uint64_t> met(BitWords(rays.size()));
    caster.Any(rays, met);
    int through = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const bool near_diagonal =
            i < rays.size() && std::abs(rays[i].origin_m.x() + rays[i].origin_m.y() - 1) < 1e-3;
        if (near_diagonal) continue;
        ASSERT_EQ(hits[i].triangle, expected[i]) << rays[i].origin_m.transpose();
        EXPECT_EQ((met[i / 64] >> (i % 64)) & 1, expected[i] == Hit::kNone ? 0u : 1u);
        through += expected[i] == Hit::kNone;
    }
    EXPECT_GT(through, 200);
    // From one point: the same question as Any.
    Ray common;
    common.origin_m = {2.5f, 0.3f, 0};
    common.far = 1.5f;
    std::vector<Vec3f> directions;
    std::vector<Ray> same;
    for (int i = 0; i < 1000; ++i) {
        const Vec3 w = RandomPoint(4, std::uint64_t(i), 0) - Vec3(0.5, 0.5, -0.5);
        directions.push_back(w.cast<float>());
        same.push_back(common);
        same.back().direction = directions.back();
    }
    std::vector<std::uint64_t> from(BitWords(1000)), any(BitWords(1000));
    caster.AnyFromPoint(common, directions, from);
    caster.Any(same, any);
    EXPECT_EQ(from, any);
}

TEST(EmbreeCaster, KeepsZeroAreaTrianglesOutAndCountsThem) {
    Mesh mesh;
    AddQuad(mesh, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    AddQuad(mesh, {0, 0, 1}, {0, 0, 1}, {1, 1, 1}, {0, 1, 1});  // First half has no area.
    AddQuad(mesh, {0, 0, 2}, {1, 0, 2}, {1, 0, 2}, {0, 1, 2});  // Second half has none.
    AddTriangle(mesh, {0, 0, 3}, {1, 1, 3}, {2, 2, 3});
    const EmbreeCaster caster(mesh);
    EXPECT_EQ(caster.Counts().faces, 4);
    EXPECT_EQ(caster.Counts().triangles, 4);
    EXPECT_EQ(caster.Counts().zero_area, 3);
    Ray down;
    down.origin_m = {0.4f, 0.5f, 1.5f};
    down.direction = {0, 0, -1};
    Ray up = down;
    up.direction = {0, 0, 1};
    std::array<Hit, 2> hits;
    caster.Closest(std::array{down, up}, hits);
    EXPECT_EQ(hits[0].triangle, 3u);
    EXPECT_EQ(hits[1].triangle, 4u);
}

TEST(EmbreeCaster, AnEmptyMeshIsOpenSky) {
    const EmbreeCaster caster{Mesh{}};
    std::array<Hit, 1> hit;
    caster.Closest(std::array{Ray{}}, hit);
    EXPECT_FALSE(hit[0].Met());
}

TEST(EmbreeCaster, RefusesBadMeshesByName) {
    const auto message = [](const Mesh& mesh) {
        try {
            const EmbreeCaster caster(mesh);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    Mesh mesh;
    AddQuad(mesh, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    Mesh nan = mesh, huge = mesh, index = mesh;
    nan.vertices_m[2].y() = std::numeric_limits<float>::quiet_NaN();
    huge.vertices_m[0].x() = 2e15f;
    index.quads[0][3] = 4;
    EXPECT_THAT(message(nan), testing::StartsWith("mesh: vertices_m[2].y = nan, must be"));
    EXPECT_THAT(message(huge),
                testing::StartsWith("mesh: vertices_m[0].x = 1999999973982208, must be"));
    EXPECT_EQ(message(index), "mesh: quads[0][3] = 4, must be < 4, the vertices");
}

// Rays from a convex mesh's inside that leave it pass between two triangles.
// Expected: none, aimed at random and aimed at the middle of edges; the mesh is ROBUST.
TEST(EmbreeCaster, NoRayPassesBetweenTwoTriangles) {
    Mesh mesh;
    constexpr int kRings = 40, kSegments = 80;
    for (int r = 0; r <= kRings; ++r) {
        for (int s = 0; s < kSegments; ++s) {
            const double theta = kPi * r / kRings, phi = 2 * kPi * s / kSegments;
            mesh.vertices_m.push_back(Vec3f(float(std::sin(theta) * std::cos(phi)),
                                            float(std::sin(theta) * std::sin(phi)),
                                            float(std::cos(theta))));
        }
    }
    for (std::uint32_t r = 0; r < kRings; ++r) {
        for (std::uint32_t s = 0; s < kSegments; ++s) {
            const std::uint32_t next = (s + 1) % kSegments, row = r * kSegments;
            mesh.quads.push_back(
                {row + s, row + kSegments + s, row + kSegments + next, row + next});
        }
    }
    const EmbreeCaster caster(mesh);
    std::vector<Ray> rays;
    for (int i = 0; i < 200000; ++i) {
        Ray ray;
        ray.origin_m = (0.2 * RandomPoint(5, i, 0)).cast<float>();
        const std::uint32_t face = std::uint32_t(RandomBits(5, i, 1, 0) % mesh.quads.size());
        const std::uint32_t side = std::uint32_t(RandomBits(5, i, 1, 1) % 3);
        const float along = float(0.01 + 0.98 * RandomUnit(5, i, 1, 2));
        const auto corner = [&](std::uint32_t k) -> const Vec3f& {
            return mesh.vertices_m[mesh.quads[face][k % 4]];
        };
        // Two sides and the diagonal b-d.
        const Vec3f& from = corner(side == 2 ? 1 : side);
        const Vec3f& to = corner(side == 2 ? 3 : side + 1);
        const Vec3f target =
            i % 2 == 0 ? Vec3f(from + along * (to - from))
                       : Vec3f((RandomPoint(5, i, 2) - Vec3(0.5, 0.5, 0.5)).cast<float>());
        ray.direction = target - (i % 2 == 0 ? ray.origin_m : Vec3f(Vec3f::Zero()));
        rays.push_back(ray);
    }
    std::vector<std::uint64_t> met(BitWords(rays.size()));
    caster.Any(rays, met);
    const auto count = [](int sum, std::uint64_t word) { return sum + std::popcount(word); };
    EXPECT_EQ(std::accumulate(met.begin(), met.end(), 0, count), 200000);
}

// Expected: a plane never shades itself, wherever it lies and however large its triangles are.
// One case is large triangles about the origin of the coordinates, where 32 epsilon of the
// point's own coordinates vanish. Neighbours count where rounding cannot have raised them.
TEST(LeaveSurface, ATiltedPlaneNeverShadesItself) {
    for (const double scale : {1e-3, 1.0, 1e3, 1e6}) {
        for (const double offset : {0.0, 10.0, 1000.0}) {
            for (const int cells : {1, 64}) {
                Mesh mesh;
                const Basis frame(Vec3(0.3, -0.2, 0.7).normalized());
                const Vec3 shift = offset * scale * Vec3(1, 0.7, 0.4);
                const auto point = [&](int i, int j) -> Vec3 {
                    return shift +
                           scale * frame.ToWorld({2.0 * i / cells - 1, 2.0 * j / cells - 1, 0});
                };
                for (int j = 0; j < cells; ++j) {
                    for (int i = 0; i < cells; ++i) {
                        AddQuad(mesh, point(i, j), point(i + 1, j), point(i + 1, j + 1),
                                point(i, j + 1));
                    }
                }
                const EmbreeCaster caster(mesh);
                // Corners are rounded to float, so the plane is not quite one: a triangle is
                // tilted by up to twice 2^-24 of a corner's coordinates over its own height.
                const double tilt_rad =
                    2 * 0x1p-24 * (offset + 2) / (2.0 / cells / std::sqrt(2.0));
                int own = 0, other = 0;
                for (int p = 0; p < 400; ++p) {
                    const std::uint32_t id =
                        std::uint32_t(RandomBits(6, p, 0, 0) % (2 * mesh.quads.size()));
                    const Triangle triangle = TriangleOf(mesh, id);
                    // Half of the points are near the middle of the diagonal: with one cell
                    // and no offset that is the origin of the coordinates.
                    const Vec2 u(RandomUnit(6, p, 1, 0), RandomUnit(6, p, 1, 1));
                    const Vec2 b =
                        p % 2 == 0 ? SampleTriangle(u) : Vec2(Vec2(0.5, 0.5) - 1e-3 * u);
                    const Basis local(triangle.Normal());
                    const Ray start = LeaveSurface(triangle, b.x(), b.y(), local.n);
                    std::vector<Ray> rays(64, start);
                    for (int k = 0; k < 64; ++k) {
                        // Half of them cosine-distributed, half grazing by down to 1e-6.
                        const double u0 = RandomUnit(6, p, 2, k), u1 = RandomUnit(6, p, 3, k);
                        const double z = std::pow(10, -6 * u0);
                        const double rho = std::sqrt(1 - z * z), phi = 2 * kPi * u1;
                        const Vec3 w = k % 2 == 0
                                           ? SampleCosineHemisphere({u0, u1})
                                           : Vec3(rho * std::cos(phi), rho * std::sin(phi), z);
                        rays[k].direction = local.ToWorld(w).cast<float>();
                    }
                    std::vector<Hit> hits(rays.size());
                    caster.Closest(rays, hits);
                    for (const Hit& hit : hits) {
                        own += hit.triangle == id;
                        const double z =
                            rays[std::size_t(&hit - hits.data())].direction.cast<double>().dot(
                                local.n);
                        other += hit.Met() && hit.triangle != id && z > 2 * tilt_rad;
                    }
                }
                EXPECT_EQ(own, 0) << scale << " " << offset << " " << cells;
                EXPECT_EQ(other, 0) << scale << " " << offset << " " << cells;
            }
        }
    }
}

}  // namespace
}  // namespace plumb
