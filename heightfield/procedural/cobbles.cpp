#include "heightfield/procedural/cobbles.h"

#include <algorithm>
#include <cmath>

#include "heightfield/procedural/noise.h"

namespace plumb {
namespace {

using namespace procedural;

enum Stream : std::uint64_t { kSite = 1, kStone, kBendU, kBendV, kSand, kFace, kGrain };

constexpr double kFlank = 0.3;    // R: how far in a stone's flank reaches.
constexpr double kSphere = 0.85;  // Radius of the cap; corners of cells lie beyond it.

}  // namespace

void Validate(const Cobbles& cobbles) {
    RequireInRange("Cobbles::stones", cobbles.stones, 2, 128, "in [2, 128]");
    RequireInRange("Cobbles::jitter", cobbles.jitter, 0, 1, "in [0, 1]");
    RequireInRange("Cobbles::gap", cobbles.gap, 0, 0.2, "in [0, 0.2]");
    RequireInRange("Cobbles::unevenness", cobbles.unevenness, 0, 1, "in [0, 1]");
    RequireInRange("Cobbles::relief", cobbles.relief, 0, 1, "in [0, 1]");
}

double CobblesHeight(const Cobbles& cobbles, double u, double v) {
    u = Fraction(u), v = Fraction(v);
    const int n = cobbles.stones;
    const Octaves bends{.n_x = 2 * n, .n_y = 2 * n, .count = 3};
    const double bend = 0.12 / n;
    const CellPoint cell =
        NearestSite(cobbles.seed, kSite, u + bend * Fbm(cobbles.seed, kBendU, u, v, bends),
                    v + bend * Fbm(cobbles.seed, kBendV, u, v, bends), n, n, cobbles.jitter);

    const double sand =
        0.15 + 0.15 * Fbm(cobbles.seed, kSand, u, v, {.n_x = 4 * n, .n_y = 4 * n, .gain = 0.7});
    const double t = std::clamp((cell.to_rounded - cobbles.gap) / kFlank, 0.0, 1.0);
    if (t <= 0) return sand;

    const std::uint64_t stone = Hash(cobbles.seed, kStone, cell.i, cell.j);
    auto r = [&](std::uint64_t k) { return Uniform(Mix(stone + k)) - 0.5; };
    const double r_squared = cell.dx * cell.dx + cell.dy * cell.dy;
    const double cap = std::sqrt(std::max(0.0, 1 - r_squared / (kSphere * kSphere)));
    const double dome = (1 - (1 - t) * (1 - t) * (1 - t)) * cap;
    const double level =
        0.9 + cobbles.unevenness * (0.35 * r(1) + 0.6 * r(2) * cell.dx + 0.6 * r(3) * cell.dy);
    const double noise = 0.4 * Fbm(stone, kFace, u, v, {.n_x = 2 * n, .n_y = 2 * n}) +
                         0.25 * Fbm(cobbles.seed, kGrain, u, v,
                                    {.n_x = 12 * n, .n_y = 12 * n, .count = 3, .gain = 0.7});
    // 0 at t = 0, below the sand: every stone comes up through it, none jumps at a border.
    return std::max(sand, dome * (level + cobbles.relief * noise));
}

HeightField MakeCobbles(const Cobbles& cobbles, const Tile& tile) {
    Validate(cobbles);
    return SampleTile(tile, [&](double u, double v) { return CobblesHeight(cobbles, u, v); });
}

}  // namespace plumb
