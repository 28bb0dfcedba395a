#include "score/flip_filters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"

namespace plumb {
namespace {

constexpr double kPi = std::numbers::pi;

struct Gaussian {
    double a, b;
};

// Of the contrast sensitivity functions.
constexpr Gaussian kY{1, 0.0047}, kCx{1, 0.0053}, kCzWide{34.1, 0.04}, kCzNarrow{13.5, 0.025};

constexpr double kFeature_deg = 0.082;  // w

std::vector<double> Sampled(const Gaussian& g, double scale, int radius, double ppd) {
    std::vector<double> w;
    for (int k = 0; k <= radius; ++k) {
        const double x = k / ppd;
        w.push_back(scale * std::exp(-kPi * kPi * x * x / g.b));
    }
    return w;
}

/// Over the whole line.
double SumOf(const std::vector<double>& w) {
    double sum = 0;
    for (std::size_t k = 1; k < w.size(); ++k) sum += w[k];
    return w[0] + 2 * sum;
}

/// Divided by `sum`, without what weighs nothing.
LineFilter Normalized(std::vector<double> w, double sum) {
    constexpr double kNothing = 1e-12;
    for (double& weight : w) weight /= sum;
    while (w.size() > 1 && std::abs(w.back()) < kNothing * w.front()) w.pop_back();
    return {.w = std::move(w)};
}

LineFilter Contrast(const Gaussian& g, int radius, double ppd) {
    std::vector<double> w = Sampled(g, 1, radius, ppd);
    const double sum = SumOf(w);
    return Normalized(std::move(w), sum);
}

}  // namespace

FlipFilters MakeFlipFilters(double ppd) {
    if (!(ppd >= 1 && ppd <= 1000)) throw Error(MustBe("pixels a degree", ppd, "in [1, 1000]"));
    FlipFilters filters;
    const int radius = int(std::ceil(3 * std::sqrt(kCzWide.b / (2 * kPi * kPi)) * ppd));
    filters.Y = Contrast(kY, radius, ppd);
    filters.Cx = Contrast(kCx, radius, ppd);
    const auto root = [](const Gaussian& g) { return std::sqrt(g.a * std::sqrt(kPi / g.b)); };
    std::vector<double> wide = Sampled(kCzWide, root(kCzWide), radius, ppd);
    std::vector<double> narrow = Sampled(kCzNarrow, root(kCzNarrow), radius, ppd);
    const double both = std::hypot(SumOf(wide), SumOf(narrow));
    filters.Cz_wide = Normalized(std::move(wide), both);
    filters.Cz_narrow = Normalized(std::move(narrow), both);

    const double sigma = 0.5 * kFeature_deg * ppd;
    const int reach = int(std::ceil(3 * sigma));
    std::vector<double> g, edge, point;
    double edge_sum = 0, point_above = 0, point_below = 0;
    for (int k = 0; k <= reach; ++k) {
        const double G = std::exp(-k * k / (2 * sigma * sigma));
        const double G2 = (k * k / (sigma * sigma) - 1) * G;
        const int times = k == 0 ? 1 : 2;
        g.push_back(G);
        edge.push_back(-k * G);
        point.push_back(G2);
        edge_sum += k * G;
        (G2 > 0 ? point_above : point_below) += times * std::abs(G2);
    }
    const double sum = SumOf(g);
    for (double& weight : g) weight /= sum;
    for (double& weight : edge) weight /= edge_sum;
    for (double& weight : point) weight /= weight > 0 ? point_above : point_below;
    filters.G.w = std::move(g);
    filters.edge = {.w = std::move(edge), .odd = true};
    filters.point.w = std::move(point);

    for (const LineFilter* filter :
         {&filters.Y, &filters.Cx, &filters.Cz_wide, &filters.Cz_narrow, &filters.G,
          &filters.edge, &filters.point}) {
        filters.reach_px = std::max(filters.reach_px, filter->Reach());
    }
    return filters;
}

}  // namespace plumb
