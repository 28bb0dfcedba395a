#include "heightfield/procedural/gravel.h"

#include <algorithm>
#include <cmath>

#include "core/conventions.h"
#include "heightfield/procedural/noise.h"

namespace plumb {
namespace {

using namespace procedural;

enum Stream : std::uint64_t { kStone = 1, kGrain, kBed };

constexpr double kTangentFrom = 0.95;  // q where the cap goes over into its tangent.

constexpr double kReach = 1.6;  // q where a stone ends, below the bed.
// Bends the tangent down: no stone's middle is above 0.5, so at kReach none is above the bed,
// which is never below -0.05.
constexpr double kBend = 0.6 / ((kReach - kTangentFrom) * (kReach - kTangentFrom));

double StoneHeight(double z_0, double c, double q) {
    if (q < kTangentFrom) return z_0 + c * std::sqrt(1 - q * q);
    const double beyond = q - kTangentFrom;
    const double z = std::sqrt(1 - kTangentFrom * kTangentFrom);
    return z_0 + c * (z - kTangentFrom / z * beyond) - kBend * beyond * beyond;
}

// The highest stone of one scale at (u, v), or `z` if none is higher.
double HighestStone(const Gravel& gravel, int scale, double u, double v, double z) {
    const int n = gravel.stones << scale;
    const double size = std::ldexp(1.0, -scale);
    const double x = u * n, y = v * n;
    const auto i0 = std::int64_t(x), j0 = std::int64_t(y);
    for (std::int64_t j = j0 - 2; j <= j0 + 2; ++j) {
        for (std::int64_t i = i0 - 2; i <= i0 + 2; ++i) {
            const std::uint64_t stone =
                Hash(gravel.seed, kStone + 64 * scale, Wrap(i, n), Wrap(j, n));
            auto r = [&](std::uint64_t k) { return Uniform(Mix(stone + k)); };
            const double dx = x - double(i) - r(1), dy = y - double(j) - r(2);
            // Half axes are at most 0.75: two cells on either side hold all that reach here.
            const double a = 0.45 + 0.3 * r(3);
            if (dx * dx + dy * dy > kReach * kReach * a * a) continue;
            const double b = a * (0.6 + 0.4 * r(4)), angle = kPi * r(5);
            const double c = 0.5 * (a + b) * (1 - gravel.flatness) * (0.8 + 0.4 * r(6)) * size;
            const double along = dx * std::cos(angle) + dy * std::sin(angle);
            const double across = dy * std::cos(angle) - dx * std::sin(angle);
            const double q = std::hypot(along / a, across / b);
            const double z_0 = (1 - size) * 0.15 + 0.5 * c * (r(7) - 0.5);
            const double here = StoneHeight(z_0, c, q);
            z = std::max(z, here);
        }
    }
    return z;
}

}  // namespace

void Validate(const Gravel& gravel) {
    RequireInRange("Gravel::stones", gravel.stones, 2, 64, "in [2, 64]");
    RequireInRange("Gravel::scales", gravel.scales, 1, 5, "in [1, 5]");
    RequireInRange("Gravel::flatness", gravel.flatness, 0, 0.9, "in [0, 0.9]");
    RequireInRange("Gravel::relief", gravel.relief, 0, 1, "in [0, 1]");
}

double GravelHeight(const Gravel& gravel, double u, double v) {
    u = Fraction(u), v = Fraction(v);
    const int n = gravel.stones;
    double z = 0.05 * Fbm(gravel.seed, kBed, u, v, {.n_x = 8 * n, .n_y = 8 * n, .count = 4});
    for (int scale = 0; scale < gravel.scales; ++scale)
        z = HighestStone(gravel, scale, u, v, z);
    const double grain =
        Fbm(gravel.seed, kGrain, u, v, {.n_x = 6 * n, .n_y = 6 * n, .count = 5, .gain = 0.65});
    return z + 0.12 * gravel.relief * grain;
}

HeightField MakeGravel(const Gravel& gravel, const Tile& tile) {
    Validate(gravel);
    return SampleTile(tile, [&](double u, double v) { return GravelHeight(gravel, u, v); });
}

}  // namespace plumb
