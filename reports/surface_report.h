// What a light simulation says of one height map, as far as a report shows it.
//
// Symbols  alpha, V, E_k, E(rho) as in core/conventions.h; n_z the facet's normal along +z.
// Beware   A figure that was not measured is NaN: JSON has null for it, a page a dash.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/bounce_histogram.h"
#include "core/measured.h"

namespace plumb {

/// The figures of one surface. Means are plain ones over facets, which share one projected area:
/// per unit of ground, not of true area.
struct SurfaceFigures {
    static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

    std::int64_t facets = 0;
    double mean_alpha = kUnknown;
    double mean_V = kUnknown;
    double mean_first_bounce = kUnknown;  ///< Mean E_1.
    double mean_slope_deg = kUnknown;     ///< Mean angle between facet normal and +z.
    double links_per_facet = kUnknown;
    double cut_short = kUnknown;  ///< Share of a hemisphere whose line of sight was cut.
    double max_furnace_error = kUnknown;  ///< max |Sum_k E_k + tail - 1| at albedo 1.
    double light_under_way = kUnknown;    ///< max_i 1 - Sum_{k <= K} E_k: what K bounces miss.
    int bounces_run = 0;                  ///< Until the totals were settled; K or more.

    /// Mean of V / n_z: 1 on a closed (wrapped or mirrored)
    /// surface, whatever its shape. The standard error is that of the sampling, from the
    /// differences between neighbours: too large where the surface is rough from cell to cell.
    std::optional<Measured> aperture;
};

/// Pictures are data URIs ("data:image/png;base64,..."), made by the caller; empty = not shown.
struct SurfaceReport {
    std::string name;
    std::string heights_picture;     ///< Shaded relief.
    std::string visibility_picture;  ///< V per texel, black 0, white 1.
    BounceHistogram over_alpha;
    BounceHistogram over_V;
    SurfaceFigures figures;
};

}  // namespace plumb
