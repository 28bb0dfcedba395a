#include "formfactor/ray_links.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/sobol.h"
#include "core/warp.h"
#include "formfactor/make_links.h"
#include "heightfield/facet.h"
#include "heightfield/ray_cast.h"

namespace plumb {
namespace {

class RayRow {
  public:
    RayRow(const HeightField& field, const FacetPieces& pieces, const WalkGrid& grid,
           const RayOptions& options, const Monitor& monitor)
        : field_(field),
          pieces_(pieces),
          grid_(grid),
          options_(options),
          monitor_(monitor),
          far_m_(FarDistanceM(field)) {}

    FacetResult Make(std::int64_t piece, LinkBlock& block) {
        const std::int64_t number = pieces_.FacetOf(piece);
        const Facet f = FacetOf(field_, number);
        const Basis frame(f.normal);
        const Vec3 corner(0.5 * field_.SpacingXM(), 0.5 * field_.SpacingYM(), 0);
        const bool uniform = options_.distribution == RayDistribution::kUniform;
        row_.clear();
        double cosine_all = 0, solid_all = 0, solid_open = 0, cut_short = 0;
        for (int k = 0; k < options_.rays; ++k) {
            if (monitor_.Cancelled()) throw Interrupted();
            const Vec3 local = RayDirection(options_, piece, std::uint32_t(k));
            const Vec3 d = frame.ToWorld(local);
            const Vec3 x =
                OriginM(f, pieces_, piece, options_.origins, options_.seed, std::uint32_t(k)) -
                corner;
            const double w = uniform ? local.z() : 1;
            const double a = SolidAngleWeight(options_.distribution, local.z());
            cosine_all += w;
            solid_all += a;
            double height_m = 0;
            std::int64_t met = CastFromFacet(grid_, number, x, d, far_m_, &height_m);
            if (met == kLost) {
                cut_short += w;
                if (d.z() <= 0) {
                    row_.emplace_back(std::uint32_t(piece), w);
                    continue;
                }
                met = kSky;
            }
            if (met == kSky) {
                solid_open += a;
            } else {
                row_.emplace_back(std::uint32_t(pieces_.At(met, height_m)), w);
            }
        }
        for (auto& [j, weight] : row_) weight /= cosine_all;
        const double V = AppendRow(row_, block);
        return {solid_open / solid_all, V, cut_short / cosine_all};
    }

  private:
    const HeightField& field_;
    const FacetPieces& pieces_;
    const WalkGrid& grid_;
    const RayOptions& options_;
    const Monitor& monitor_;
    double far_m_;
    LinkRow row_;
};

}  // namespace

void Validate(const RayOptions& o) {
    if (o.rays < 1 || o.rays > 1048576) {
        throw Error(MustBe("RayOptions::rays", o.rays, "in [1, 1048576]"));
    }
}

Vec3 RayDirection(const RayOptions& o, std::int64_t number, std::uint32_t k) {
    const Vec2 u = SobolOwenPair(k, 1, Absorb(o.seed, std::uint64_t(number)));
    return o.distribution == RayDistribution::kUniform ? SampleUniformHemisphere(u)
                                                       : SampleCosineHemisphere(u);
}

double SolidAngleWeight(RayDistribution distribution, double cosine) {
    static const double kRim = std::exp2(-15.5);
    return distribution == RayDistribution::kUniform ? 1 : 1 / std::max(cosine, kRim);
}

Links LinksByRays(const HeightField& field, const RayOptions& options, Monitor& monitor) {
    return LinksByRays(field, FacetPieces(field), options, monitor);
}

Links LinksByRays(const HeightField& field, const FacetPieces& pieces,
                  const RayOptions& options, Monitor& monitor) {
    Validate(options);
    const WalkGrid grid(field);
    return MakeLinks(
        pieces.Count(), [&] { return RayRow(field, pieces, grid, options, monitor); }, monitor);
}

}  // namespace plumb
