// The total light for albedos of the user's own: one, a colour, or one a texel.
#pragma once

#include <array>
#include <vector>

#include "core/image.h"
#include "core/monitor.h"
#include "formfactor/links.h"
#include "heightfield/facet_pieces.h"
#include "heightfield/height_field.h"

namespace plumb {

/// Albedo of every facet from one a texel: the mean of its three corners, for R, G and B.
/// Throws Error unless the picture has one pixel a texel and every value lies in [0, 1].
std::array<std::vector<double>, 3> FacetAlbedos(const HeightField& field,
                                                const Image<Rgb>& albedo);

/// E of every facet for each of R, G, B, from links between its pieces and one albedo a facet.
/// Throws Error if a solve does not converge.
std::array<std::vector<double>, 3> ColouredLight(
    const Links& links, const FacetPieces& pieces,
    const std::array<std::vector<double>, 3>& albedo, Monitor& monitor = SilentMonitor());

}  // namespace plumb
