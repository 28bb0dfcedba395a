// A ray against a height field, exactly: the facet that it meets first, or the sky.
//
// A ray of slope m = d_z / |d_xy| is a line of sight in the vertical plane of its azimuth; it
// meets the surface where the walk of that plane (heightfield/facet_walk.h) first stands at or
// above it.
//
// Source   ours; the linear search of [Policarpo07] with its step length taken away.
// Symbols  m slope (unitless).
// Beware   Over an endless field (wrap, mirror) a ray that does not rise always meets
// something,
//          but a nearly level one may do so beyond any distance: past `max_distance_m` it is
//          reported as kLost, for the caller to count. It is never called sky.
#pragma once

#include <cstdint>

#include "core/vec.h"
#include "heightfield/facet_walk.h"

namespace plumb {

/// What a ray meets that meets no facet.
inline constexpr std::int64_t kSky = -1;
inline constexpr std::int64_t kLost = -2;

/// The distance at which an endless walk gives up: far enough that a ray of slope -1e-6 of the
/// steepest scale still ends, 1e6 times the relief plus a hundred tiles.
double FarDistanceM(const HeightField& field);

/// The facet that the ray meets first, kSky or kLost. It starts on facet `facet` and heads into
/// the open half-space above it; x, y from texel (0, 0) as in WalkGrid::Start. `direction` need
/// not be of unit length; it must not vanish. `height_m`, if given, learns the height at which the
/// facet is met. Cost: O(log n) blocks on a rough field of n x n
/// texels.
std::int64_t CastFromFacet(const WalkGrid& grid, std::int64_t facet, const Vec3& origin_m,
                           const Vec3& direction, double max_distance_m,
                           double* height_m = nullptr);

}  // namespace plumb
