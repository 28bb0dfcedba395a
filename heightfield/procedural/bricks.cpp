#include "heightfield/procedural/bricks.h"

#include <algorithm>
#include <cmath>

#include "heightfield/procedural/noise.h"

namespace plumb {
namespace {

using namespace procedural;

enum Stream : std::uint64_t { kBrick = 1, kFray, kChip, kMortar, kFace, kGrain, kPore };

}  // namespace

void Validate(const Bricks& bricks) {
    Require(bricks.courses >= 2 && bricks.courses <= 64 && bricks.courses % 2 == 0,
            "Bricks::courses", bricks.courses, "even and in [2, 64]");
    RequireInRange("Bricks::bricks_per_course", bricks.bricks_per_course, 1, 64, "in [1, 64]");
    RequireInRange("Bricks::mortar", bricks.mortar, 0.02, 0.4, "in [0.02, 0.4]");
    RequireInRange("Bricks::edge", bricks.edge, 0.01, 0.3, "in [0.01, 0.3]");
    RequireInRange("Bricks::chips", bricks.chips, 0, 1, "in [0, 1]");
    RequireInRange("Bricks::unevenness", bricks.unevenness, 0, 1, "in [0, 1]");
    RequireInRange("Bricks::relief", bricks.relief, 0, 1, "in [0, 1]");
}

double BricksHeight(const Bricks& bricks, double u, double v) {
    u = Fraction(u), v = Fraction(v);
    const int n = bricks.courses;
    const double length = double(n) / bricks.bricks_per_course;
    const double row = std::floor(v * n);
    const double along = u * bricks.bricks_per_course + 0.5 * double(std::int64_t(row) % 2);
    const double column = std::floor(along);
    const std::uint64_t brick =
        Hash(bricks.seed, kBrick, Wrap(std::int64_t(column), bricks.bricks_per_course),
             std::int64_t(row));
    auto r = [&](std::uint64_t k) { return Uniform(Mix(brick + k)) - 0.5; };

    // Laid by hand: out of place by up to 0.15 of a joint, out of line by 0.2 at its ends.
    const double joint = bricks.mortar;
    const double turn = 0.4 * bricks.unevenness * joint * r(1) / (length / 2);
    const double x_slot = (along - column - 0.5) * length, y_slot = v * n - row - 0.5;
    const double x0 = x_slot + 0.3 * bricks.unevenness * joint * r(2);
    const double y0 = y_slot + 0.3 * bricks.unevenness * joint * r(3);
    const double x = x0 - turn * y0, y = y0 + turn * x0;

    const double a = length / 2 - joint / 2, b = 0.5 - joint / 2, radius = 0.04;
    const double qx = std::abs(x) - a + radius, qy = std::abs(y) - b + radius;
    double depth = radius - std::hypot(std::max(qx, 0.0), std::max(qy, 0.0)) -
                   std::min(std::max(qx, qy), 0.0);
    depth += 0.15 * joint * bricks.chips *
             Fbm(bricks.seed, kFray, u, v, {.n_x = 4 * n, .n_y = 4 * n, .count = 4});
    const double chip = Fbm(brick, kChip, u, v, {.n_x = 2 * n, .n_y = 2 * n, .count = 3});
    depth -= 0.3 * bricks.chips * SmoothStep(0.05, 0.4, chip);

    const double mortar =
        0.1 + 0.2 * Fbm(bricks.seed, kMortar, u, v, {.n_x = 4 * n, .n_y = 4 * n, .gain = 0.75});
    // The face jumps on the border to the next brick; there p is 0, so that z does not.
    const double to_next = std::min(length / 2 - std::abs(x_slot), 0.5 - std::abs(y_slot));
    const double p = SmoothStep(0, bricks.edge, std::min(depth, to_next));
    if (p <= 0) return mortar;
    const double swell = Fbm(brick, kFace, u, v, {.n_x = n, .n_y = 2 * n, .count = 4});
    const double grain =
        Fbm(bricks.seed, kGrain, u, v, {.n_x = 8 * n, .n_y = 8 * n, .count = 3, .gain = 0.7});
    const double pore = SmoothStep(0.2, 0.5, GradientNoise(brick, kPore, u, v, 6 * n, 6 * n));
    const double face =
        0.85 + bricks.unevenness * (0.25 * r(4) + 0.2 * r(5) * x / a + 0.15 * r(6) * y / b) -
        0.08 * std::exp(-depth / (2 * bricks.edge)) +
        bricks.relief * (0.4 * swell + 0.22 * grain - 0.4 * pore);
    return mortar + p * (face - mortar);
}

HeightField MakeBricks(const Bricks& bricks, const Tile& tile) {
    Validate(bricks);
    return SampleTile(tile, [&](double u, double v) { return BricksHeight(bricks, u, v); });
}

}  // namespace plumb
