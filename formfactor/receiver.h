// Where on a facet a line of sight begins.
#pragma once

#include <cstdint>

#include "core/vec.h"
#include "heightfield/facet.h"
#include "heightfield/facet_pieces.h"

namespace plumb {

/// Where on a facet the lines of sight begin.
enum class Origins {
    kSpread,    ///< Well spread over its area: F_ij is the mean over i, as radiosity has it.
    kCentroid,  ///< All at its centroid: the visibility of a point.
};

/// Origin number `k` on facet `number`, in metres: the centroid, or the k-th point of a
/// sequence that is uniform over the triangle (an Owen-scrambled Sobol pair, scrambled anew for
/// every facet). Spread points keep off the edges by 1e-6 of the triangle, so that no line
/// starts on one.
Vec3 OriginM(const Facet& facet, Origins origins, std::uint64_t seed, std::int64_t number,
             std::uint32_t k);

/// The same for a piece of the facet: for the centroid stands the middle of the level line that
/// halves the piece.
Vec3 OriginM(const Facet& facet, const FacetPieces& pieces, std::int64_t piece, Origins origins,
             std::uint64_t seed, std::uint32_t k);

}  // namespace plumb
