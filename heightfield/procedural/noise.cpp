#include "heightfield/procedural/noise.h"

#include <algorithm>

namespace plumb::procedural {
namespace {

constexpr double Fade(double t) {
    return t * t * t * (t * (t * 6 - 15) + 10);
}

constexpr double Lerp(double a, double b, double t) {
    return a + t * (b - a);
}

}  // namespace

double GradientNoise(std::uint64_t seed, std::uint64_t stream, double u, double v, int n_x,
                     int n_y) {
    const double x = Fraction(u) * n_x, y = Fraction(v) * n_y;
    const double i = std::floor(x), j = std::floor(y);
    const double fx = x - i, fy = y - j;
    auto corner = [&](int di, int dj) {
        const std::uint64_t h = Hash(seed, stream, Wrap(std::int64_t(i) + di, n_x),
                                     Wrap(std::int64_t(j) + dj, n_y));
        const double g_x = double(h >> 32) * 0x1p-31 - 1;
        const double g_y = double(h & 0xffffffffu) * 0x1p-31 - 1;
        return g_x * (fx - di) + g_y * (fy - dj);
    };
    const double a = Lerp(corner(0, 0), corner(1, 0), Fade(fx));
    const double b = Lerp(corner(0, 1), corner(1, 1), Fade(fx));
    return Lerp(a, b, Fade(fy));
}

namespace {

// Gradient noise of octave o. Octaves of one sum must not share gradients, and as noise is 0 on
// its nodes, not nodes either: each has its own stream and its own shift.
double Octave(std::uint64_t seed, std::uint64_t stream, double u, double v,
              const Octaves& octaves, int o) {
    const std::uint64_t octave_stream = stream * 64 + o;
    return GradientNoise(seed, octave_stream, u + Uniform(seed, octave_stream, -1, 0),
                         v + Uniform(seed, octave_stream, 0, -1), octaves.n_x << o,
                         octaves.n_y << o);
}

}  // namespace

double Fbm(std::uint64_t seed, std::uint64_t stream, double u, double v,
           const Octaves& octaves) {
    double sum = 0, norm = 0, weight = 1;
    for (int o = 0; o < octaves.count; ++o) {
        sum += weight * Octave(seed, stream, u, v, octaves, o);
        norm += weight;
        weight *= octaves.gain;
    }
    return sum / norm;
}

double RidgedFbm(std::uint64_t seed, std::uint64_t stream, double u, double v,
                 const Octaves& octaves) {
    double sum = 0, norm = 0, weight = 1, below = 1;
    for (int o = 0; o < octaves.count; ++o) {
        const double crest =
            std::max(0.0, 1 - 2 * std::abs(Octave(seed, stream, u, v, octaves, o)));
        const double r = crest * crest * below;
        sum += weight * r;
        norm += weight;
        weight *= octaves.gain;
        below = std::min(1.0, 2 * r);
    }
    return sum / norm;
}

CellPoint NearestSite(std::uint64_t seed, std::uint64_t stream, double u, double v, int n_x,
                      int n_y, double jitter) {
    constexpr int kReach = 3;
    constexpr int kSide = 2 * kReach + 1;
    struct Site {
        double dx, dy;  // From the point to the site.
        std::int64_t i, j;
    };
    const double x = Fraction(u) * n_x, y = Fraction(v) * n_y;
    const auto i0 = std::int64_t(x), j0 = std::int64_t(y);
    std::array<Site, kSide * kSide> sites;
    int nearest = 0, count = 0;
    auto squared = [](const Site& s) { return s.dx * s.dx + s.dy * s.dy; };
    for (std::int64_t j = j0 - kReach; j <= j0 + kReach; ++j) {
        for (std::int64_t i = i0 - kReach; i <= i0 + kReach; ++i) {
            const std::uint64_t h = Hash(seed, stream, Wrap(i, n_x), Wrap(j, n_y));
            const double r = double(h >> 32) * 0x1p-32, s = double(h & 0xffffffffu) * 0x1p-32;
            sites[count] = {double(i) + 0.5 + jitter * (r - 0.5) - x,
                            double(j) + 0.5 + jitter * (s - 0.5) - y, Wrap(i, n_x),
                            Wrap(j, n_y)};
            if (squared(sites[count]) < squared(sites[nearest])) nearest = count;
            ++count;
        }
    }
    const Site& a = sites[nearest];
    double to_edge = kFarthestEdge, near_edges = 0;
    for (const Site& b : sites) {
        // The border of a and b is their bisector, (|b|^2 - |a|^2) / (2 |b - a|) away.
        const double between =
            std::sqrt((b.dx - a.dx) * (b.dx - a.dx) + (b.dy - a.dy) * (b.dy - a.dy));
        if (between == 0) continue;  // a itself.
        const double to_border = (squared(b) - squared(a)) / (2 * between);
        if (to_border >= kFarthestEdge) continue;
        to_edge = std::min(to_edge, to_border);
        near_edges += std::exp(-kRounding * to_border) - std::exp(-kRounding * kFarthestEdge);
    }
    const double rounded =
        -std::log(near_edges + std::exp(-kRounding * kFarthestEdge)) / kRounding;
    return {a.i, a.j, -a.dx, -a.dy, to_edge, rounded};
}

}  // namespace plumb::procedural
