// A triangle within a cell of the tree: the box of what the cell leaves of it.
//
// The box is that of the triangle's polygon clipped to the cell, in double and rounded outward:
// a diagonal triangle's box shrinks with its cells, so that it stands in fewer of them.
//
// Source   [Sutherland74] I. Sutherland, G. Hodgman, Reentrant Polygon Clipping, CACM 17(1).
#pragma once

#include <array>
#include <cstdint>

#include "rays/packets/bsp_tree.h"

namespace plumb {

using Corners = std::array<std::array<float, 3>, 3>;

struct BspReference {
    BspBox box;
    std::uint32_t triangle = 0;
};

/// Of the whole triangle.
BspReference ReferenceTo(const Corners& corners_m, std::uint32_t triangle);

/// Narrows the reference to what lies at most (`side` 0) or at least (`side` 1) at `split_m`.
/// Returns false if nothing of the triangle does.
bool Narrow(BspReference& reference, const Corners& corners_m, std::uint32_t axis,
            float split_m, int side);

}  // namespace plumb
