#include <gmock/gmock.h>

#include <algorithm>
#include <cstring>

#include "core/parallel.h"
#include "rays/packets/bsp_build.h"
#include "rays/triangle.h"
#include "tests/rays/packets/shapes.h"

namespace plumb {
namespace {

std::vector<Corners> CornersOfAll(const Mesh& mesh) {
    std::vector<Corners> all;
    for (std::uint32_t id = 0; id < 2 * mesh.quads.size(); ++id) {
        if (id % 2 == 1 && mesh.quads[id / 2][2] == mesh.quads[id / 2][3]) continue;
        Corners corners;
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t k = 0; k < 3; ++k) {
                corners[c][k] = float(TriangleOf(mesh, id).corners_m[c][int(k)]);
            }
        }
        all.push_back(corners);
    }
    return all;
}

// Whether a leaf whose closed cell holds the point names the triangle.
bool IsListedAt(const BspTree& tree, std::uint32_t at, const Vec3& p, std::uint32_t triangle) {
    const BspNode& node = tree.nodes[at];
    if (node.IsLeaf()) {
        const auto begin = tree.lists.begin() + node.First();
        return std::find(begin, begin + node.Count(), triangle) != begin + node.Count();
    }
    const double x = p[int(node.Axis())], s = double(node.SplitM());
    return (x <= s && IsListedAt(tree, node.Left(), p, triangle)) ||
           (x >= s && IsListedAt(tree, node.Left() + 1, p, triangle));
}

