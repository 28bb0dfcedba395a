// In which order the samples of a window are taken: the index matrices of ordered dithering.
//
//       M_2m = ( 4 M_m + 0   4 M_m + 2 )      M_1 = ( 0 )
//              ( 4 M_m + 3   4 M_m + 1 )
//
// for even m, then 0 and 1 exchanged where 1 lies nearer the middle: that gives the matrices of the
// paper's figure 3 for m = 2 and 4, so it is taken for 6 and 8 too. Odd windows have a middle: 0 is
// there, and each next number is where the distance to the nearest one taken is largest. The
// figure's matrix for m = 3 is such an order; it is taken as printed, ties and all. For 5 and 7 ties
// go to the place farthest from the number before, then to the first by rows.
//
// Source   [Hollander13] figure 3, after [Bayer73]. Other m than 2, 3, 4: ours, by the same rules.
// Symbols  m window edge; row j, column i of the matrix is the number of sample (i, j).
// Beware   For m = 2 the first sample is the upper left one, half a sample from the middle; for m
//          = 4 and 8 it is just below and right of the middle. A picture of first samples is
//          shifted by that.
#pragma once

#include <vector>

namespace plumb {

struct SamplePlace {
    int i = 0, j = 0;  ///< Column and row in the window.

    friend bool operator==(const SamplePlace&, const SamplePlace&) = default;
};

/// Row by row, m^2 numbers. Throws Error unless m is in [1, 8].
std::vector<int> IndexMatrix(int m);

/// The place of number 0, 1, ... m^2 - 1.
std::vector<SamplePlace> SampleOrder(int m);

}  // namespace plumb
