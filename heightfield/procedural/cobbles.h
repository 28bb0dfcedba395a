// Cobbles: round-topped stones set close to each other, sand in the joints.
//
//   z = max(sand, dome (level + tilt + noise))
//   dome = (1 - (1 - t)^3) sqrt(1 - r^2 / S^2),     t = (e - gap) / R in [0, 1]
//
// Stones are the cells of a jittered lattice, their borders bent by noise.
//
// Source   Ours; the cells are [Worley96]'s (noise.h).
// Symbols  u, v position in tiles, period 1; e distance to the cell border, its corners
//          rounded, r to the middle of the stone, R = 0.3 reach of the flank, S = 0.85: lengths
//          in lattice cells.
// Domain   Any u, v. The result lies in about [0, 1]; MakeCobbles stretches it to the
//          amplitude.
#pragma once

#include <cstdint>

#include "heightfield/procedural/tile.h"

namespace plumb {

/// Defaults: chosen by eye; setts of 11 cm on a 1 m tile.
struct Cobbles {
    std::uint64_t seed = 1;
    int stones = 9;           ///< Along either side of the tile. [2, 128]
    double jitter = 0.5;      ///< 0 = a square grid, 1 = anywhere in the lattice cell. [0, 1]
    double gap = 0;           ///< Added to half the width of every joint. [0, 0.2]
    double unevenness = 0.4;  ///< How much levels and tilts of the stones differ. [0, 1]
    double relief = 0.3;      ///< Height of the noise on the stones. [0, 1]
};

/// Throws Error, naming the first field that breaks its range above.
void Validate(const Cobbles& cobbles);

/// z(u, v), period 1 in both. `cobbles` must be valid.
double CobblesHeight(const Cobbles& cobbles, double u, double v);

HeightField MakeCobbles(const Cobbles& cobbles = {}, const Tile& tile = {});

}  // namespace plumb
