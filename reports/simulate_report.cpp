#include "reports/simulate_report.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "reports/json_text.h"
#include "reports/page.h"
#include "reports/surface_html.h"
#include "reports/text.h"

namespace plumb {
namespace {

void Validate(const SimulateReport& report) {
    if (report.provenance.maps.size() != 1)
        throw Error(MustBe("SimulateReport::provenance.maps",
                           double(report.provenance.maps.size()), "one map"));
}

const BounceHistogram& Histogram(const SimulateReport& report, BinnedBy binned_by) {
    return binned_by == BinnedBy::kUniformVisibility ? report.surface.over_alpha
                                                     : report.surface.over_V;
}

PlotSeries Series(std::string label, Mark mark, std::string color, Column x, Column y,
                  Column high = {}) {
    return {.label = std::move(label),
            .mark = mark,
            .color = std::move(color),
            .x = x,
            .y = y,
            .minus = {},
            .high = high,
            .joined = false,
            .shape = 0};
}

std::string Over(BinnedBy binned_by) {
    return binned_by == BinnedBy::kUniformVisibility ? "α" : "V";
}

/// A quantity with its percentile band, by the bin's Spread.
template <class Get>
PlotView SpreadView(PlotSheet& sheet, const BounceHistogram& histogram, Get&& get) {
    const Column x = Abscissae(sheet, histogram);
    const auto column = [&](double Spread::*member) {
        return BinColumn(sheet, histogram,
                         [&](const BounceBin& bin) { return get(bin).*member; });
    };
    return {.keys = {},
            .series = {Series("mean", Mark::kDots, kDataColor, x, column(&Spread::mean)),
                       Series("median", Mark::kLine, kOursColor, x, column(&Spread::p50)),
                       Series("5 to 95 % of facets", Mark::kBand, kDataBandColor, x,
                              column(&Spread::p05), column(&Spread::p95))},
            .x = {},
            .y = {}};
}

Plot CountPlot(const SimulateReport& report, PlotSheet& sheet) {
    Plot plot{.id = "population",
              .title = "How many facets see how much",
              .caption =
                  "Share of the facets in each bin. Curves mean little where hardly any "
                  "facet lies.",
              .x = {},
              .y = {"share of the facets [%]", 0, {}},
              .views = {}};
    for (const BinnedBy by : {BinnedBy::kUniformVisibility, BinnedBy::kCosineVisibility}) {
        const BounceHistogram& histogram = Histogram(report, by);
        double facets = 0;
        for (const BounceBin& bin : histogram.bins) facets += double(bin.count);
        const Column x = Abscissae(sheet, histogram);
        plot.views.push_back({.keys = {{"over", Over(by)}},
                              .series = {Series("", Mark::kLine, kOursColor, x,
                                                BinColumn(sheet, histogram,
                                                          [&](const BounceBin& bin) {
                                                              return 100 * double(bin.count) /
                                                                     facets;
                                                          }))},
                              .x = Axis{AbscissaLabel(by), 0, 1},
                              .y = {}});
    }
    return plot;
}

/// One plot over either abscissa; `view` draws it for one of them.
template <class View>
Plot OverBoth(const SimulateReport& report, Plot plot, View&& view) {
    for (const BinnedBy by : {BinnedBy::kUniformVisibility, BinnedBy::kCosineVisibility}) {
        PlotView one = view(Histogram(report, by));
        one.keys = {{"over", Over(by)}};
        one.x = Axis{AbscissaLabel(by), 0, 1};
        plot.views.push_back(std::move(one));
    }
    return plot;
}

std::string LightHtml(const SimulateReport& report, PlotSheet& sheet) {
    const Plot direct = OverBoth(
        report,
        {.id = "visibility",
         .title = "Direct light E₀ = V",
         .caption =
             "Mean, median and the range of nine facets in ten. Over α the band shows how "
             "much V may differ between facets of one α; over V it is a line.",
         .x = {},
         .y = {"E₀ [–, open ground = 1]", 0, 1.05},
         .views = {}},
        [&](const BounceHistogram& histogram) {
            return SpreadView(sheet, histogram, [](const BounceBin& bin) -> const Spread& {
                return bin.bounce.front();
            });
        });
    const Plot first = OverBoth(
        report,
        {.id = "first-bounce",
         .title = "First bounce E₁",
         .caption = "Light that met the surface once, at albedo 1.",
         .x = {},
         .y = {"E₁ [–, open ground = 1]", 0, {}},
         .views = {}},
        [&](const BounceHistogram& histogram) {
            const std::size_t k = histogram.Bounces() >= 1 ? 1 : 0;
            return SpreadView(sheet, histogram, [k](const BounceBin& bin) -> const Spread& {
                return bin.bounce[k];
            });
        });
    const Plot bounces =
        OverBoth(report,
                 {.id = "bounces",
                  .title = "Every bounce",
                  .caption = "Mean light after exactly so many bounces, at albedo 1.",
                  .x = {},
                  .y = {"E_k [–, open ground = 1]", 0, {}},
                  .views = {}},
                 [&](const BounceHistogram& histogram) {
                     PlotView view{.keys = {}, .series = {}, .x = {}, .y = {}};
                     const Column x = Abscissae(sheet, histogram);
                     const int last = histogram.Bounces();
                     for (int k = 1; k <= last; ++k)
                         view.series.push_back(
                             Series(InLegend(k) ? "bounce " + std::to_string(k) : "",
                                    Mark::kLine, BounceColor(k, last), x,
                                    BinColumn(sheet, histogram, [k](const BounceBin& bin) {
                                        return bin.bounce[std::size_t(k)].mean;
                                    })));
                     return view;
                 });
    Plot totals = OverBoth(
        report,
        {.id = "totals",
         .title = "All bounces: E(ρ)",
         .caption = "Mean light of all bounces for each albedo ρ. At ρ = 1 it is 1 everywhere: "
                    "no light is lost.",
         .x = {},
         .y = {"E(ρ) [–, open ground = 1]", 0, 1.1},
         .views = {}},
        [&](const BounceHistogram& histogram) {
            PlotView view{.keys = {}, .series = {}, .x = {}, .y = {}};
            const Column x = Abscissae(sheet, histogram);
            for (const std::size_t r : PlottedAlbedos(histogram.albedos))
                view.series.push_back(
                    Series("ρ = " + Exact(histogram.albedos[r]), Mark::kLine,
                           ScaleColor(histogram.albedos[r]), x,
                           BinColumn(sheet, histogram,
                                     [r](const BounceBin& bin) { return bin.total[r].mean; })));
            return view;
        });
    totals.wide = true;
    return sheet.Group({{"over", "Over", {"α", "V"}}},
                       {CountPlot(report, sheet), direct, first, bounces, totals});
}

std::string FindingsHtml(const SimulateReport& report) {
    const SurfaceFigures& figures = report.surface.figures;
    std::string html =
        "<ul class=\"findings\">\n<li>On the average a facet of <b>" +
        Html(report.surface.name) + "</b> sees " + Digits(100 * figures.mean_alpha, 3) +
        " % of its hemisphere open (α) and "
        "receives <b>" +
        Digits(100 * figures.mean_V, 3) + " %</b> of the direct light of open ground (V); " +
        Digits(100 * figures.mean_first_bounce, 3) +
        " % more arrive after one bounce at albedo 1.</li>\n";
    if (std::isfinite(figures.max_furnace_error))
        html +=
            "<li>At albedo 1 the bounces of every facet sum to 1 " +
            (figures.max_furnace_error > 0 ? "within " + Digits(figures.max_furnace_error, 2)
                                           : std::string("exactly")) +
            ".</li>\n";
    if (figures.aperture)
        html += "<li>The openings of all facets add up to " +
                WithError(figures.aperture->value, figures.aperture->standard_error) +
                " of the ground area; on a closed surface that must be 1.</li>\n";
    if (std::isfinite(figures.light_under_way))
        html += "<li>After " + std::to_string(report.surface.over_alpha.Bounces()) +
                " bounces the worst facet still waits for " +
                Digits(100 * figures.light_under_way, 2) +
                " % of its light at albedo 1; the totals E(ρ) include it.</li>\n";
    return html + "</ul>\n";
}

}  // namespace

nlohmann::ordered_json ToJson(const SimulateReport& report) {
    Validate(report);
    nlohmann::ordered_json json{{"provenance", ToJson(report.provenance)},
                                {"surface", ToJson(report.surface)}};
    if (report.amplitudes) json["amplitudes"] = ToJson(*report.amplitudes);
    if (!report.timings.Empty()) json["timings"] = ToJson(report.timings);
    return json;
}

std::string ToHtml(const SimulateReport& report) {
    Validate(report);
    Page page("Light on " + report.surface.name,
              "A height map under a uniform white sky: what every facet sees of it, and what "
              "comes back from the surface bounce by bounce.");
    page.AddSection("findings", "Read this first", FindingsHtml(report));
    page.AddSection("surface", "The surface", SurfaceCards({&report.surface, 1}));
    page.AddSection("light", "Light over visibility", LightHtml(report, page.Plots()));
    if (report.amplitudes)
        page.AddSection("amplitude", "Effect of the amplitude",
                        AmplitudeHtml(*report.amplitudes, page.Plots()));
    page.AddSection("again", "How to make this again",
                    ProvenanceHtml(report.provenance, report.timings));
    return page.Text();
}

void WriteTable(std::ostream& out, const SimulateReport& report) {
    Validate(report);
    const SurfaceFigures& figures = report.surface.figures;
    const auto line = [&](const char* name, const std::string& value) {
        out << Left(name, 48) << Right(value, 24) << '\n';
    };
    out << report.surface.name << "\n\n";
    line("facets", Count(figures.facets));
    line("mean uniform visibility, alpha [-]", Digits(figures.mean_alpha, 5));
    line("mean cosine visibility, V [-]", Digits(figures.mean_V, 5));
    line("mean first bounce, E_1 [-]", Digits(figures.mean_first_bounce, 5));
    line("mean slope [deg]", Digits(figures.mean_slope_deg, 3));
    line("links a facet", Digits(figures.links_per_facet, 4));
    line("share of a hemisphere cut short [-]", Digits(figures.cut_short, 2));
    line("furnace error at albedo 1, worst facet [-]", Digits(figures.max_furnace_error, 2));
    line("light left after the last curve [-]", Digits(figures.light_under_way, 2));
    line("mean of V / n_z, 1 on a closed surface [-]",
         figures.aperture ? WithError(figures.aperture->value, figures.aperture->standard_error)
                          : "–");
}

std::string ToJsonText(const SimulateReport& report) {
    return JsonText(ToJson(report));
}

}  // namespace plumb
