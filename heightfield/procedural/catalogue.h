// The procedural surfaces by name, for the command line and the reports.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "heightfield/procedural/tile.h"

namespace plumb {

struct ProceduralKind {
    std::string_view name;         ///< "stone_wall": lower case, no blanks.
    std::string_view description;  ///< One line, no full stop.
    double amplitude_per_width;    ///< Advised Tile::amplitude_m over Tile::width_m.
    HeightField (*make)(std::uint64_t seed, const Tile& tile);  ///< All else at its default.
};

/// Every kind, in a fixed order.
std::span<const ProceduralKind> ProceduralKinds();

/// The kind of that name. Throws Error, listing the names, if there is none.
const ProceduralKind& ProceduralKindNamed(std::string_view name);

/// A tile of the kind's advised amplitude and else default size.
Tile AdvisedTile(const ProceduralKind& kind, int width_texels, int height_texels);

}  // namespace plumb
