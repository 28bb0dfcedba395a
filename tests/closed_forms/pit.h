// A round pit with upright walls: the visibility of the middle of its floor.
//
//       V = r^2 / (r^2 + d^2)          alpha = 1 - d / sqrt(r^2 + d^2)
//
// and so V = alpha (2 - alpha): the greatest V that this alpha allows, for the sky is a cap
// about the normal.
//
// Source   derived: a cone of sky of half-angle th has the cosine weight sin^2 th and fills
//          1 - cos th of the hemisphere, tan th = r / d.
// Symbols  r radius (m), d depth (m).
#pragma once

#include <cmath>

#include "core/visibility.h"

namespace plumb {

inline CosineVisibility PitFloorVisibility(double r_m, double d_m) {
    return CosineVisibility(r_m * r_m / (r_m * r_m + d_m * d_m));
}
inline UniformVisibility PitFloorUniformVisibility(double r_m, double d_m) {
    return UniformVisibility(1 - d_m / std::hypot(r_m, d_m));
}

}  // namespace plumb
