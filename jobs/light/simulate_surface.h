// The light on one height field: links, bounces, histograms and the figures that vouch for
// them.
//
//       height field -> links -> alpha, V, E_0 ... E_K, E(rho) of every facet
//                             -> histograms over alpha, over V, over both
//
// Source   [Mayaux18] "Collecting Data", steps 1 to 4.
// Symbols  as in core/conventions.h.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/bounce_histogram.h"
#include "core/clock.h"
#include "core/monitor.h"
#include "formfactor/bounces.h"
#include "formfactor/links.h"
#include "formfactor/ray_links.h"
#include "formfactor/slice_links.h"
#include "heightfield/facet_pieces.h"
#include "heightfield/height_field.h"
#include "reports/provenance.h"
#include "reports/surface_report.h"
#include "reports/timings.h"

namespace plumb {

/// The ways to the links of a facet.
enum class LinkMethod { kSlices, kRays };

/// rho = 0.05, 0.10, ... 0.95: the albedos of every score in this project.
std::vector<double> ScoredAlbedos();

/// Light is constant on strips of facets at most this high. On the trench of depth 2 and on every
/// surface of the demo the mean error of E(rho) is then below .002 (tests/agreement).
inline constexpr CutOptions kDefaultCut{.extent_texels = 1.5, .most_pieces = 8};

struct SimulateSettings {
    LinkMethod method = LinkMethod::kSlices;
    CutOptions cut = kDefaultCut;
    SliceOptions slices;
    RayOptions rays;
    int bounces = 20;  ///< K: bounces whose curves are kept. [0, 1000]
    int bins = 100;    ///< Of the histograms over alpha and over V. [1, 100000]
    std::vector<double> albedos = ScoredAlbedos();  ///< rho of the totals.
    bool check_furnace = true;  ///< Solves rho = 1 for SurfaceFigures::max_furnace_error.
};

/// "slices" or "rays", how many and which seed, as reports state them.
Sampling SamplingOf(const SimulateSettings& settings);

/// The furnace error of a simulation whose rows close is rounding and what the solver leaves,
/// 1e-6 or less; above this nothing that it says can be trusted.
inline constexpr double kFurnaceLimit = 1e-3;

/// Empty if a furnace error is within the limit; otherwise, and for NaN, the sentence that says so.
std::string FurnaceFault(const std::string& map, double max_furnace_error);

/// All links between the pieces, by the method of the settings.
Links MakeLinksOf(const HeightField& field, const FacetPieces& pieces,
                  const SimulateSettings& settings, Monitor& monitor = SilentMonitor());

struct SurfaceLight {
    std::string name;
    std::vector<double> alpha, V;           ///< Of every facet: the mean over its pieces.
    std::vector<double> albedos;            ///< rho of `total`.
    std::vector<std::vector<float>> total;  ///< E(rho) of every facet, for each albedo.
    BounceHistogram over_alpha, over_V;     ///< `bins` bins each.
    BounceHistogram over_both;              ///< A grid over (alpha, V), see AlphaVGridSide.
    SurfaceFigures figures;
    std::size_t link_bytes = 0;
    std::int64_t links = 0;
    Series series;  ///< Without its totals, which moved to `total`.
};

/// Bins along one side of the grid over (alpha, V): fine enough that its bins are narrower than
/// those of either histogram where facets are, coarse enough that bins hold several facets.
inline constexpr int kAlphaVGridSide = 24;

/// Those who want to see more than SurfaceLight keeps; each may be empty.
struct SimulateViews {
    std::function<void(int k, std::span<const double> E_k)> bounce = {};  ///< k = 0 ... K.
    /// Once, at the end.
    std::function<void(const Links& links, const FacetPieces& pieces)> links = {};
};

/// Runs the simulation. Stage timings are
/// appended to `timings` if it is given, by `clock`.
SurfaceLight SimulateSurface(const std::string& name, const HeightField& field,
                             const SimulateSettings& settings,
                             Monitor& monitor = SilentMonitor(), Timings* timings = nullptr,
                             const Clock& clock = {}, const SimulateViews& views = {});

}  // namespace plumb
