// Gravel: a bed of rounded pebbles of several sizes, lying over each other.
//
//   z = max over stones of  z_0 + c cap(q),   cap(q) = sqrt(1 - q^2)
//
// A stone is an ellipsoid, turned at random, of half axes (a, b) in plan and c upright, its
// middle at the height z_0; q is the elliptical distance from its middle, 1 on its outline.
// Sizes halve from one scale to the next, and small stones fill the gaps of large ones.
//
// Source   Ours.
// Symbols  u, v position in tiles, period 1; lengths in lattice cells of the largest scale.
// Domain   Any u, v. The result lies in about [0, 1]; MakeGravel stretches it to the amplitude.
// Beware   Beyond q = 0.95 the cap falls along its tangent (slope -3.04 c / a), bent down to
//          end below the bed, instead of overhanging: z is continuous.
#pragma once

#include <cstdint>

#include "heightfield/procedural/tile.h"

namespace plumb {

/// Defaults: chosen by eye; the largest pebbles are 13 to 21 cm long on a 1 m tile.
struct Gravel {
    std::uint64_t seed = 1;
    int stones = 7;         ///< Of the largest scale, along either side of the tile. [2, 64]
    int scales = 4;         ///< Sizes, each half of the one before. [1, 5]
    double flatness = 0.4;  ///< 0 = as high as wide, 1 = level flakes. [0, 0.9]
    double relief = 0.25;   ///< Height of the noise on the stones. [0, 1]
};

/// Throws Error, naming the first field that breaks its range above.
void Validate(const Gravel& gravel);

/// z(u, v), period 1 in both. `gravel` must be valid.
double GravelHeight(const Gravel& gravel, double u, double v);

HeightField MakeGravel(const Gravel& gravel = {}, const Tile& tile = {});

}  // namespace plumb
