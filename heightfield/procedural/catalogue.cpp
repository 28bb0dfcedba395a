#include "heightfield/procedural/catalogue.h"

#include <array>
#include <string>

#include "core/names.h"
#include "heightfield/procedural/bricks.h"
#include "heightfield/procedural/cobbles.h"
#include "heightfield/procedural/gravel.h"
#include "heightfield/procedural/hex_tiles.h"
#include "heightfield/procedural/shapes.h"
#include "heightfield/procedural/stone_wall.h"
#include "heightfield/procedural/terrain.h"

namespace plumb {
namespace {

// [Mayaux18] advises an amplitude of about a tenth of the size.
constexpr double kTenth = 0.1;

const std::array<ProceduralKind, 8> kKinds{{
    {"stone_wall", "rubble wall: rough stones of many sizes, deep joints", kTenth,
     [](std::uint64_t seed, const Tile& tile) { return MakeStoneWall({.seed = seed}, tile); }},
    {"bricks", "brick wall in running bond, chipped, with mortar joints", kTenth,
     [](std::uint64_t seed, const Tile& tile) { return MakeBricks({.seed = seed}, tile); }},
    {"cobbles", "round-topped cobbles with sand in the joints", kTenth,
     [](std::uint64_t seed, const Tile& tile) { return MakeCobbles({.seed = seed}, tile); }},
    {"gravel", "pebbles of several sizes lying over each other", kTenth,
     [](std::uint64_t seed, const Tile& tile) { return MakeGravel({.seed = seed}, tile); }},
    {"hex_tiles", "bevelled hexagonal tiles, each a little out of level", 0.03,
     [](std::uint64_t seed, const Tile& tile) { return MakeHexTiles({.seed = seed}, tile); }},
    {"terrain", "rolling fractal hills", 0.25,
     [](std::uint64_t seed, const Tile& tile) { return MakeTerrain({.seed = seed}, tile); }},
    {"ridges", "fractal mountains with sharp crests", 0.25,
     [](std::uint64_t seed, const Tile& tile) {
         return MakeTerrain({.seed = seed, .ridges = 1}, tile);
     }},
    {"shapes", "boxes, cylinders, domes, pyramids and cones on level ground",
     Shapes::kAmplitudePerWidth,
     [](std::uint64_t seed, const Tile& tile) { return MakeShapes({.seed = seed}, tile); }},
}};

}  // namespace

std::span<const ProceduralKind> ProceduralKinds() {
    return kKinds;
}

const ProceduralKind& ProceduralKindNamed(std::string_view name) {
    return FindNamed(
        kKinds, [](const ProceduralKind& kind) { return kind.name; }, name,
        "procedural surface \"" + std::string(name) + "\"");
}

Tile AdvisedTile(const ProceduralKind& kind, int width_texels, int height_texels) {
    Tile tile{.width_texels = width_texels, .height_texels = height_texels};
    tile.amplitude_m = kind.amplitude_per_width * tile.width_m;
    return tile;
}

}  // namespace plumb
