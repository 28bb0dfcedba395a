// The search table of SMAA: which edges a bilinear fetch between four pixels has seen.
//
// A GPU reads the edges of two pixels in a row, and of the two above them, in one fetch; the four
// bits are in the value read,
//
//       e = ( f' + 3 n' + 7 f + 21 n ) / 32        n near, f far, ' of the row above
//
// and the table says by how many pixels the run reaches into the pair last fetched: 0, 1 or 2.
//
//       left    +1 if n's edge is set, +1 more if f's is and nothing crosses at n
//       right   +1 if n's edge is set and nothing crosses at n, +1 more likewise at f
//
// Source   [Jimenez12] and the script that made its table; computed here, never copied.
// Symbols  Texel (32 e_cross [+ 33 for the right end], 32 - 32 e_run), 127 times the count.
// Beware   The filters here search on the bits themselves; this is their check.
#pragma once

#include <cstdint>
#include <vector>

namespace plumb {

inline constexpr int kSmaaSearchWidth = 64, kSmaaSearchHeight = 16;

/// Row-major, a byte a texel. Row 0 is that of e_run = 1.
std::vector<std::uint8_t> SmaaSearchTable();

}  // namespace plumb
