#include "reports/simulate_report.h"

#include <cmath>
#include <functional>

#include "core/error.h"
#include "reports/histogram_plots.h"
#include "reports/surface_sections.h"
#include "reports/text.h"

namespace plumb {
namespace {

/// A quantity with its percentile band, by the bin's Spread.
template <class Get>
std::vector<PlotSeries> SpreadOf(const BounceHistogram& histogram, Get&& get) {
    const Column x = Abscissae(histogram);
    const auto column = [&](double Spread::*member) {
        return BinColumn(histogram, [&](const BounceBin& bin) { return get(bin).*member; });
    };
    return {{.label = "mean",
             .mark = Mark::kDots,
             .color = kDataColor,
             .x = x,
             .y = column(&Spread::mean)},
            {.label = "median", .color = kOursColor, .x = x, .y = column(&Spread::p50)},
            {.label = "5 to 95 % of facets",
             .mark = Mark::kBand,
             .color = kDataBandColor,
             .x = x,
             .y = column(&Spread::p05),
             .high = column(&Spread::p95)}};
}

std::vector<PlotSeries> Population(const BounceHistogram& histogram) {
    double facets = 0;
    for (const BounceBin& bin : histogram.bins) facets += double(bin.count);
    return {{.color = kOursColor,
             .x = Abscissae(histogram),
             .y = BinColumn(histogram, [&](const BounceBin& bin) {
                 return 100 * double(bin.count) / facets;
             })}};
}

std::vector<PlotSeries> EveryBounce(const BounceHistogram& histogram) {
    std::vector<PlotSeries> series;
    const Column x = Abscissae(histogram);
    const int last = histogram.Bounces();
    for (int k = 1; k <= last; ++k) {
        series.push_back({.label = InLegend(k) ? "bounce " + std::to_string(k) : "",
                          .color = BounceColor(k, last),
                          .x = x,
                          .y = BinColumn(histogram, [k](const BounceBin& bin) {
                              return bin.bounce[std::size_t(k)].mean;
                          })});
    }
    return series;
}

std::vector<PlotSeries> Totals(const BounceHistogram& histogram) {
    std::vector<PlotSeries> series;
    const Column x = Abscissae(histogram);
    for (const std::size_t r : PlottedAlbedos(histogram.albedos)) {
        series.push_back({.label = "ρ = " + Exact(histogram.albedos[r]),
                          .color = ScaleColor(histogram.albedos[r]),
                          .x = x,
                          .y = BinColumn(histogram, [r](const BounceBin& bin) {
                              return bin.total[r].mean;
                          })});
    }
    return series;
}

doc::Section Light(const SurfaceReport& surface) {
    doc::Plots group{.selectors = {{"over", "Over", {"α", "V"}}}, .plots = {}};
    /// Drawn over either abscissa.
    const auto add =
        [&](Plot plot,
            const std::function<std::vector<PlotSeries>(const BounceHistogram&)>& series_of) {
            for (const BounceHistogram* histogram : {&surface.over_alpha, &surface.over_V}) {
                const bool over_alpha = histogram == &surface.over_alpha;
                plot.views.push_back({.keys = {{"over", over_alpha ? "α" : "V"}},
                                      .series = series_of(*histogram),
                                      .x = Axis{AbscissaLabel(histogram->binned_by), 0, 1}});
            }
            group.plots.push_back(std::move(plot));
        };
    add({.id = "population",
         .title = "How many facets see how much",
         .caption =
             "Share of the facets in each bin. Curves mean little where hardly any facet "
             "lies.",
         .y = {"share of the facets [%]", 0}},
        Population);
    add({.id = "visibility",
         .title = "Direct light E₀ = V",
         .caption =
             "Mean, median and the range of nine facets in ten. Over α the band shows how "
             "much V may differ between facets of one α; over V it is a line.",
         .y = {"E₀ [–, open ground = 1]", 0, 1.05}},
        [](const BounceHistogram& histogram) {
            return SpreadOf(histogram, [](const BounceBin& bin) { return bin.bounce.front(); });
        });
    add({.id = "first-bounce",
         .title = "First bounce E₁",
         .caption = "Light that met the surface once, at albedo 1.",
         .y = {"E₁ [–, open ground = 1]", 0}},
        [](const BounceHistogram& histogram) {
            const std::size_t k = histogram.Bounces() >= 1 ? 1 : 0;
            return SpreadOf(histogram, [k](const BounceBin& bin) { return bin.bounce[k]; });
        });
    add({.id = "bounces",
         .title = "Every bounce",
         .caption = "Mean light after exactly so many bounces, at albedo 1.",
         .y = {"E_k [–, open ground = 1]", 0}},
        EveryBounce);
    add({.id = "totals",
         .title = "All bounces: E(ρ)",
         .caption = "Mean light of all bounces for each albedo ρ. At ρ = 1 it is 1 everywhere: "
                    "no light is lost.",
         .y = {"E(ρ) [–, open ground = 1]", 0, 1.1},
         .wide = true},
        Totals);
    return {.id = "light",
            .title = "Light over visibility",
            .tables = {HistogramTable("over_alpha", "Bins over α", "map",
                                      {{surface.name, &surface.over_alpha}}),
                       HistogramTable("over_v", "Bins over V", "map",
                                      {{surface.name, &surface.over_V}})},
            .plots = {std::move(group)}};
}

doc::Section Findings(const SurfaceReport& surface) {
    const SurfaceFigures& figures = surface.figures;
    doc::Section section{.id = "findings", .title = "Read this first", .listed = true};
    section.sentences.push_back(
        "On the average a facet of *" + doc::Verbatim(surface.name) + "* sees " +
        Digits(100 * figures.mean_alpha, 3) + " % of its hemisphere open (α) and receives *" +
        Digits(100 * figures.mean_V, 3) + " %* of the direct light of open ground (V); " +
        Digits(100 * figures.mean_first_bounce, 3) +
        " % more arrive after one bounce at albedo 1.");
    if (std::isfinite(figures.max_furnace_error))
        section.sentences.push_back("At albedo 1 the bounces of every facet sum to 1 " +
                                    (figures.max_furnace_error > 0
                                         ? "within " + Digits(figures.max_furnace_error, 2)
                                         : std::string("exactly")) +
                                    ".");
    if (figures.aperture)
        section.sentences.push_back(
            "The openings of all facets add up to " +
            WithError(figures.aperture->value, figures.aperture->standard_error) +
            " of the ground area; on a closed surface that must be 1.");
    if (std::isfinite(figures.light_under_way))
        section.sentences.push_back("After " + std::to_string(surface.over_alpha.Bounces()) +
                                    " bounces the worst facet still waits for " +
                                    Digits(100 * figures.light_under_way, 2) +
                                    " % of its light at albedo 1; the totals E(ρ) include it.");
    return section;
}

}  // namespace

doc::Document DocumentOf(const SimulateReport& report) {
    if (report.provenance.maps.size() != 1)
        throw Error(MustBe("SimulateReport::provenance.maps",
                           double(report.provenance.maps.size()), "one map"));
    const SurfaceReport& surface = report.surface;
    doc::Document document{
        .kind = "simulate",
        .title = "Light on " + surface.name,
        .subtitle =
            "A height map under a uniform white sky: what every facet sees of it, and "
            "what comes back from the surface bounce by bounce.",
        .provenance = DocumentProvenance(report.provenance),
        .sections = {Findings(surface),
                     {.id = "surface",
                      .title = "The surface",
                      .facts = FactsOf(surface.figures),
                      .pictures = PicturesOf(surface)},
                     Light(surface)}};
    if (report.amplitudes) document.sections.push_back(AmplitudeSection(*report.amplitudes));
    document.sections.push_back(OriginSection(report.provenance, report.timings));
    return document;
}

}  // namespace plumb
