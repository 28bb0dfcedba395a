// Links by slices: exact in elevation, sampled only in azimuth.
//
// In the vertical plane at azimuth phi through a point x of the facet, the surface is a
// polyline. One walk outwards (heightfield/facet_walk.h) meets every stretch of it that x sees,
// in order of rising elevation; each stretch lies in one facet, between zenith angles th_1 >
// th_2, and fills
//
//       w = G(th_1) - G(th_2),     G(th) = Int_0^th (c sin t + n_z cos t) sin t dt
//                                        = c (th - sin th cos th) / 2 + n_z sin^2 th / 2
//
// of the slice, c = n . (cos phi, sin phi, 0). What is above the last stretch is sky. Likewise
// for solid angle, with G(th) = 1 - cos th. N slices from well-spread points x, azimuths phi_k
// = 2 pi (k + xi) / N with xi different for every facet, give the row
//
//       F_ij = Sum_k w_kj / Sum_k G(th_k,max)       th_max: where the facet's own plane begins
//
// Source   ours. The integrand is that of [Mayaux18 eq. 4] and E_0 of [Mayaux18 eq. 5].
// Symbols  n unit normal of the facet, th zenith angle from the vertical, phi azimuth, both in
//          radians.
// Beware   Dividing by the sum of the slices' own totals, instead of by pi N / (2 pi), closes
//          the row at any N; the two differ by the quadrature error of a smooth or once-kinked
//          function of phi, O(1/N^2), which the rows would otherwise carry as a surplus.
//          A line of sight is followed until what the surface can still hide ahead of it is
//          thinner than `horizon_tolerance_rad`. What is left then is sky above the horizontal,
//          so alpha may be too open by that tolerance, V by twice that; below it, where the
//          field is endless, it is given to the facet last seen (to the facet itself if there
//          was none), and Links::mean_cut_short states the share.
#pragma once

#include <cstdint>

#include "formfactor/links.h"
#include "formfactor/receiver.h"
#include "heightfield/height_field.h"

namespace plumb {

struct SliceOptions {
    int slices = 32;         ///< N, azimuths a facet. [4, 65536]
    std::uint64_t seed = 1;  ///< Of origins and azimuths.
    Origins origins = Origins::kSpread;
    bool rotate =
        true;  ///< xi random per facet; false: xi = 1/2 everywhere, for symmetric tests.
    /// Stretches kept a slice. Where a slice has more, neighbours in elevation that are thinner
    /// than 1/links_per_slice of all that it sees are drawn together into one link, to one of
    /// them chosen in proportion to its share: unbiased, and V, alpha and the row sum are
    /// untouched. [1, ...)
    int links_per_slice = 8;
    double horizon_tolerance_rad = 1e-4;  ///< See Beware. (0, 0.1]
};

/// Throws Error, naming field, value and rule.
void Validate(const SliceOptions& options);

/// All links of the field. Cost: about 10 blocks and 30 edges crossed a slice on rough fields;
/// memory 8 bytes a link, see Links.
Links LinksBySlices(const HeightField& field, const SliceOptions& options = {},
                    Monitor& monitor = SilentMonitor());

/// The same between the pieces of its facets: rows, alpha and V are then one a piece, and the
/// pieces of a cut facet share its slices.
Links LinksBySlices(const HeightField& field, const FacetPieces& pieces,
                    const SliceOptions& options = {}, Monitor& monitor = SilentMonitor());

/// Slices of one of the `pieces` of a facet that has `slices`: its part of them, but kFewestSlices
/// at least (`slices`, if that is fewer).
inline constexpr int kFewestSlices = 4;
int SlicesAPiece(int slices, int pieces);

}  // namespace plumb
