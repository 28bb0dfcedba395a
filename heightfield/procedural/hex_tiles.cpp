#include "heightfield/procedural/hex_tiles.h"

#include <algorithm>
#include <cmath>

#include "heightfield/procedural/noise.h"

namespace plumb {
namespace {

using namespace procedural;

enum Stream : std::uint64_t { kTile = 1, kGrout, kFace };

constexpr double kRowPitch = 0.86602540378443865;  // sqrt(3) / 2: between rows of hexagons.

struct Hexagon {
    std::int64_t column = 0, row = 0;
    double dx = 0, dy = 0;  // From its middle to the point.
};

Hexagon NearestHexagon(const HexTiles& tiles, double u, double v) {
    const double x = u * tiles.columns, y = v * tiles.rows;
    Hexagon best;
    double best_squared = 4;
    const auto row = std::int64_t(std::floor(y));
    for (std::int64_t j = row - 1; j <= row + 1; ++j) {
        const double shift = 0.5 * double(Wrap(j, 2)) + 0.5;
        const double column = std::floor(x - shift + 0.5);
        const double dx = x - shift - column, dy = (y - double(j) - 0.5) * kRowPitch;
        if (dx * dx + dy * dy < best_squared) {
            best_squared = dx * dx + dy * dy;
            best = {Wrap(std::int64_t(column), tiles.columns), Wrap(j, tiles.rows), dx, dy};
        }
    }
    return best;
}

}  // namespace

void Validate(const HexTiles& tiles) {
    RequireInRange("HexTiles::columns", tiles.columns, 1, 128, "in [1, 128]");
    Require(tiles.rows >= 2 && tiles.rows <= 128 && tiles.rows % 2 == 0, "HexTiles::rows",
            tiles.rows, "even and in [2, 128]");
    RequireInRange("HexTiles::joint", tiles.joint, 0, 0.4, "in [0, 0.4]");
    RequireInRange("HexTiles::bevel", tiles.bevel, 0.01, 0.4, "in [0.01, 0.4]");
    RequireInRange("HexTiles::unevenness", tiles.unevenness, 0, 1, "in [0, 1]");
    RequireInRange("HexTiles::relief", tiles.relief, 0, 1, "in [0, 1]");
}

double HexTilesHeight(const HexTiles& tiles, double u, double v) {
    u = Fraction(u), v = Fraction(v);
    const Hexagon hexagon = NearestHexagon(tiles, u, v);
    const double dx = hexagon.dx, dy = hexagon.dy;
    const double from_middle =
        std::max(std::abs(dx), 0.5 * std::abs(dx) + kRowPitch * std::abs(dy));
    const double p = SmoothStep(0, tiles.bevel, 0.5 - from_middle - tiles.joint / 2);

    const int n = tiles.columns;
    const double grout = 0.2 + 0.2 * Fbm(tiles.seed, kGrout, u, v,
                                         {.n_x = 8 * n, .n_y = 8 * n, .count = 4, .gain = 0.7});
    const std::uint64_t id = Hash(tiles.seed, kTile, hexagon.column, hexagon.row);
    auto r = [&](std::uint64_t k) { return Uniform(Mix(id + k)) - 0.5; };
    const double face =
        0.85 + tiles.unevenness * (0.25 * r(1) + 0.5 * r(2) * dx + 0.5 * r(3) * dy) +
        tiles.relief *
            Fbm(id, kFace, u, v, {.n_x = 2 * n, .n_y = 2 * n, .count = 6, .gain = 0.6});
    return grout + p * (face - grout);
}

HeightField MakeHexTiles(const HexTiles& tiles, const Tile& tile) {
    Validate(tiles);
    return SampleTile(tile, [&](double u, double v) { return HexTilesHeight(tiles, u, v); });
}

}  // namespace plumb
