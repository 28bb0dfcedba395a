#include "formfactor/receiver.h"

#include <algorithm>

#include "core/random.h"
#include "core/sobol.h"
#include "core/warp.h"

namespace plumb {
namespace {

constexpr double kInset = 1e-6;

}  // namespace

Vec3 OriginM(const Facet& facet, Origins origins, std::uint64_t seed, std::int64_t number,
             std::uint32_t k) {
    if (origins == Origins::kCentroid) return facet.CentroidM();
    const Vec2 b = SampleTriangle(SobolOwenPair(k, 0, Absorb(seed, std::uint64_t(number))));
    const double b_0 = kInset / 3 + (1 - kInset) * b.x();
    const double b_1 = kInset / 3 + (1 - kInset) * b.y();
    const auto& p = facet.corners_m;
    return b_0 * p[0] + b_1 * p[1] + (1 - b_0 - b_1) * p[2];
}

Vec3 OriginM(const Facet& facet, const FacetPieces& pieces, std::int64_t piece, Origins origins,
             std::uint64_t seed, std::uint32_t k) {
    const std::int64_t f = pieces.FacetOf(piece);
    if (pieces.PiecesOf(f) == 1) return OriginM(facet, origins, seed, piece, k);
    const Vec2 b = origins == Origins::kCentroid
                       ? Vec2(0.5, 0.5)
                       : SobolOwenPair(k, 0, Absorb(seed, std::uint64_t(piece)));
    double below = 0;
    for (std::int64_t p = pieces.First(f); p < piece; ++p) below += pieces.Share(p);
    const Vec3 x =
        PointAboveShareM(facet, std::min(1.0, below + b.x() * pieces.Share(piece)), b.y());
    return x + kInset * (facet.CentroidM() - x);
}

}  // namespace plumb
