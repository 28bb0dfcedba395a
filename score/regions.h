// The parts of a picture that are scored apart: where techniques fail for different reasons.
//
//       seen       z is finite: no sky
//       edges      seen, within `reach_px` of a break of the surface
//       interiors  seen, the rest
//       border     seen, within `border_px` of the frame: what it sees lies partly outside
//       centre     seen, the rest
//
// A break is where depth jumps, the normal turns, or sky begins. A jump is found by the second
// difference of 1/z along rows and columns,
//
//       | 1/z(i-1) - 2/z(i) + 1/z(i+1) | |z(i)| > jump
//
// because 1/z of a plane is linear in the picture: a floor seen at a grazing angle is no edge,
// however fast its depth grows. For a jump between two parallel planes the left side is the
// relative difference of their depths.
//
// Source   ours.
// Symbols  z depth of a pixel along the view, of one sign; n unit normal.
// Domain   Images of one size; z not 0, infinite where the sky is seen.
#pragma once

#include "core/image.h"
#include "core/vec.h"
#include "score/over_tiles.h"

namespace plumb {

struct RegionOptions {
    double depth_jump = 0.02;       ///< Share of the distance. (0, infinity)
    double normal_turn_rad = 0.35;  ///< Between neighbours, some 20 degrees. (0, pi]
    int reach_px = 3;               ///< Of an edge, to all eight sides. [0, 256]
    int border_px = 32;             ///< Width of the frame's border. [0, 65536]
};

/// Throws Error, naming field, value and rule.
void Validate(const RegionOptions& options);

struct Regions {
    Mask seen, edges, interiors, border, centre;
};

/// `normal` may be empty: then only depth tells. Cost: some ten passes.
Regions FindRegions(const Image<float>& z, const Image<Vec3f>& normal,
                    const RegionOptions& options = {});

/// Pixels that count in both; an empty mask is all pixels.
Mask Both(const Mask& a, const Mask& b);

std::int64_t CountOf(const Mask& mask);

}  // namespace plumb
