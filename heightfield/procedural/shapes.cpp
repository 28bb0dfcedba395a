#include "heightfield/procedural/shapes.h"

#include <algorithm>
#include <cmath>

#include "core/conventions.h"
#include "heightfield/procedural/noise.h"

namespace plumb {
namespace {

using namespace procedural;

enum Stream : std::uint64_t { kSolid = 1 };

enum class Solid { kBox, kCylinder, kDome, kPyramid, kCone };
constexpr int kSolids = 5;

// Height over h of the solid at (x, y) from its middle, turned into its axes; `a` and `b` are
// its half axes.
double Profile(Solid solid, double x, double y, double a, double b, double edge) {
    const double r = std::hypot(x, y);
    switch (solid) {
        case Solid::kBox:
            return std::clamp(std::min(a - std::abs(x), b - std::abs(y)) / edge, 0.0, 1.0);
        case Solid::kCylinder:
            return std::clamp((a - r) / edge, 0.0, 1.0);
        case Solid::kDome:
            return std::sqrt(std::max(0.0, 1 - r * r / (a * a)));
        case Solid::kPyramid:
            return std::max(0.0, 1 - std::max(std::abs(x), std::abs(y)) / a);
        case Solid::kCone:
            return std::max(0.0, 1 - r / a);
    }
    return 0;
}

}  // namespace

void Validate(const Shapes& shapes) {
    RequireInRange("Shapes::solids", shapes.solids, 1, 64, "in [1, 64]");
    RequireInRange("Shapes::edge", shapes.edge, 0.005, 0.2, "in [0.005, 0.2]");
}

double ShapesHeight(const Shapes& shapes, double u, double v) {
    const int n = shapes.solids;
    const double x = Fraction(u) * n, y = Fraction(v) * n;
    const auto i0 = std::int64_t(x), j0 = std::int64_t(y);
    double z = 0;
    // No solid reaches farther than 0.52 sqrt(2) + 0.15 from the middle of its lattice cell, so
    // one cell on either side holds all that stand here.
    for (std::int64_t j = j0 - 1; j <= j0 + 1; ++j) {
        for (std::int64_t i = i0 - 1; i <= i0 + 1; ++i) {
            const std::uint64_t id = Hash(shapes.seed, kSolid, Wrap(i, n), Wrap(j, n));
            auto r = [&](std::uint64_t k) { return Uniform(Mix(id + k)); };
            const double dx = x - double(i) - 0.5 - 0.2 * (r(1) - 0.5);
            const double dy = y - double(j) - 0.5 - 0.2 * (r(2) - 0.5);
            const double turn = kPi * r(3);
            const double along = dx * std::cos(turn) + dy * std::sin(turn);
            const double across = dy * std::cos(turn) - dx * std::sin(turn);
            const double a = 0.32 + 0.2 * r(4), b = a * (0.5 + 0.5 * r(5));
            // A cell's kind follows its neighbours' in a fixed round, shifted by the seed:
            // every tile of 5 or more solids has every kind.
            const auto kind = std::int64_t(Uniform(shapes.seed, kSolid, -1, -1) * kSolids) +
                              Wrap(i, n) + 2 * Wrap(j, n);
            z = std::max(z, (0.35 + 0.65 * r(6)) * Profile(Solid(Wrap(kind, kSolids)), along,
                                                           across, a, b, shapes.edge));
        }
    }
    return z;
}

HeightField MakeShapes(const Shapes& shapes, const Tile& tile) {
    Validate(shapes);
    return SampleTile(tile, [&](double u, double v) { return ShapesHeight(shapes, u, v); });
}

}  // namespace plumb
