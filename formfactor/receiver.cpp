#include "formfactor/receiver.h"

#include "core/random.h"
#include "core/sobol.h"
#include "core/warp.h"

namespace plumb {

Vec3 OriginM(const Facet& facet, Origins origins, std::uint64_t seed, std::int64_t number,
             std::uint32_t k) {
    if (origins == Origins::kCentroid) return facet.CentroidM();
    const Vec2 b = SampleTriangle(SobolOwenPair(k, 0, Absorb(seed, std::uint64_t(number))));
    constexpr double kInset = 1e-6;
    const double b_0 = kInset / 3 + (1 - kInset) * b.x();
    const double b_1 = kInset / 3 + (1 - kInset) * b.y();
    const auto& p = facet.corners_m;
    return b_0 * p[0] + b_1 * p[1] + (1 - b_0 - b_1) * p[2];
}

}  // namespace plumb
