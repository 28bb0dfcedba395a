#include "screen_space/antialiasing/texture_footprint.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumb {
namespace {

/// Neighbouring samples of one axis: the sample itself and one step away from it, or none.
class Axis {
  public:
    Axis(const WideGBuffer& g, int X, int Y, int dx, int dy)
        : g_(g), X_(X), Y_(Y), dx_(dx), dy_(dy) {}

    /// The derivative by the neighbour `step` = 1 or -1 away; 0 beyond the picture.
    Vec2 By(int step) const {
        const int X = X_ + step * dx_, Y = Y_ + step * dy_;
        if (!Inside(X, Y)) return {0, 0};
        const Vec2f off = g_.samples.uv(X, Y) - g_.samples.uv(X_, Y_);
        return off.cast<double>() * step;
    }

    bool OfOneMaterial(int step) const {
        const int X = X_ + step * dx_, Y = Y_ + step * dy_;
        return Inside(X, Y) && g_.material(X, Y) == g_.material(X_, Y_);
    }

    /// Towards the other sample of its pair.
    int Partner() const { return (dx_ * X_ + dy_ * Y_) % 2 == 0 ? 1 : -1; }

  private:
    bool Inside(int X, int Y) const {
        return X >= 0 && Y >= 0 && X < g_.material.Width() && Y < g_.material.Height();
    }

    const WideGBuffer& g_;
    int X_, Y_, dx_, dy_;
};

Vec2 Tested(const Axis& axis) {
    const bool ahead = axis.OfOneMaterial(1), behind = axis.OfOneMaterial(-1);
    if (ahead && behind) {
        const Vec2 a = axis.By(1), b = axis.By(-1);
        return a.squaredNorm() <= b.squaredNorm() ? a : b;
    }
    if (ahead || behind) return axis.By(ahead ? 1 : -1);
    return {0, 0};
}

}  // namespace

Footprint FootprintOf(const WideGBuffer& g, int X, int Y, FootprintSource source) {
    if (g.material(X, Y) == WideGBuffer::kNoMaterial) return {};
    if (source == FootprintSource::kSurface) {
        return {g.samples.uv_per_x_px(X, Y).cast<double>(),
                g.samples.uv_per_y_px(X, Y).cast<double>()};
    }
    const Axis x(g, X, Y, 1, 0), y(g, X, Y, 0, 1);
    if (source == FootprintSource::kDifferencesTested) return {Tested(x), Tested(y)};
    return {x.By(x.Partner()), y.By(y.Partner())};
}

double SampleSpacing(int m, int k) {
    return m / std::sqrt(double(k));
}

Rgb SampleFootprint(const MipChain& texture, const Vec2f& uv, const Footprint& footprint,
                    int most_taps) {
    const Vec2 texels(texture.Level(0).Width(), texture.Level(0).Height());
    const double P_x = footprint.per_x.cwiseProduct(texels).norm();
    const double P_y = footprint.per_y.cwiseProduct(texels).norm();
    const double P_max = std::max(P_x, P_y), P_min = std::min(P_x, P_y);
    // Written so that a NaN ends here too.
    if (!(P_max > 1)) return texture.Trilinear(uv, 0);
    // And that no width at all takes as many taps as there may be.
    const double ratio = std::ceil(P_max / P_min);
    const int N = ratio < most_taps ? int(ratio) : most_taps;
    const double level = std::log2(P_max / N);
    const Vec2 along = P_x >= P_y ? footprint.per_x : footprint.per_y;
    std::array<double, 3> sum{};
    for (int i = 1; i <= N; ++i) {
        const Vec2 at = uv.cast<double>() + (double(i) / (N + 1) - 0.5) * along;
        const Rgb tap = texture.Trilinear(at.cast<float>(), level);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += tap[c];
    }
    Rgb rho;
    for (std::size_t c = 0; c < 3; ++c) rho[c] = float(sum[c] / N);
    return rho;
}

}  // namespace plumb
