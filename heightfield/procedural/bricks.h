// A brick wall in running bond: equal bricks, every other course shifted by half a brick.
//
//   z = (1 - p) mortar + p brick,     p = SmoothStep(0, edge, depth inside the brick's outline)
//
// Edges are frayed by noise and chipped in places; each face has a level and a tilt of its own,
// pores, and noise of many octaves that starts anew on every brick.
//
// Source   Ours.
// Symbols  u, v position in tiles, period 1; lengths in course heights.
// Domain   Any u, v. The result lies in about [0, 1]; MakeBricks stretches it to the amplitude.
// Beware   An odd number of courses would not close the bond at the seam: courses are even.
#pragma once

#include <cstdint>

#include "heightfield/procedural/tile.h"

namespace plumb {

/// Defaults: a standard brick with its joint, 250 mm by 83 mm, on a 1 m tile.
struct Bricks {
    std::uint64_t seed = 1;
    int courses = 12;           ///< Rows of bricks a tile. even, in [2, 64]
    int bricks_per_course = 4;  ///< [1, 64]
    double mortar = 0.15;       ///< Width of a joint, in course heights. [0.02, 0.4]
    double edge = 0.07;         ///< Width of the ramp from joint to face. [0.01, 0.3]
    double chips = 0.5;         ///< How frayed and chipped the edges are. [0, 1]
    double unevenness = 0.4;    ///< How much levels and tilts of the faces differ. [0, 1]
    double relief = 0.4;        ///< Height of pores and noise on the faces. [0, 1]
};

/// Throws Error, naming the first field that breaks its range above.
void Validate(const Bricks& bricks);

/// z(u, v), period 1 in both. `bricks` must be valid.
double BricksHeight(const Bricks& bricks, double u, double v);

HeightField MakeBricks(const Bricks& bricks = {}, const Tile& tile = {});

}  // namespace plumb
