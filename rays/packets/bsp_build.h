// Builds the BSP tree of bsp_tree.h over triangles.
//
// From the top down: each cell is split where bsp_split.h says, until a leaf is cheaper. The
// first cells are split level by level, all of a level at once on every core; each of the cells
// that remain becomes a subtree by itself. So the tree does not depend on the number of cores.
//
// Memory is bounded whatever the triangles: a tree has at most `most_copies` n + 1024 entries
// in its lists, shared out among cells as their triangles are; a cell whose share is used up is
// a leaf. Depth is at most 8 + 1.3 log2 n (and kMostDepth).
//
// Beware   Cost is O(n log n) at one pass over a cell's triangles a level. 1e6 copies of one
//          triangle end up in one leaf: no plane parts them, and each ray there tests them all.
#pragma once

#include <span>

#include "core/monitor.h"
#include "rays/packets/bsp_reference.h"
#include "rays/packets/bsp_split.h"
#include "rays/packets/bsp_tree.h"

namespace plumb {

struct BspBuildOptions {
    BspCosts costs = {};
    double most_copies = 12;  ///< Entries of lists, a triangle. [1, ...)
};

/// Lists name triangles by their place in `triangles_m`, which must be finite. Throws
/// MachineError if the tree would be too large for its nodes' pointers.
BspTree BuildBspTree(std::span<const Corners> triangles_m, const BspBuildOptions& options = {},
                     Monitor& monitor = SilentMonitor());

}  // namespace plumb
