// Hexagonal floor tiles: bevelled, with joints, each a little out of level.
//
//   z = grout + (tile - grout) SmoothStep(0, bevel, depth inside the hexagon),
//   tile = level + tilt . (dx, dy) + noise
//
// Source   Ours.
// Symbols  u, v position in tiles, period 1; lengths in distances between hexagon centres.
// Domain   Any u, v. The result lies in about [0, 1]; MakeHexTiles stretches it to the
//          amplitude.
// Beware   Regular hexagons do not close on a square tile: rows stand sqrt(3)/2 apart, so
//          columns : rows should be near 0.866 and the rest is taken up by stretching
//          (1 % at the default 7 : 8). Rows are even, or the seam would not close.
#pragma once

#include <cstdint>

#include "heightfield/procedural/tile.h"

namespace plumb {

/// Defaults: chosen by eye; tiles of 14 cm on a 1 m tile of ground.
struct HexTiles {
    std::uint64_t seed = 1;
    int columns = 7;          ///< Hexagons along x. [1, 128]
    int rows = 8;             ///< Hexagons along y. even, in [2, 128]
    double joint = 0.06;      ///< Width of a joint. [0, 0.4]
    double bevel = 0.08;      ///< Width of the bevel. [0.01, 0.4]
    double unevenness = 0.5;  ///< How much levels and tilts differ. [0, 1]
    double relief = 0.1;      ///< Height of the noise on the tiles. [0, 1]
};

/// Throws Error, naming the first field that breaks its range above.
void Validate(const HexTiles& tiles);

/// z(u, v), period 1 in both. `tiles` must be valid.
double HexTilesHeight(const HexTiles& tiles, double u, double v);

HeightField MakeHexTiles(const HexTiles& tiles = {}, const Tile& tile = {});

}  // namespace plumb
