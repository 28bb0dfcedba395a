// The rectangle of ground that a procedural surface is sampled on.
//
// A generator is a function of (u, v) with period 1 in both: what it shows does not depend on
// the number of texels, only how finely it is shown. Texel (i, j) samples it at
// u = (i + 1/2) / width_texels, v = (j + 1/2) / height_texels.
//
// Beware   Features are defined in (u, v): a tile that is not square stretches them.
//          Heights are stretched so that highest - lowest of the samples is amplitude_m to the
//          rounding of a double; finer samples find higher tops, so the scale (never the shape)
//          of a tile depends a little on the number of texels.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>

#include "core/error.h"
#include "core/parallel.h"
#include "heightfield/height_field.h"

namespace plumb {

struct Tile {
    int width_texels = 256;    ///< [2, 16384]
    int height_texels = 256;   ///< [2, 16384]
    double width_m = 1;        ///< Extent along x, one period. (0, ...)
    double height_m = 1;       ///< Extent along y, one period. (0, ...)
    double amplitude_m = 0.1;  ///< Highest minus lowest. (0, ...)
};

namespace procedural {

/// Throws Error "thing = value, must be rule" unless `holds`.
inline void Require(bool holds, const char* thing, double value, const char* rule) {
    if (!holds) throw Error(MustBe(thing, value, rule));
}

/// For a field with the range [low, high]; nan is outside every range.
inline void RequireInRange(const char* thing, double value, double low, double high,
                           const char* rule) {
    Require(value >= low && value <= high, thing, value, rule);
}

}  // namespace procedural

inline void Validate(const Tile& tile) {
    procedural::RequireInRange("Tile::width_texels", tile.width_texels, 2, 16384,
                               "in [2, 16384]");
    procedural::RequireInRange("Tile::height_texels", tile.height_texels, 2, 16384,
                               "in [2, 16384]");
    for (const auto& [thing, value_m] :
         {std::pair{"Tile::width_m", tile.width_m}, std::pair{"Tile::height_m", tile.height_m},
          std::pair{"Tile::amplitude_m", tile.amplitude_m}})
        procedural::Require(value_m > 0 && std::isfinite(value_m), thing, value_m,
                            "finite and > 0");
}

/// The wrapped field of heights z(u, v), stretched to the amplitude of the tile.
template <class HeightOfUv>
HeightField SampleTile(const Tile& tile, const HeightOfUv& z) {
    Validate(tile);
    Image<double> heights(tile.width_texels, tile.height_texels);
    ParallelFor(tile.height_texels, 1, [&](std::int64_t begin, std::int64_t end) {
        for (int j = int(begin); j < int(end); ++j)
            for (int i = 0; i < tile.width_texels; ++i)
                heights(i, j) =
                    z((i + 0.5) / tile.width_texels, (j + 0.5) / tile.height_texels);
    });
    return WithAmplitude(HeightField(std::move(heights), tile.width_m / tile.width_texels,
                                     tile.height_m / tile.height_texels, Boundary::kWrap),
                         tile.amplitude_m);
}

}  // namespace plumb
