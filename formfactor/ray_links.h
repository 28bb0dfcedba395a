// Links by rays: the paper's way.
//
//       V_i = Sum_open w_k,     F_ij = Sum_{k meets j} w_k,     w_k = <n, d_k> / Sum_m <n, d_m>
//       alpha_i = Sum_open a_k,                                 a_k = 1/N
//
// with directions d_k uniform over the hemisphere, as the paper casts them. With directions in
// proportion to the cosine, w_k = 1/N and a_k = (1/<n, d_k>) / Sum_m (1/<n, d_m>).
//
// Source   [Mayaux18] "Collecting Data", step 1.
// Symbols  n facet normal, d_k direction of ray k, N rays a facet.
// Beware   Under cosine sampling the variance of alpha is infinite in theory (it grows as
//          log N): take alpha from uniform rays or from slices.
//          The paper's program uses one set of directions for all texels, in a cone of 179
//          degrees normalised as if it were 180 (a surplus of 0.87 % a gather). Here the set is
//          an Owen-scrambled Sobol net, scrambled anew for every facet, over the whole
//          hemisphere.
#pragma once

#include <cstdint>

#include "formfactor/links.h"
#include "formfactor/receiver.h"
#include "heightfield/height_field.h"

namespace plumb {

enum class RayDistribution { kUniform, kCosine };

struct RayOptions {
    int rays = 1024;         ///< N, rays a facet; powers of two spread best. [1, 1048576]
    std::uint64_t seed = 1;  ///< Of directions and origins.
    RayDistribution distribution = RayDistribution::kUniform;
    Origins origins = Origins::kSpread;
};

/// Throws Error, naming field, value and rule.
void Validate(const RayOptions& options);

/// All links of the field. A ray too level to meet anything within FarDistanceM counts as sky
/// if it rises and as a link of the facet to itself otherwise; both are summed in
/// Links::mean_cut_short. Cost: N rays a facet, 8 bytes for each facet met.
Links LinksByRays(const HeightField& field, const RayOptions& options = {},
                  Monitor& monitor = SilentMonitor());

/// The same between the pieces of its facets: rows, alpha and V are then one a piece.
Links LinksByRays(const HeightField& field, const FacetPieces& pieces,
                  const RayOptions& options = {}, Monitor& monitor = SilentMonitor());

/// Direction k of the set of facet `number`, in the frame of its normal (z = n). Unit length.
Vec3 RayDirection(const RayOptions& options, std::int64_t number, std::uint32_t k);

/// a_k of a direction with that <n, d_k> >= 0, before it is divided by the sum. Finite: a point
/// of a net on the rim of the disc stands for its cell of 2^-32, whose middle has
/// <n, d> = 2^-15.5.
double SolidAngleWeight(RayDistribution distribution, double cosine);

}  // namespace plumb
