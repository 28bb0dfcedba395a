// Where to split a cell of the tree: by the surface-area cost.
//
//                              S_left n_left + S_right n_right
//       C = C_step + C_test  ----------------------------------   (1 - empty) if a side is empty
//                                            S
//
// against C_test n of a leaf: the chance that a ray which meets the cell meets a part of it is
// the ratio of their surfaces. Planes that are tried: both ends of every triangle's box where
// there are few triangles, 127 evenly spaced ones along each axis where there are many.
//
// Source   [MacDonald90] J. MacDonald, K. Booth, Heuristics for Ray Tracing Using Space
//          Subdivision, The Visual Computer 6(3); [Wald01 section 2.1] uses such a tree.
// Symbols  n triangles, S surface (m^2), C_step cost of a node, C_test of a triangle.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rays/packets/bsp_reference.h"

namespace plumb {

/// What a tree is built for. Defaults: the fastest of those tried for 4 x 4 rays.
struct BspCosts {
    double step = 1;         ///< C_step. > 0
    double test = 0.3;       ///< C_test. > 0
    double empty = 0.2;      ///< What cutting empty space off saves. [0, 1)
    std::uint32_t few = 64;  ///< Up to so many triangles every end is tried.
};

struct BspSplit {
    std::uint32_t axis = 0;
    float at_m = 0;
};

/// Which sides of a plane at `split_m` a stretch from `low` to `high` needs. What lies in the
/// plane needs the left only.
inline bool NeedsLeft(float low, float high, float split_m) {
    return low < split_m || high <= split_m;
}
inline bool NeedsRight(float high, float split_m) {
    return high > split_m;
}

/// Memory that is used again from cell to cell.
struct BspScratch {
    std::vector<float> lows, highs;
};

/// The cheapest split, or nothing if a leaf is cheaper.
std::optional<BspSplit> CheapestSplit(std::span<const BspReference> references,
                                      const BspBox& cell, const BspCosts& costs,
                                      BspScratch& scratch);

}  // namespace plumb
