// Pass 2 of SMAA: from runs of edges to shares of pixels.
//
// A pixel with a top edge: if a diagonal run passes through it, that one's shares; else the run
// of top edges through it, sought to both sides until an edge is missing, a left edge crosses the
// line, or the search ends: at most 2 steps - 1 pixels to the left and 2 steps to the right, the
// places that a GPU's bilinear fetches of pairs reach. Its distances and the crossing edges at its
// ends give the shares (smaa_area.h). A pixel with a left edge: the same transposed, if no diagonal
// was found.
//
// Corners: at the nearer end (at both, each half, if they are equally near) a share is multiplied by
// 1 - (1 - r) where the crossing edge goes on one row below (first share) or two above (second).
//
// Diagonals: runs of stairs of one pixel, both edges of each stair set, more than two stairs long.
//
// Source   [Jimenez12] and its shader of 2013.
// Symbols  r corner rounding; x along the run, y across.
// Beware   Beyond the picture edges are those of its border: a run that reaches it goes on.
#pragma once

#include <array>

#include "core/image.h"
#include "screen_space/antialiasing/smaa_area.h"
#include "screen_space/antialiasing/smaa_edges.h"

namespace plumb {

/// Shares of a pixel: its own that its upper neighbour covers, its upper neighbour's that it
/// covers, then the same of its left neighbour.
using SmaaWeights = std::array<float, 4>;

/// Which way a run goes.
enum class SmaaAxis { kAlongRows, kAlongColumns };

/// A run of edges as seen from one of its pixels.
struct SmaaRun {
    int before = 0, after = 0;            ///< Pixels of the run to the left (up), right (down).
    int code_before = 0, code_after = 0;  ///< Of the ends: see smaa_area.h.
};

/// The run through the pixel, which has a top (along columns: left) edge.
SmaaRun FindSmaaRun(const SmaaEdges& edges, SmaaAxis axis, int x, int y, int search_steps);

/// Both diagonals through a pixel with a top edge; {0, 0} if there is none.
SmaaShares DiagonalShares(const SmaaEdges& edges, int x, int y, const SmaaOptions& options);

Image<SmaaWeights> FindSmaaWeights(const SmaaEdges& edges, const SmaaOptions& options);

}  // namespace plumb
