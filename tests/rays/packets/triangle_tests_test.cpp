#include <gtest/gtest.h>

#include "rays/packets/projected_test.h"
#include "tests/rays/packets/brute_force.h"
#include "tests/rays/packets/shapes.h"

namespace plumb {
namespace {

// The tests under one name each: how they read a triangle, and how they meet it.
struct Watertight {
    using Test = WatertightTest;
    static TriangleRecord Record(const Corners& corners) { return RecordOfCorners(corners); }
};
struct Pluecker {
    using Test = PlueckerTest;
    static TriangleRecord Record(const Corners& corners) { return RecordOfCorners(corners); }
};
struct Projected {
    using Test = ProjectedTest;
    static TriangleRecord Record(const Corners& corners) { return RecordOfPlanes(corners); }
};

template <class T>
class TriangleTests : public testing::Test {};
using All = testing::Types<Watertight, Pluecker, Projected>;
TYPED_TEST_SUITE(TriangleTests, All);

using Point = std::array<float, 3>;

// Expected, by hand: triangle (0,0,2), (4,0,2), (0,4,2) from (1, 2, -1) along (0, 0, 1.5) at
// t = 2; there P = a + 1/4 (b - a) + 1/2 (c - a). From behind the same. Beside: not at all.
// All numbers are exact in float, and so must the answers be.
TYPED_TEST(TriangleTests, MeetWhatTheyMeetByHand) {
    for (std::size_t turn = 0; turn < 3; ++turn) {  // Every axis is once the longest.
        const auto turned = [turn](const Point& p) {
            return Point{p[(turn + 0) % 3], p[(turn + 1) % 3], p[(turn + 2) % 3]};
        };
        const TriangleRecord record =
            TypeParam::Record({turned({0, 0, 2}), turned({4, 0, 2}), turned({0, 4, 2})});
        const auto meet = [&](const Point& o, const Point& d, Meeting& at) {
            return typename TypeParam::Test(turned(o), turned(d)).Meets(record, at);
        };
        Meeting at;
        ASSERT_TRUE(meet({1, 2, -1}, {0, 0, 1.5f}, at));
        EXPECT_EQ(at.t, 2);
        EXPECT_EQ(at.b_1, 0.25f);
        EXPECT_EQ(at.b_2, 0.5f);
        ASSERT_TRUE(meet({1, 2, 5}, {0, 0, -1.5f}, at));
        EXPECT_EQ(at.t, 2);
        EXPECT_EQ(at.b_1, 0.25f);
        EXPECT_EQ(at.b_2, 0.5f);
        ASSERT_TRUE(meet({1, 2, 5}, {0, 0, 1.5f}, at));  // t < 0 is for the caller to refuse.
        EXPECT_EQ(at.t, -2);
        ASSERT_TRUE(meet({0, 1, 1}, {0.5f, 0.25f, 0.5f}, at));  // Not along an axis.
        EXPECT_EQ(at.t, 2);
        EXPECT_EQ(at.b_1, 0.25f);
        EXPECT_EQ(at.b_2, 0.375f);
        EXPECT_FALSE(meet({3, 2, -1}, {0, 0, 1}, at));
        EXPECT_FALSE(meet({-0.5f, 2, -1}, {0, 0, 1}, at));
        EXPECT_FALSE(meet({1, -0.5f, -1}, {0, 0, 1}, at));
        EXPECT_FALSE(meet({1, 2, -1}, {1, 1, 0}, at) && std::isfinite(at.t));  // In parallel.
    }
}

// Expected: [Moeller97]'s formula in double. Tolerance: rays that pass an edge within 1e-4
// of the triangle's size are left to either answer; t to 1e-3 where the ray is not grazing
// (|cos| > 0.05), since float coordinates of the order of 1 are off by 2^-24 and errors grow by
// 1 / |cos| and by the distance over the size.
TYPED_TEST(TriangleTests, AgreeWithAFormulaInDouble) {
    int met = 0, missed = 0;
    for (std::uint64_t i = 0; i < 20'000; ++i) {
        Corners corners;
        std::array<Vec3, 3> p;
        for (std::size_t c = 0; c < 3; ++c) {
            const Vec3 corner = RandomPoint(11, i, c);
            for (std::size_t k = 0; k < 3; ++k) corners[c][k] = float(corner[int(k)]);
            p[c] = corner.cast<float>().cast<double>();
        }
        const Vec3f o = RandomPoint(11, i, 7).cast<float>();
        const Vec3f d = (RandomPoint(11, i, 8) - Vec3::Constant(0.5)).cast<float>();
        const Vec3 e1 = p[1] - p[0], e2 = p[2] - p[0], q = d.cast<double>().cross(e2);
        const double det = e1.dot(q);
        const Vec3 s = o.cast<double>() - p[0], r = s.cross(e1);
        const double b_1 = s.dot(q) / det, b_2 = d.cast<double>().dot(r) / det;
        const double t = e2.dot(r) / det, inside = std::min({b_1, b_2, 1 - b_1 - b_2});
        const double cosine = std::abs(det) / (e1.cross(e2).norm() * d.cast<double>().norm());
        if (std::abs(inside) < 1e-3 || cosine < 0.05 || e1.cross(e2).norm() < 0.05) continue;
        const typename TypeParam::Test test({o[0], o[1], o[2]}, {d[0], d[1], d[2]});
        Meeting at;
        ASSERT_EQ(test.Meets(TypeParam::Record(corners), at), inside > 0) << i;
        ++(inside > 0 ? met : missed);
        if (inside < 0) continue;
        EXPECT_NEAR(at.t, t, 1e-3) << i;
        EXPECT_NEAR(at.b_1, b_1, 1e-3) << i;
        EXPECT_NEAR(at.b_2, b_2, 1e-3) << i;
    }
    EXPECT_GT(met, 1000);
    EXPECT_GT(missed, 5000);
}

// Expected: of the triangles about a point each ray meets one at least, through the point
// itself and through the edges, wherever the fan lies and however thin its triangles are: the
// sheared triangles cover the plane around it. The projected test leaks here (not asserted).
TEST(WatertightTest, AFanOfTrianglesHasNoGap) {
    for (const double scale : {1.0, 1e-3}) {
        for (const float offset : {0.0f, 1.0f, 1e6f}) {
            constexpr int kBlades = 24;
            std::vector<Point> rim;
            const Point hub{offset, -0.7f * offset, 0.4f * offset};
            for (int i = 0; i < kBlades; ++i) {
                // At 1e6 a float knows 1/16: the thin blades are then 1000 steps long.
                const double size = (offset > 10 ? 1e5 : 1) * (i % 3 == 0 ? 1 : scale);
                const double phi = 2 * kPi * i / kBlades;
                rim.push_back({float(double(hub[0]) + size * std::cos(phi)),
                               float(double(hub[1]) + size * std::sin(phi)),
                               float(double(hub[2]) + 0.3 * size * std::sin(3 * phi))});
            }
            std::vector<TriangleRecord> blades;
            for (std::size_t i = 0; i < kBlades; ++i) {
                blades.push_back(RecordOfCorners({hub, rim[i], rim[(i + 1) % kBlades]}));
            }
            for (std::uint64_t i = 0; i < 20'000; ++i) {
                const Vec3 from = RandomPoint(5, i, 0) - Vec3(0.5, 0.5, -1);
                const double away = offset > 10 ? 3e5 : 3;
                const Point o{float(double(hub[0]) + away * from[0]),
                              float(double(hub[1]) + away * from[1]),
                              float(double(hub[2]) + away * from[2])};
                // At the hub, or at a point of a blade's edge near it.
                const Point& end = rim[i % kBlades];
                const double along = i % 4 == 0 ? 0 : 0.3 * RandomUnit(5, i, 1, 0);
                Point d;
                for (std::size_t k = 0; k < 3; ++k) {
                    d[k] = float(double(hub[k]) + along * (double(end[k]) - double(hub[k])) -
                                 double(o[k]));
                }
                const WatertightTest test(o, d);
                int met = 0;
                for (const TriangleRecord& blade : blades) {
                    Meeting at;
                    met += test.Meets(blade, at);
                }
                ASSERT_GE(met, 1) << "ray " << i << " scale " << scale << " at " << offset;
            }
        }
    }
}

// Expected: with corners and ray so that U, V and W cancel in float (the triangle is seen
// almost edge-on), t and the barycentric coordinates still name a point of the ray to within
// the triangle moved by float steps: 2^-20 of the distances.
TEST(WatertightTest, NamesAPointOfTheRayEdgeOn) {
    int met = 0;
    for (std::uint64_t i = 0; i < 200'000; ++i) {
        const Vec3 o = RandomPoint(6, i, 0), a = RandomPoint(6, i, 1), b = RandomPoint(6, i, 2);
        const Vec3 inside = a + RandomUnit(6, i, 3, 0) * (b - a);
        // The third corner: near the plane of o, a and b.
        const Vec3 c =
            o + (0.5 + RandomUnit(6, i, 3, 1)) * (inside - o) + 1e-7 * RandomPoint(6, i, 4);
        const auto point = [](const Vec3& p) {
            return Point{float(p[0]), float(p[1]), float(p[2])};
        };
        const Point of = point(o), d = point(inside - o);
        const Corners corners{point(a), point(b), point(c)};
        Meeting at;
        if (!WatertightTest(of, d).Meets(RecordOfCorners(corners), at)) continue;
        ++met;
        for (std::size_t k = 0; k < 3; ++k) {
            const double on_ray = double(of[k]) + double(at.t) * double(d[k]);
            const double b_1 = double(at.b_1), b_2 = double(at.b_2);
            const double on_triangle = (1 - b_1 - b_2) * double(corners[0][k]) +
                                       b_1 * double(corners[1][k]) +
                                       b_2 * double(corners[2][k]);
            ASSERT_NEAR(on_ray, on_triangle, 2 * 0x1p-20) << "ray " << i;
        }
    }
    EXPECT_GT(met, 10'000);
}

}  // namespace
}  // namespace plumb
