#include "heightfield/procedural/terrain.h"

#include "heightfield/procedural/noise.h"

namespace plumb {
namespace {

using namespace procedural;

enum Stream : std::uint64_t { kHills = 1, kBendU, kBendV };

}  // namespace

void Validate(const Terrain& terrain) {
    RequireInRange("Terrain::features", terrain.features, 1, 64, "in [1, 64]");
    RequireInRange("Terrain::octaves", terrain.octaves, 1, 10, "in [1, 10]");
    RequireInRange("Terrain::roughness", terrain.roughness, 0.1, 1, "in [0.1, 1]");
    RequireInRange("Terrain::ridges", terrain.ridges, 0, 1, "in [0, 1]");
    RequireInRange("Terrain::bending", terrain.bending, 0, 1, "in [0, 1]");
}

double TerrainHeight(const Terrain& terrain, double u, double v) {
    u = Fraction(u), v = Fraction(v);
    const int n = terrain.features;
    const Octaves bends{.n_x = n, .n_y = n, .count = 3};
    const double bend = terrain.bending / n;
    const double bent_u = u + bend * Fbm(terrain.seed, kBendU, u, v, bends);
    const double bent_v = v + bend * Fbm(terrain.seed, kBendV, u, v, bends);
    const Octaves octaves{
        .n_x = n, .n_y = n, .count = terrain.octaves, .gain = terrain.roughness};
    const double rolling = Fbm(terrain.seed, kHills, bent_u, bent_v, octaves);
    const double ridged = RidgedFbm(terrain.seed, kHills, bent_u, bent_v, octaves);
    return (1 - terrain.ridges) * (0.5 + 0.5 * rolling) + terrain.ridges * ridged;
}

HeightField MakeTerrain(const Terrain& terrain, const Tile& tile) {
    Validate(terrain);
    return SampleTile(tile, [&](double u, double v) { return TerrainHeight(terrain, u, v); });
}

}  // namespace plumb
