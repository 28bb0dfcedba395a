// What rays walk through: the tree with the triangles, and what is to be done there.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene.h"
#include "rays/packets/bsp_tree.h"
#include "rays/packets/triangle_record.h"

namespace plumb {

/// How a ray meets a triangle.
enum class TriangleTest : std::uint8_t {
    kWatertight,  ///< watertight_test.h
    kPluecker,    ///< pluecker_test.h
    kProjected,   ///< projected_test.h
};

struct PacketScene {
    BspTree tree;                         ///< Its lists name records.
    std::vector<TriangleRecord> records;  ///< In the order of the lists: neighbours together.
    TriangleTest test = TriangleTest::kWatertight;
    bool mailboxes = true;
    const Scene* holes = nullptr;  ///< Of alpha-tested materials; null: there are none.

    /// Which record is triangle i of a leaf.
    std::uint32_t Place(const BspNode& leaf, std::uint32_t i) const {
        return leaf.IsRun() ? leaf.First() + i : tree.lists[leaf.First() + i];
    }
};

/// What a walk cost. A packet's visit of a node is one visit.
struct WalkCounts {
    std::int64_t nodes = 0;  ///< Inner nodes and leaves visited.
    std::int64_t leaves = 0;
    std::int64_t tests = 0;  ///< Triangles tested; mailboxes save some.

    WalkCounts& operator+=(const WalkCounts& other) {
        nodes += other.nodes;
        leaves += other.leaves;
        tests += other.tests;
        return *this;
    }
};

}  // namespace plumb
