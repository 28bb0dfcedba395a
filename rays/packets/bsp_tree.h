// An axis-aligned BSP tree over triangles, as rays read it.
//
//       node     8 bytes: a float and a word. The word's two low bits are the axis of the split
//                (0, 1, 2) or 3 for a leaf; the others point
//       inner    the float is the split coordinate; points to the left child, the right child
//                follows it: siblings lie in one cache line
//       leaf     the float's bits count its triangles; points to the first of them in `lists`,
//                or, if the highest bit is set, straight to the first of a run of triangles
//
// A leaf's triangles are those that come within its closed cell; one may stand in many leaves.
// Runs are ours: most leaves need no list once triangles are stored in the order of the leaves,
// and a list is one wait for memory more.
//
// Source   [Wald01 section 4.2].
// Symbols  low, high corners of a box (m).
// Beware   Nodes are numbered in pairs: the root is node 0, node 1 is nobody's, children are
//          at even numbers and the number after.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace plumb {

struct BspBox {
    std::array<float, 3> low_m{}, high_m{};
};

class BspNode {
  public:
    static constexpr std::uint32_t kLeaf = 3;
    static constexpr std::uint32_t kMostPointed = 1u << 30;  ///< What 30 bits can point to.

    static BspNode Inner(std::uint32_t axis, float split_m, std::uint32_t left) {
        return BspNode(split_m, left << 2 | axis);
    }
    static BspNode Leaf(std::uint32_t first, std::uint32_t count) {
        return BspNode(std::bit_cast<float>(count), first << 2 | kLeaf);
    }
    static BspNode Run(std::uint32_t first, std::uint32_t count) {
        return Leaf(first, count | kRun);
    }
    BspNode() : BspNode(Leaf(0, 0)) {}

    bool IsLeaf() const { return Axis() == kLeaf; }
    std::uint32_t Axis() const { return word_ & 3; }
    float SplitM() const { return number_; }
    std::uint32_t Left() const { return word_ >> 2; }
    std::uint32_t First() const { return word_ >> 2; }
    std::uint32_t Count() const { return std::bit_cast<std::uint32_t>(number_) & ~kRun; }
    bool IsRun() const { return std::bit_cast<std::uint32_t>(number_) & kRun; }

  private:
    static constexpr std::uint32_t kRun = 1u << 31;

    BspNode(float number, std::uint32_t word) : number_(number), word_(word) {}

    float number_;
    std::uint32_t word_;
};
static_assert(sizeof(BspNode) == 8);

struct BspTree {
    /// No leaf is deeper: what a traversal has to keep in mind is bounded.
    static constexpr int kMostDepth = 60;

    BspBox box;  ///< Of everything. Rays beside it meet nothing.
    std::vector<BspNode> nodes;
    std::vector<std::uint32_t> lists;  ///< Triangles, by their place in what was built over.
    int depth = 0;                     ///< Of the deepest leaf; the root's is 0.
};

}  // namespace plumb
