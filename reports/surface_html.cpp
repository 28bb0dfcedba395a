#include "reports/surface_html.h"

#include <algorithm>
#include <cmath>

#include "reports/text.h"

namespace plumb {
namespace {

void AddFigure(std::string& html, const std::string& name, const std::string& value) {
    html += "<dt>" + name + "</dt><dd>" + value + "</dd>\n";
}

std::string FigureList(const SurfaceFigures& figures) {
    std::string html = "<dl>\n";
    AddFigure(html, "facets", Count(figures.facets));
    AddFigure(html, "mean α", Digits(figures.mean_alpha, 4));
    AddFigure(html, "mean V", Digits(figures.mean_V, 4));
    AddFigure(html, "mean E<sub>1</sub>", Digits(figures.mean_first_bounce, 4));
    AddFigure(html, "mean slope", Digits(figures.mean_slope_deg, 3) + "°");
    AddFigure(html, "links a facet", Digits(figures.links_per_facet, 4));
    AddFigure(html, "hemisphere cut short", Digits(figures.cut_short, 2));
    AddFigure(html, "furnace error, worst facet", Digits(figures.max_furnace_error, 2));
    AddFigure(html, "light left after the last curve, worst facet",
              Digits(figures.light_under_way, 2));
    AddFigure(html, "mean of V / n<sub>z</sub> (1 if closed)",
              figures.aperture
                  ? WithError(figures.aperture->value, figures.aperture->standard_error)
                  : "–");
    return html + "</dl>\n";
}

std::string PictureBox(const std::string& data_uri, const std::string& name,
                       const std::string& what) {
    if (data_uri.empty()) return {};
    return "<div>" + Picture(data_uri, name + ": " + what, "SurfaceReport picture") + what +
           "</div>\n";
}

std::string PercentOfWidth(double amplitude_of_width) {
    return Exact(Rounded(100 * amplitude_of_width, 3)) + " %";
}

}  // namespace

std::string SurfaceCards(std::span<const SurfaceReport> maps) {
    std::string html = "<div class=\"maps\">\n";
    for (const SurfaceReport& map : maps) {
        html += "<div class=\"map\"><h3>" + Html(map.name) + "</h3>\n<div class=\"pictures\">";
        html += PictureBox(map.heights_picture, map.name, "heights, shaded");
        html += PictureBox(map.visibility_picture, map.name, "V, black 0 to white 1");
        html += "</div>\n" + FigureList(map.figures) + "</div>\n";
    }
    return html + "</div>\n";
}

std::string AbscissaLabel(BinnedBy binned_by) {
    return binned_by == BinnedBy::kUniformVisibility ? "uniform visibility α [–]"
                                                     : "cosine visibility V [–]";
}

Column Abscissae(PlotSheet& sheet, const BounceHistogram& histogram) {
    return BinColumn(sheet, histogram, [&](const BounceBin& bin) {
        return histogram.binned_by == BinnedBy::kUniformVisibility ? bin.alpha : bin.V;
    });
}

std::optional<BounceHistogram> PooledMeans(std::span<const BounceHistogram* const> maps) {
    if (maps.empty()) return {};
    BounceHistogram pooled{.surface = "all maps",
                           .binned_by = maps[0]->binned_by,
                           .albedos = maps[0]->albedos,
                           .bins = {}};
    const std::size_t bounces = std::size_t(maps[0]->Bounces()) + 1;
    std::vector<double> facets;
    for (const BounceHistogram* map : maps) {
        if (map->bins.size() != maps[0]->bins.size() || map->albedos != pooled.albedos ||
            map->binned_by != pooled.binned_by || std::size_t(map->Bounces()) + 1 != bounces)
            return {};
        facets.push_back(0);
        for (const BounceBin& bin : map->bins) facets.back() += double(bin.count);
    }
    for (std::size_t b = 0; b < maps[0]->bins.size(); ++b) {
        BounceBin bin;
        bin.low = maps[0]->bins[b].low;
        bin.high = maps[0]->bins[b].high;
        bin.bounce.resize(bounces);
        bin.total.resize(pooled.albedos.size());
        double sum_w = 0;
        for (std::size_t m = 0; m < maps.size(); ++m) {
            const BounceBin& from = maps[m]->bins[b];
            if (from.low != bin.low || from.high != bin.high) return {};
            if (from.count == 0) continue;
            const double w = double(from.count) / facets[m];
            sum_w += w;
            bin.count += from.count;
            bin.alpha += w * from.alpha;
            bin.V += w * from.V;
            for (std::size_t k = 0; k < bounces; ++k)
                bin.bounce[k].mean += w * from.bounce[k].mean;
            for (std::size_t r = 0; r < bin.total.size(); ++r)
                bin.total[r].mean += w * from.total[r].mean;
        }
        if (sum_w > 0) {
            bin.alpha /= sum_w;
            bin.V /= sum_w;
            for (Spread& spread : bin.bounce) spread.mean /= sum_w;
            for (Spread& spread : bin.total) spread.mean /= sum_w;
        }
        pooled.bins.push_back(std::move(bin));
    }
    return pooled;
}

std::string BounceColor(int bounce, int last) {
    return ScaleColor(last > 1 ? std::log(bounce) / std::log(last) : 0);
}

bool InLegend(int bounce) {
    return bounce <= 3 || bounce == 5 || bounce % 10 == 0;
}

std::vector<std::size_t> PlottedAlbedos(const std::vector<double>& albedos) {
    std::vector<std::size_t> tenths, all;
    for (std::size_t r = 0; r < albedos.size(); ++r) {
        all.push_back(r);
        if (std::abs(albedos[r] * 10 - std::round(albedos[r] * 10)) < 1e-9) tenths.push_back(r);
    }
    return tenths.size() >= 6 ? tenths : all;
}

std::string AmplitudeHtml(const AmplitudeSweep& sweep, PlotSheet& sheet) {
    std::vector<double> x, alpha, V, first;
    std::vector<std::vector<Cell>> rows;
    const bool scored = std::any_of(
        sweep.points.begin(), sweep.points.end(),
        [](const AmplitudePoint& point) { return std::isfinite(point.recommended_rms); });
    PlotView curves;
    double lowest = 1, highest = 0;
    for (std::size_t i = 0; i < sweep.points.size(); ++i) {
        const AmplitudePoint& point = sweep.points[i];
        x.push_back(100 * point.amplitude_of_width);
        alpha.push_back(point.figures.mean_alpha);
        V.push_back(point.figures.mean_V);
        first.push_back(point.figures.mean_first_bounce);
        lowest = std::min(lowest, point.figures.mean_V);
        highest = std::max(highest, point.figures.mean_V);
        rows.push_back({{PercentOfWidth(point.amplitude_of_width), "", ""},
                        {Digits(point.amplitude_m), "", ""},
                        {Digits(point.figures.mean_alpha, 4), "", ""},
                        {Digits(point.figures.mean_V, 4), "", ""},
                        {Digits(point.figures.mean_first_bounce, 4), "", ""}});
        if (scored) {
            rows.back().push_back({Digits(point.recommended_rms), "", ""});
            rows.back().push_back({Digits(point.published_rms), "", ""});
        }
        if (point.over_alpha.Bounces() < 1) continue;
        curves.series.push_back(
            {.label = PercentOfWidth(point.amplitude_of_width),
             .mark = Mark::kDots,
             .color = ScaleColor(double(i) /
                                 double(std::max<std::size_t>(sweep.points.size() - 1, 1))),
             .x = Abscissae(sheet, point.over_alpha),
             .y = BinColumn(sheet, point.over_alpha,
                            [](const BounceBin& bin) { return bin.bounce[1].mean; }),
             .minus = {},
             .high = {},
             .joined = true,
             .shape = 0});
    }

    const Axis share{.label = "amplitude, share of the map's width [%]",
                     .low = {},
                     .high = {},
                     .logarithmic = true};
    const Column at = sheet.Add(x);
    const auto mean = [&](const char* label, const char* color,
                          const std::vector<double>& values) {
        return PlotSeries{.label = label,
                          .mark = Mark::kDots,
                          .color = color,
                          .x = at,
                          .y = sheet.Add(values),
                          .minus = {},
                          .high = {},
                          .joined = true,
                          .shape = 0};
    };
    std::vector<Plot> plots;
    if (!curves.series.empty()) {
        Plot first_bounce;
        first_bounce.id = "amplitude-curves";
        first_bounce.title = "The first bounce at several amplitudes";
        first_bounce.caption =
            "Each curve is the mean E<sub>1</sub> of the same map with its heights stretched. "
            "If "
            "the curves lie on each other, one set of constants serves all amplitudes; where "
            "they fan out, it does not.";
        first_bounce.x = {"uniform visibility α [–]", 0, 1};
        first_bounce.y = {"first bounce E₁ [–, open ground = 1]", 0, {}};
        first_bounce.views = {curves};
        plots.push_back(std::move(first_bounce));
    }
    PlotView means;
    means.series = {mean("mean α", "#3b4048", alpha), mean("mean V", kOursColor, V),
                    mean("mean E₁", "#009e73", first)};
    Plot over_amplitude;
    over_amplitude.id = "amplitude-means";
    over_amplitude.title = "Means over the surface against amplitude";
    over_amplitude.caption =
        "A flat map (left) is open everywhere and has nothing to bounce from; a very deep one "
        "(right) lets little light in. In between lies the range in which a map says something "
        "of every α.";
    over_amplitude.x = share;
    over_amplitude.y = {"mean over the surface [–]", 0, 1};
    over_amplitude.views = {means};
    plots.push_back(std::move(over_amplitude));
    std::string html =
        "<p>Map: " + Html(sweep.map) + ". Its heights were stretched from " +
        PercentOfWidth(sweep.points.empty() ? 0 : sweep.points.front().amplitude_of_width) +
        " to " +
        PercentOfWidth(sweep.points.empty() ? 0 : sweep.points.back().amplitude_of_width) +
        " of its width; mean V went from " + Digits(highest) + " to " + Digits(lowest) +
        ". The paper says that the amplitude has little influence on the "
        "curves but for extreme values.</p>\n";
    html += sheet.Group({}, std::move(plots));
    std::vector<Head> head{{"amplitude, of width"},
                           {"amplitude [m]"},
                           {"mean α [–]"},
                           {"mean V [–]"},
                           {"mean E₁ [–]"}};
    if (scored) head.insert(head.end(), {{"RMS recommended [–]"}, {"RMS published [–]"}});
    return html + Table(head, rows);
}

std::string ProvenanceHtml(const Provenance& provenance, const Timings& timings) {
    std::string html =
        "<pre class=\"command\">" + Html(provenance.command) + "</pre>\n<p>" + "plumb " +
        Html(provenance.tool_version) + "; " + std::to_string(provenance.sampling.per_facet) +
        " " + Html(provenance.sampling.method) + " a facet, seed " +
        std::to_string(provenance.sampling.seed) + "; " + std::to_string(provenance.bounces) +
        " bounces; " + std::to_string(provenance.bins) + " bins; " +
        std::to_string(provenance.albedos.size()) + " albedos from " +
        (provenance.albedos.empty() ? "–"
                                    : Digits(provenance.albedos.front(), 2) + " to " +
                                          Digits(provenance.albedos.back(), 2));
    if (!provenance.weighting.empty())
        html += "; weight of a sample: " + Html(provenance.weighting);
    html +=
        ". The same command on the same files gives the same figures to the last digit, on "
        "any number of threads; only what is in seconds or bytes of memory differs.</p>\n";

    std::vector<std::vector<Cell>> rows;
    for (const MapSource& map : provenance.maps)
        rows.push_back(
            {{Html(map.name), "", ""},
             {Html(map.file.empty() ? "made by the program" : map.file), "", ""},
             {std::to_string(map.width_texels) + " × " + std::to_string(map.height_texels), "",
              ""},
             {Digits(map.spacing_x_m) + " × " + Digits(map.spacing_y_m), "", ""},
             {Digits(map.amplitude_m), "", ""},
             {Html(map.boundary), "", ""},
             {Html(map.preparation.empty() ? "none" : map.preparation), "", ""},
             {Html(map.source + (map.licence.empty() ? "" : " (" + map.licence + ")")), "wrap",
              ""},
             {"<code>" + Html(map.sha256) + "</code>", "hash", ""}});
    html += Table({{"map"},
                   {"file", true},
                   {"texels"},
                   {"spacing [m]"},
                   {"amplitude [m]"},
                   {"boundary", true},
                   {"preparation", true},
                   {"source", true},
                   {"sha256", true}},
                  rows);

    if (timings.Empty()) return html;
    rows.clear();
    for (const StageTiming& stage : timings.stages)
        rows.push_back({{Html(stage.map), "", ""},
                        {Html(stage.stage), "", ""},
                        {Digits(stage.seconds), "", ""}});
    html += "<h3>Timings</h3>\n<p class=\"note\">Of this run on this machine: ";
    html += std::to_string(timings.threads) + (timings.threads == 1 ? " thread" : " threads");
    if (timings.peak_memory_bytes > 0)
        html += ", peak memory " + Digits(timings.peak_memory_bytes / (1 << 20)) + " MiB";
    if (timings.machine_rays_per_second > 0)
        html += ", raw ray casting " + Digits(timings.machine_rays_per_second / 1e6) +
                " million rays a second";
    return html + ".</p>\n" + Table({{"map"}, {"stage", true}, {"time [s]"}}, rows);
}

}  // namespace plumb
