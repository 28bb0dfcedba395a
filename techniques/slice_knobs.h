// The knobs that HBAO, GTAO and the visibility bitmask share: slices and the walk along them.
#pragma once

#include "screen_space/horizon/slice_march.h"
#include "techniques/knobs.h"

namespace plumb {

/// `samples` sets steps and slices, about the square root of half of it each.
BoundKnobs<SliceSampling> SliceKnobs();

/// Depth lookups a pixel.
int SamplesOf(const SliceSampling& sampling);

}  // namespace plumb
