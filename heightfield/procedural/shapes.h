// Boxes, cylinders, domes, pyramids and cones on level ground: large plane and smooth faces,
// deep corners.
//
//   z = max over solids of  h profile(position in the footprint)
//
// A solid stands in each lattice cell, of random kind, size, height and turn, near enough to
// its neighbours to run into them now and then.
//
// Source   Ours, to [Mayaux18]'s figures: a texture of 1 m x 1 m, up to 45 cm high.
// Symbols  u, v position in tiles, period 1; h height over the highest possible; lengths in
//          lattice cells.
// Domain   Any u, v. The result lies in [0, 1]; MakeShapes stretches it to the amplitude.
// Beware   Walls of boxes and cylinders are ramps of width `edge`; a dome meets the ground
//          upright. The default tile is 45 cm high, not 10. A tile of very few texels may miss
//          every solid; it is then flat and has no amplitude, which is an Error.
#pragma once

#include <cstdint>

#include "heightfield/procedural/tile.h"

namespace plumb {

/// Defaults: chosen by eye; solids 13 to 21 cm wide on a 1 m tile.
struct Shapes {
    std::uint64_t seed = 1;
    int solids = 5;      ///< Along either side of the tile. [1, 64]
    double edge = 0.03;  ///< Width of the ramp that stands for a wall. [0.005, 0.2]

    static constexpr double kAmplitudePerWidth = 0.45;  ///< Of the default tile.
};

/// Throws Error, naming the first field that breaks its range above.
void Validate(const Shapes& shapes);

/// z(u, v), period 1 in both. `shapes` must be valid.
double ShapesHeight(const Shapes& shapes, double u, double v);

HeightField MakeShapes(const Shapes& shapes = {},
                       const Tile& tile = {.amplitude_m = Shapes::kAmplitudePerWidth});

}  // namespace plumb
