// AlchemyAO, the baseline of SAO: the same estimator, each tap on the full-resolution depth.
//
//       12 taps a pixel  ->  13 x 13 cross bilateral, one axis after the other
//
// Source   [McGuire12 eq. 1], section 1.1, figure 2 and table 2, which speak of its taps and filter:
//          12 (13 x 13). It has a position and a normal buffer, no z pyramid, no quads, no packing.
// Beware   The fixed pattern of its 12 taps is not in our sources: ours is the sunflower, even
//          over the disc's area, turned by the same hash. Nor are the filter's weights: ours are the
//          published Gaussian of 13 taps, cut by depth as sharply as SAO's.
#pragma once

#include "screen_space/sao/sao_passes.h"

namespace plumb {

/// Run by RunSao.
SaoOptions AlchemyAo();

}  // namespace plumb