TEST(BspNode, KeepsWhatItIsGiven) {
    const BspNode inner = BspNode::Inner(2, -1.5f, 1'000'000'000);
    EXPECT_FALSE(inner.IsLeaf());
    EXPECT_EQ(inner.Axis(), 2u);
    EXPECT_EQ(inner.SplitM(), -1.5f);
    EXPECT_EQ(inner.Left(), 1'000'000'000u);
    const BspNode leaf = BspNode::Leaf(BspNode::kMostPointed - 1, 77);
    EXPECT_TRUE(leaf.IsLeaf());
    EXPECT_EQ(leaf.First(), BspNode::kMostPointed - 1);
    EXPECT_EQ(leaf.Count(), 77u);
    EXPECT_FALSE(leaf.IsRun());
    const BspNode run = BspNode::Run(5, 3);
    EXPECT_TRUE(run.IsLeaf());
    EXPECT_TRUE(run.IsRun());
    EXPECT_EQ(run.First(), 5u);
    EXPECT_EQ(run.Count(), 3u);
}

// Expected, by hand: a box 4 m long and 1 m square, S = 18 (sides of 4 and ends of 1: 4 * 4 + 2),
// here as the sum of three different sides, 9. Three triangles lie in x < 1, one in x > 3. With
// C_step = 1, C_test = 10: no split costs 40; at 1 the left side is 1 x 1 x 1 (3), the right
// one 3 x 1 x 1 (7): 1 + 10 (3 * 3 + 7 * 1) / 9 = 18.8; at 3: 1 + 10 (7 * 3 + 3 * 1) / 9 =
// 27.7; ends within the left group part it where more than 1/2 of it stays: worse.
TEST(BspSplit, TakesTheCheapestPlaneByHand) {
    std::vector<BspReference> references(4);
    for (std::size_t i = 0; i < 3; ++i) references[i].box = {{0, 0, 0}, {1, 1, 1}};
    references[3].box = {{3, 0, 0}, {4, 1, 1}};
    const BspBox cell{{0, 0, 0}, {4, 1, 1}};
    BspScratch scratch;
    const BspCosts costs{.step = 1, .test = 10, .empty = 0};
    const std::optional<BspSplit> split = CheapestSplit(references, cell, costs, scratch);
    ASSERT_TRUE(split);
    EXPECT_EQ(split->axis, 0u);
    EXPECT_EQ(split->at_m, 1.0f);
    // A leaf of four costs 4 C_test = 0.4, less than any step.
    EXPECT_FALSE(CheapestSplit(references, cell, {.step = 1, .test = 0.1}, scratch));
    // The same by even planes: 128 of them, one of which is at 1.
    BspCosts even = costs;
    even.few = 0;
    const std::optional<BspSplit> evenly = CheapestSplit(references, cell, even, scratch);
    ASSERT_TRUE(evenly);
    EXPECT_EQ(evenly->axis, 0u);
    EXPECT_NEAR(evenly->at_m, 1, 4.0 / 128);
}

// Expected, by hand: the triangle (0,0,0), (2,0,0), (0,2,0), left of x = 1: the corners and
// (1, 0), (1, 1); above y = 1.5 of that: x up to 0.5.
TEST(BspReference, ShrinksToTheClippedTriangle) {
    const Corners corners{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}};
    BspReference reference = ReferenceTo(corners, 9);
    EXPECT_EQ(reference.triangle, 9u);
    ASSERT_TRUE(Narrow(reference, corners, 0, 1, 0));
    EXPECT_THAT(reference.box.high_m, testing::ElementsAre(1, 2, 0));
    ASSERT_TRUE(Narrow(reference, corners, 1, 1.5f, 1));
    EXPECT_THAT(reference.box.low_m, testing::ElementsAre(0, 1.5f, 0));
    EXPECT_THAT(reference.box.high_m, testing::ElementsAre(0.5f, 2, 0));
    EXPECT_FALSE(Narrow(reference, corners, 0, 0.75f, 1));
}

// Expected: a point of a triangle lies in some leaf that lists the triangle: the definition of
// the tree. Points are double; the nearest double to a point of the plane may lie 1e-16 beyond
// a clipped box, which the walk's margin of 1e-6 covers: cells are asked at 1e-12.
TEST(BspTree, ListsEveryTriangleWhereverItLies) {
    for (const Mesh& mesh : {Soup(300, 0.5), Soup(4000, 0.05), FenceAndFloor(), Hills(20)}) {
        const std::vector<Corners> corners = CornersOfAll(mesh);
        const BspTree tree = BuildBspTree(corners);
        int asked = 0;
        for (std::uint32_t i = 0; i < corners.size(); ++i) {
            for (std::uint64_t k = 0; k < 20; ++k) {
                double u = RandomUnit(3, i, k, 0), v = RandomUnit(3, i, k, 1);
                if (k < 3) u = k == 1, v = k == 2;
                if (u + v > 1) u = 1 - u, v = 1 - v;
                const auto at = [&](std::size_t c) {
                    return Vec3(double(corners[i][c][0]), double(corners[i][c][1]),
                                double(corners[i][c][2]));
                };
                const Vec3 p = (1 - u - v) * at(0) + u * at(1) + v * at(2);
                bool listed = IsListedAt(tree, 0, p, i);
                for (int n = 0; n < 6 && !listed; ++n) {
                    Vec3 beside = p;
                    beside[n / 2] += n % 2 == 0 ? 1e-12 : -1e-12;
                    listed = IsListedAt(tree, 0, beside, i);
                }
                ASSERT_TRUE(listed) << "triangle " << i << " at " << p.transpose();
                ++asked;
            }
        }
        EXPECT_GT(asked, 5000);
    }
}

// [Wald01 section 4.2]: siblings side by side, never across a line of the cache.
TEST(BspTree, KeepsSiblingsInOneCacheLine) {
    const BspTree tree = BuildBspTree(CornersOfAll(Hills(40)));
    ASSERT_EQ(reinterpret_cast<std::uintptr_t>(tree.nodes.data()) % 16, 0u);
    int inner = 0;
    for (const BspNode& node : tree.nodes) {
        if (node.IsLeaf()) continue;
        EXPECT_EQ(node.Left() % 2, 0u);
        ++inner;
    }
    EXPECT_GT(inner, 100);
}

TEST(BspTree, IsTheSameOnAnyNumberOfThreads) {
    const std::vector<Corners> corners = CornersOfAll(Soup(60'000, 0.02));
    const int before = ThreadCount();
    SetThreadCount(1);
    const BspTree one = BuildBspTree(corners);
    SetThreadCount(3);
    const BspTree three = BuildBspTree(corners);
    SetThreadCount(before);
    EXPECT_EQ(one.lists, three.lists);
    ASSERT_EQ(one.nodes.size(), three.nodes.size());
    EXPECT_EQ(
        std::memcmp(one.nodes.data(), three.nodes.data(), one.nodes.size() * sizeof(BspNode)),
        0);
    EXPECT_GT(one.nodes.size(), 10'000u);
}

TEST(BspTree, OfNothingIsAnEmptyLeaf) {
    const BspTree tree = BuildBspTree({});
    EXPECT_TRUE(tree.nodes.at(0).IsLeaf());
    EXPECT_EQ(tree.nodes.at(0).Count(), 0u);
}

// Expected: entries and depth within what bsp_build.h promises, for triangles that no plane
// parts: copies of one, a sheaf of long diagonals, all in one plane.
TEST(BspTree, IsBoundedWhateverTheTriangles) {
    const auto check = [](const std::vector<Corners>& corners) {
        const BspTree tree = BuildBspTree(corners);
        EXPECT_LE(double(tree.lists.size()), 12 * double(corners.size()) + 1024);
        EXPECT_LE(tree.depth, 8 + 1.3 * std::log2(double(corners.size()) + 1));
        return tree.lists.size();
    };
    EXPECT_EQ(check(std::vector<Corners>(100'000, {{{0, 0, 0}, {1, 0, 1}, {0, 1, 0.5f}}})),
              100'000u);
    std::vector<Corners> sheaf, flat;
    for (int i = 0; i < 20'000; ++i) {
        const float e = 1e-5f * float(i);
        sheaf.push_back({{{e, 0, 0}, {1, 1, 1 + e}, {e, 1e-5f, 0}}});
        const float x = float(i % 141), y = float(i / 141);
        flat.push_back({{{x, y, 0.25f}, {x + 1, y, 0.25f}, {x, y + 1, 0.25f}}});
    }
    EXPECT_GE(check(sheaf), sheaf.size());
    EXPECT_LE(check(flat), 2 * flat.size());
}

}  // namespace
}  // namespace plumb
