// A rubble wall: rough stones of many sizes in uneven courses, deep joints of mortar between.
//
//   z = (1 - p) mortar + p stone,     p = SmoothStep(0, edge, depth inside the stone's outline)
//
// A course is a row of stones with borders of its own; some stones are two, one on the other.
// Outlines are rounded boxes, bent by noise. A face has a level, a tilt, a few flat facets
// where it was split, and noise of many octaves that starts anew on every stone.
//
// Source   Ours. [Mayaux18] recommends "noisy" height maps and got its best results on a highly
//          detailed wall, of amplitude about a tenth of the size: this is the stand-in for it.
// Symbols  u, v position in tiles, period 1; lengths in mean course heights.
// Domain   Any u, v. The result lies in about [0, 1]; MakeStoneWall stretches it to the
//          amplitude.
// Beware   The walls of the stones are ramps of width `edge`: sample finer than that, or they
//          become ramps of one texel.
#pragma once

#include <cstdint>

#include "heightfield/procedural/tile.h"

namespace plumb {

/// Defaults: chosen by eye for a 1 m tile of dressed rubble, 20 cm by 14 cm a stone.
struct StoneWall {
    std::uint64_t seed = 1;
    int courses = 7;            ///< Rows of stones a tile. [2, 64]
    int stones_per_course = 5;  ///< On average. [2, 64]
    double irregularity = 0.8;  ///< 0 = a grid of equal boxes, 1 = rubble. [0, 1]
    double mortar = 0.12;       ///< Width of a joint, in course heights. [0.02, 0.4]
    double edge = 0.09;         ///< Width of the ramp from joint to face. [0.01, 0.3]
    double unevenness = 0.5;    ///< How much levels and tilts of the faces differ. [0, 1]
    double relief = 0.5;        ///< Height of facets and noise on the faces. [0, 1]
};

/// Throws Error, naming the first field that breaks its range above.
void Validate(const StoneWall& wall);

/// z(u, v), period 1 in both. `wall` must be valid.
double StoneWallHeight(const StoneWall& wall, double u, double v);

HeightField MakeStoneWall(const StoneWall& wall = {}, const Tile& tile = {});

}  // namespace plumb
