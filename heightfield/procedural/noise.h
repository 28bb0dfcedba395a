// Noise with period 1 in u and v, a pure function of seed and position.
//
//   Hash            64 bits of (seed, stream, i, j), a counter: no state, no order of drawing
//   GradientNoise   lattice of random gradients, joined by a quintic; |n| <= 1, n = 0 at nodes
//   Fbm             Sum_o gain^o n(2^o x) / Sum_o gain^o              |f| <= 1
//   RidgedFbm       Sum_o gain^o r_o / Sum_o gain^o,                  in [0, 1]
//                   r_o = max(0, 1 - 2 |n|)^2 min(1, 2 r_(o-1)): sharp crests, smooth valleys
//   NearestSite     the cell diagram of one jittered site a lattice cell
//
// Source   [Perlin02] K. Perlin, Improving Noise (quintic fade); [Worley96] S. Worley, A
//          Cellular Texture Basis Function; ridges: F. K. Musgrave in D. Ebert et al.,
//          Texturing and Modeling; the mixer is the finalizer of SplitMix64 (G. Steele
//          et al., Fast Splittable Pseudorandom Number Generators, 2014).
// Symbols  u, v position in tiles; x = n_x u lattice coordinate; o octave.
// Beware   Gradients are drawn from the square [-1, 1]^2, not from the circle: with unit
//          gradients 2D gradient noise stays within sqrt(1/2), so with these within 1.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace plumb {

namespace procedural {

/// Finalizer of SplitMix64: a bijection whose every output bit depends on every input bit.
constexpr std::uint64_t Mix(std::uint64_t h) {
    h ^= h >> 30;
    h *= 0xbf58476d1ce4e5b9u;
    h ^= h >> 27;
    h *= 0x94d049bb133111ebu;
    return h ^ (h >> 31);
}

/// 64 bits for lattice node (i, j) of a stream: each use of a seed has its own stream number.
constexpr std::uint64_t Hash(std::uint64_t seed, std::uint64_t stream, std::int64_t i,
                             std::int64_t j) {
    constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15u;
    std::uint64_t h = Mix(seed + kGolden);
    h = Mix(h + kGolden + stream);
    h = Mix(h + kGolden + std::uint64_t(i));
    return Mix(h + kGolden + std::uint64_t(j));
}

/// Uniform in [0, 1): 53 bits.
constexpr double Uniform(std::uint64_t hash) {
    return double(hash >> 11) * 0x1p-53;
}

constexpr double Uniform(std::uint64_t seed, std::uint64_t stream, std::int64_t i,
                         std::int64_t j) {
    return Uniform(Hash(seed, stream, i, j));
}

/// i modulo n, in [0, n).
constexpr std::int64_t Wrap(std::int64_t i, std::int64_t n) {
    const std::int64_t r = i % n;
    return r < 0 ? r + n : r;
}

/// u modulo 1, in [0, 1). Exact for every double whose fraction is not next to 1.
inline double Fraction(double u) {
    const double f = u - std::floor(u);
    return f < 1 ? f : 0;
}

/// 0 below a, 1 above b, 3t^2 - 2t^3 between.
constexpr double SmoothStep(double a, double b, double x) {
    const double t = x <= a ? 0 : x >= b ? 1 : (x - a) / (b - a);
    return t * t * (3 - 2 * t);
}

/// Gradient noise of n_x x n_y lattice cells a tile.
double GradientNoise(std::uint64_t seed, std::uint64_t stream, double u, double v, int n_x,
                     int n_y);

/// How many octaves a sum has, how much each adds to the one before, from which lattice on.
struct Octaves {
    int n_x = 4, n_y = 4;  ///< Lattice cells a tile in the first octave. [1, 4096]
    int count = 5;         ///< [1, 12]
    double gain = 0.5;     ///< Height of an octave over the one before. (0, 1]
};

double Fbm(std::uint64_t seed, std::uint64_t stream, double u, double v,
           const Octaves& octaves);
double RidgedFbm(std::uint64_t seed, std::uint64_t stream, double u, double v,
                 const Octaves& octaves);

/// Where (u, v) lies in the diagram of jittered sites, all lengths in lattice cells.
struct CellPoint {
    std::int64_t i = 0, j = 0;  ///< Lattice cell of the nearest site, wrapped: its identity.
    double dx = 0, dy = 0;      ///< From the nearest site to the point.
    double to_edge = 0;         ///< To the nearest cell border, at most kFarthestEdge.
    double to_rounded = 0;      ///< The same with corners rounded: see kRounding. <= to_edge
};

/// Borders farther than this are not looked for. A site outside the 7 x 7 lattice cells looked
/// at is 3 or more away, the nearest within sqrt(2), so their border is (3 - sqrt(2)) / 2 =
/// 0.79 or more away: to_edge is exact, and so continuous.
inline constexpr double kFarthestEdge = 0.79;

/// k of the soft minimum -1/k ln Sum exp(-k d) over the borders that are nearer than
/// kFarthestEdge, where each enters with nothing: smooth, and below 0 in corners.
inline constexpr double kRounding = 9;

/// `jitter` of [0, 1]: 0 = sites in the middle of their lattice cells, 1 = anywhere in them.
CellPoint NearestSite(std::uint64_t seed, std::uint64_t stream, double u, double v, int n_x,
                      int n_y, double jitter);

}  // namespace procedural
}  // namespace plumb
