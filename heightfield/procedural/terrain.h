// Fractal terrain: gradient noise summed over octaves, rolling hills to sharp ridges.
//
//   z = (1 - ridges) (1 + Fbm) / 2 + ridges RidgedFbm        (noise.h)
//
// with the octaves o on lattices of n_0 2^o cells a tile, sampled at a position that broader
// noise has bent, so that valleys wind.
//
// Source   Fractional Brownian motion as in F. K. Musgrave's chapters of D. Ebert et al.,
//          Texturing and Modeling; ridges by 1 - |n| are from there too.
// Symbols  u, v position in tiles, period 1; g = roughness, n_0 = features, o octave.
// Domain   Any u, v. The result lies in [0, 1]; MakeTerrain stretches it to the amplitude.
// Beware   Octaves are a fixed number, not up to the texel: finer sampling adds no detail.
#pragma once

#include <cstdint>

#include "heightfield/procedural/tile.h"

namespace plumb {

/// Defaults: chosen by eye; g = 0.5 is the fractal dimension 2 (smooth), 0.7 is 2.5 (rocky).
struct Terrain {
    std::uint64_t seed = 1;
    int features = 3;        ///< Lattice cells of the broadest octave along a side. [1, 64]
    int octaves = 7;         ///< [1, 10]
    double roughness = 0.5;  ///< g, height of an octave over the one before. [0.1, 1]
    double ridges = 0;       ///< 0 = rolling, 1 = every crest sharp. [0, 1]
    double bending = 0.3;    ///< How far positions are bent, in lattice cells. [0, 1]
};

/// Throws Error, naming the first field that breaks its range above.
void Validate(const Terrain& terrain);

/// z(u, v), period 1 in both. `terrain` must be valid.
double TerrainHeight(const Terrain& terrain, double u, double v);

HeightField MakeTerrain(const Terrain& terrain = {}, const Tile& tile = {});

}  // namespace plumb
