#include "jobs/light/simulate_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/conventions.h"
#include "core/error.h"
#include "formfactor/histogram.h"
#include "formfactor/total.h"
#include "heightfield/facet.h"

namespace plumb {
namespace {

// Appends the seconds since it was made, or since the last Lap, to the timings.
class StopWatch {
  public:
    StopWatch(std::string map, Timings* timings, const Clock& clock)
        : map_(std::move(map)), timings_(timings), clock_(clock), last_s_(Now()) {}

    void Lap(const char* stage) {
        const double now_s = Now();
        if (timings_ && clock_) timings_->push_back({map_, stage, now_s - last_s_});
        last_s_ = now_s;
    }

  private:
    double Now() const { return clock_ ? clock_() : 0; }

    std::string map_;
    Timings* timings_;
    const Clock& clock_;
    double last_s_;
};

SurfaceFigures FiguresOf(const HeightField& field, const Links& links,
                         const SurfaceLight& light) {
    SurfaceFigures figures;
    figures.facets = field.Facets();
    const double n = double(figures.facets);
    figures.links_per_facet = double(links.Count()) / n;
    figures.cut_short = links.mean_cut_short;
    double alpha = 0, V = 0, slope_rad = 0;
    // Facets are sampled independently, so half the mean square of differences between like
    // facets of neighbouring cells is the sampling's variance, plus what the surface itself
    // changes from one cell to the next.
    double aperture = 0, differences = 0;
    double before[2] = {};
    for (std::int64_t i = 0; i < figures.facets; ++i) {
        const double n_z = FacetOf(field, i).normal.z();
        alpha += light.alpha[std::size_t(i)];
        V += light.V[std::size_t(i)];
        slope_rad += std::acos(std::min(1.0, n_z));
        const double x = light.V[std::size_t(i)] / n_z;
        aperture += x;
        if (i >= 2) differences += (x - before[i % 2]) * (x - before[i % 2]);
        before[i % 2] = x;
    }
    figures.mean_alpha = alpha / n;
    figures.mean_V = V / n;
    figures.mean_slope_deg = slope_rad / n * 180 / kPi;
    if (field.GetBoundary() != Boundary::kOpen) {
        figures.aperture =
            Measured{.value = aperture / n,
                     .standard_error = std::sqrt(differences / (2 * (n - 2)) / n)};
    }
    return figures;
}

}  // namespace

std::vector<double> ScoredAlbedos() {
    std::vector<double> albedos;
    for (int k = 1; k < 20; ++k) albedos.push_back(k / 20.0);
    return albedos;
}

std::string FurnaceFault(const std::string& map, double max_furnace_error) {
    if (max_furnace_error <= kFurnaceLimit) return "";
    return MustBe(map + ": furnace error", max_furnace_error,
                  "<= 0.001: light is lost or made, none of these figures can be trusted");
}

Sampling SamplingOf(const SimulateSettings& settings) {
    const bool rays = settings.method == LinkMethod::kRays;
    return {.method = rays ? "rays" : "slices",
            .per_facet = rays ? settings.rays.rays : settings.slices.slices,
            .seed = rays ? settings.rays.seed : settings.slices.seed,
            .cut_texels = settings.cut.extent_texels,
            .most_pieces = settings.cut.most_pieces};
}

Links MakeLinksOf(const HeightField& field, const FacetPieces& pieces,
                  const SimulateSettings& settings, Monitor& monitor) {
    return settings.method == LinkMethod::kRays
               ? LinksByRays(field, pieces, settings.rays, monitor)
               : LinksBySlices(field, pieces, settings.slices, monitor);
}

SurfaceLight SimulateSurface(const std::string& name, const HeightField& field,
                             const SimulateSettings& settings, Monitor& monitor,
                             Timings* timings, const Clock& clock, const SimulateViews& views) {
    StopWatch watch(name, timings, clock);
    const FacetPieces pieces(field, settings.cut);
    const Links links = MakeLinksOf(field, pieces, settings, monitor);
    watch.Lap("links");

    SurfaceLight light;
    light.name = name;
    light.alpha = pieces.FacetMeans(std::span<const double>(links.alpha));
    light.V = pieces.FacetMeans(std::span<const double>(links.V));
    light.albedos = settings.albedos;
    light.link_bytes = links.MemoryBytes();
    light.links = links.Count();
    light.figures = FiguresOf(field, links, light);

    HistogramBuilder over_alpha(name, BinnedBy::kUniformVisibility, settings.bins, light.alpha,
                                light.V);
    HistogramBuilder over_V(name, BinnedBy::kCosineVisibility, settings.bins, light.alpha,
                            light.V);
    HistogramBuilder over_both(name, BinnedBy::kBothVisibilities, kAlphaVGridSide, light.alpha,
                               light.V);
    std::vector<double> arrived;  // Of every facet, after the bounces that are kept.
    const auto gather = [&](int k, std::span<const double> E_k) {
        arrived.resize(E_k.size());
        for (std::size_t i = 0; i < E_k.size(); ++i) arrived[i] += E_k[i];
        over_alpha.AddBounce(E_k);
        over_V.AddBounce(E_k);
        if (k == 1) {
            double sum = 0;
            for (const double e : E_k) sum += e;
            light.figures.mean_first_bounce = sum / double(E_k.size());
        }
        if (views.bounce) views.bounce(k, E_k);
    };
    light.series =
        RunSeries(links, pieces, {.bounces = settings.bounces, .albedos = settings.albedos},
                  gather, monitor);
    light.total = std::exchange(light.series.total, {});
    for (std::size_t r = 0; r < settings.albedos.size(); ++r) {
        over_alpha.AddTotal(settings.albedos[r], light.total[r]);
        over_V.AddTotal(settings.albedos[r], light.total[r]);
        over_both.AddTotal(settings.albedos[r], light.total[r]);
    }
    light.figures.bounces_run = light.series.bounces_run;
    light.figures.light_under_way = 1 - *std::min_element(arrived.begin(), arrived.end());
    watch.Lap("bounces");

    if (settings.check_furnace) {
        const std::vector<double> white(std::size_t(links.Facets()), 1.0);
        const TotalLight furnace = SolveTotal(links, white, 1e-10, monitor);
        double worst = 0;
        for (const double E : furnace.E) {
            const double off = std::abs(E - 1);
            if (!(off <= worst)) worst = off;
            if (std::isnan(worst)) break;
        }
        light.figures.max_furnace_error = worst;
        watch.Lap("furnace");
    }
    if (views.links) views.links(links, pieces);
    light.over_alpha = over_alpha.Result();
    light.over_V = over_V.Result();
    light.over_both = over_both.Result();
    return light;
}

}  // namespace plumb
