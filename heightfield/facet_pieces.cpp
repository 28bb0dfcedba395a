#include "heightfield/facet_pieces.h"

#include <array>
#include <atomic>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"

namespace plumb {
namespace {

// The corners of a facet from the lowest to the highest.
std::array<Vec3, 3> Ascending(const Facet& facet) {
    std::array<Vec3, 3> p = facet.corners_m;
    std::sort(p.begin(), p.end(), [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
    return p;
}

// The heights of Facet::corners_m alone, at a small part of its cost.
std::array<double, 3> CornerHeightsM(const HeightField& field, std::int64_t facet) {
    std::array<double, 3> z;
    const std::array<TexelIndex, 3> corners = FacetTexels(field, facet);
    for (std::size_t k = 0; k < 3; ++k) z[k] = field.At(corners[k].i, corners[k].j);
    return z;
}

constexpr std::int64_t kMaxPieces = std::int64_t(1) << 31;

}  // namespace

void Validate(const CutOptions& o) {
    if (!(o.extent_texels >= 0 && std::isfinite(o.extent_texels))) {
        throw Error(MustBe("CutOptions::extent_texels", o.extent_texels, "finite and >= 0"));
    }
    if (o.most_pieces < 1 || o.most_pieces > 256) {
        throw Error(MustBe("CutOptions::most_pieces", o.most_pieces, "in [1, 256]"));
    }
}

FacetPieces::FacetPieces(const HeightField& field, const CutOptions& options)
    : facets_(field.Facets()), count_(field.Facets()) {
    Validate(options);
    if (options.extent_texels == 0 || options.most_pieces == 1) return;
    const double extent_m =
        options.extent_texels * std::sqrt(field.SpacingXM()) * std::sqrt(field.SpacingYM());
    const auto pieces = [&](std::int64_t facet) {
        const std::array<double, 3> z = CornerHeightsM(field, facet);
        const auto [low, high] = std::minmax({z[0], z[1], z[2]});
        if (high - low <= extent_m) return 1;
        return int(std::min(std::ceil((high - low) / extent_m), double(options.most_pieces)));
    };
    // Counted before memory is taken: a large map ends here.
    std::atomic<std::int64_t> count = 0;
    ParallelFor(facets_, 1 << 16, [&](std::int64_t begin, std::int64_t end) {
        if (count > kMaxPieces) return;
        std::int64_t here = 0;
        for (std::int64_t f = begin; f < end; ++f) here += pieces(f);
        count += here;
    });
    count_ = count;
    if (count_ > kMaxPieces) {
        throw Error(
            "FacetPieces: more than 2^31 pieces; cut into fewer or larger ones, or take a "
            "smaller map");
    }
    if (count_ == facets_) return;
    first_.reserve(std::size_t(facets_) + 1);
    first_.push_back(0);
    for (std::int64_t f = 0; f < facets_; ++f) {
        first_.push_back(first_.back() + std::uint32_t(pieces(f)));
    }
    facet_.reserve(std::size_t(count_));
    low_m_.reserve(std::size_t(count_));
    share_.reserve(std::size_t(count_));
    for (std::int64_t f = 0; f < facets_; ++f) {
        const int m = PiecesOf(f);
        const Facet facet = plumb::FacetOf(field, f);
        const std::array<Vec3, 3> p = Ascending(facet);
        double below = 0;
        for (int k = 0; k < m; ++k) {
            const double next =
                k == m - 1 ? 1
                           : ShareBelow(facet, p[0].z() + (p[2].z() - p[0].z()) * (k + 1) / m);
            facet_.push_back(std::uint32_t(f));
            low_m_.push_back(p[0].z() + (p[2].z() - p[0].z()) * k / m);
            share_.push_back(next - below);
            below = next;
        }
    }
}

double ShareBelow(const Facet& facet, double z_m) {
    const std::array<Vec3, 3> p = Ascending(facet);
    const double z = std::clamp(z_m, p[0].z(), p[2].z()), all = p[2].z() - p[0].z();
    if (all == 0) return 0;
    if (z <= p[1].z()) {
        const double below = p[1].z() - p[0].z();
        return below == 0 ? 0 : (z - p[0].z()) / below * ((z - p[0].z()) / all);
    }
    return 1 - (p[2].z() - z) / (p[2].z() - p[1].z()) * ((p[2].z() - z) / all);
}

Vec3 PointAboveShareM(const Facet& facet, double u, double v) {
    const std::array<Vec3, 3> p = Ascending(facet);
    const double all = p[2].z() - p[0].z();
    if (all == 0) return facet.CentroidM();
    const double kink = (p[1].z() - p[0].z()) / all;  // S(z_1)
    if (u < kink || kink == 1) {
        const double t = std::sqrt(u * kink), s = std::sqrt(u / kink);
        const Vec3 a = p[0] + t * (p[2] - p[0]), b = p[0] + s * (p[1] - p[0]);
        return a + v * (b - a);
    }
    const double t = std::sqrt((1 - u) * (1 - kink)), s = std::sqrt((1 - u) / (1 - kink));
    const Vec3 a = p[2] + t * (p[0] - p[2]), b = p[2] + s * (p[1] - p[2]);
    return a + v * (b - a);
}

}  // namespace plumb
