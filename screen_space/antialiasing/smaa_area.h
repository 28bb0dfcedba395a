// The areas of SMAA: which share of a pixel lies under the line that an edge is taken to be.
//
// A straight run of edge pixels, `left` of them before this one and `right` after it, d = left +
// right + 1, bends at its ends by crossing edges: up, down, both or not at all. The line drawn
// through the run leaves the pixel [left, left + 1] with two shares,
//
//       first    of the pixel below the edge, covered by what is above it
//       second   of the pixel above the edge, covered by what is below it
//
// Orthogonal runs: lines from 1/2 above or below an end to its other end or to the middle; U shapes
// are smoothed, a <- b + (a - b) min(1, d / 32), b = sqrt(2 a) / 2. Diagonal ones: the mean of 30 x
// 30 points of the pixels, over one line or two.
//
// The table holds them as the published one does: 160 x 80 texels of two bytes floor(255 a); left
// half orthogonal, 5 x 5 cells (by the codes of both ends) of 16 x 16 distances l^2, r^2; right half
// diagonal, 4 x 4 cells of 20 x 20 distances l, r.
//
// Source   [Jimenez12] and the script that made its table; computed here, never copied. The CRC-32
//          of the bytes is that of the published file's part for one sample a pixel.
// Symbols  Pattern, a sum: 1 crossing edge below the left end, 2 below the right end, 4 above the
//          left end, 8 above the right end. Code of an end, orthogonal: 3 below + 1 above;
//          diagonal: 1 below + 2 above at the left, 2 below + 1 above at the right.
// Beware   y grows downward.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace plumb {

/// {first, second}. [0, 1]
using SmaaShares = std::array<double, 2>;

/// `pattern` in [0, 16), distances >= 0.
SmaaShares OrthogonalArea(int pattern, int left, int right);
SmaaShares DiagonalArea(int pattern, int left, int right);

/// The pattern whose ends have these codes.
int OrthogonalPattern(int left_code, int right_code);  ///< 0, 1, 3 or 4 each.
int DiagonalPattern(int left_code, int right_code);    ///< 0 to 3 each.

inline constexpr int kSmaaAreaWidth = 160, kSmaaAreaHeight = 80;
inline constexpr int kSmaaCell = 16, kSmaaDiagonalCell = 20;

/// Row-major, two bytes a texel. Made at the first call.
const std::vector<std::uint8_t>& SmaaAreaTable();

/// The table at the exact distances, orthogonal: bilinear at their square roots. [0, 225]
SmaaShares TabledOrthogonalArea(int left_code, int right_code, int left, int right);
/// Diagonal: a texel. [0, 19]
SmaaShares TabledDiagonalArea(int left_code, int right_code, int left, int right);

}  // namespace plumb
