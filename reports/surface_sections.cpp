#include "reports/surface_sections.h"

#include <algorithm>
#include <cmath>

#include "core/total_name.h"
#include "reports/columns.h"
#include "reports/histogram_plots.h"
#include "reports/text.h"

namespace plumb {
namespace {

std::vector<doc::Column> FigureColumns() {
    doc::Column slope = doc::Value("mean_slope_deg", "Mean slope");
    slope.unit = "°";
    return {doc::Value("facets", "Facets"),
            doc::Value("mean_uniform_visibility", "Mean α", 5),
            doc::Value("mean_cosine_visibility", "Mean V", 5),
            doc::Value("mean_first_bounce", "Mean E₁", 5,
                       "light after one bounce at albedo 1, open ground = 1"),
            slope,
            doc::Value("links_per_facet", "Links a facet", 4),
            doc::Value("cut_short", "Hemisphere cut short", 2,
                       "share of a hemisphere whose line of sight was cut"),
            doc::Value("max_furnace_error", "Furnace error, worst facet", 2,
                       "what is missing to 1, or too much, of all bounces at albedo 1"),
            doc::Value("light_under_way", "Light left after the last curve, worst facet", 2,
                       "at albedo 1"),
            doc::Value("bounces_run", "Bounces run until the totals were settled"),
            doc::Value("aperture", "Mean of V / n_z", 3,
                       "1 on a closed surface, whatever its shape")};
}

std::vector<doc::Cell> FigureCells(const SurfaceFigures& f) {
    const doc::Cell aperture = f.aperture ? doc::Cell(*f.aperture) : doc::Cell();
    return {f.facets,          f.mean_alpha,      f.mean_V,    f.mean_first_bounce,
            f.mean_slope_deg,  f.links_per_facet, f.cut_short, f.max_furnace_error,
            f.light_under_way, f.bounces_run,     aperture};
}

template <class T>
void Append(std::vector<T>& to, std::vector<T> more) {
    to.insert(to.end(), more.begin(), more.end());
}

std::string PercentOfWidth(double amplitude_of_width) {
    return Exact(Rounded(100 * amplitude_of_width, 3)) + " %";
}

doc::Table AmplitudeTable(const AmplitudeSweep& sweep) {
    doc::Table table{.key = "amplitudes",
                     .columns = {doc::Name("amplitude_of_width", "Amplitude, of width"),
                                 {.key = "amplitude_m", .title = "Amplitude", .unit = "m"}}};
    for (doc::Column column : FigureColumns()) {
        column.detail = !column.key.starts_with("mean_") || column.key.ends_with("_deg");
        table.columns.push_back(std::move(column));
    }
    Append(table.columns, {doc::ErrorOf("recommended_rms", "RMS recommended", 3,
                                        "of E(ρ) of the recommended formula"),
                           doc::ErrorOf("published_rms", "RMS published", 3,
                                        "of E(ρ) of the published formula")});
    for (const AmplitudePoint& point : sweep.points) {
        std::vector<doc::Cell> row{point.amplitude_of_width, point.amplitude_m};
        Append(row, FigureCells(point.figures));
        Append<doc::Cell>(row, {point.recommended_rms, point.published_rms});
        table.Add(std::move(row));
    }
    return table;
}

Plot CurvesAtAmplitudes(const AmplitudeSweep& sweep) {
    PlotView view;
    const double last = double(std::max<std::size_t>(sweep.points.size(), 2) - 1);
    for (std::size_t i = 0; i < sweep.points.size(); ++i) {
        const AmplitudePoint& point = sweep.points[i];
        if (point.over_alpha.Bounces() < 1) continue;
        view.series.push_back(
            {.label = PercentOfWidth(point.amplitude_of_width),
             .mark = Mark::kDots,
             .color = ScaleColor(double(i) / last),
             .x = Abscissae(point.over_alpha),
             .y = BinColumn(point.over_alpha,
                            [](const BounceBin& bin) { return bin.bounce[1].mean; }),
             .joined = true});
    }
    return {.id = "amplitude-curves",
            .title = "The first bounce at several amplitudes",
            .caption =
                "Each curve is the mean E_{1} of the same map with its heights stretched. "
                "If the curves lie on each other, one set of constants serves all "
                "amplitudes; where they fan out, it does not.",
            .x = {"uniform visibility α [–]", 0, 1},
            .y = {"first bounce E₁ [–, open ground = 1]", 0, {}},
            .views = {view}};
}

Plot MeansOverAmplitude(const AmplitudeSweep& sweep) {
    PlotView view;
    std::vector<double> shares;
    for (const AmplitudePoint& point : sweep.points) {
        shares.push_back(100 * point.amplitude_of_width);
    }
    const Column x = std::move(shares);
    const auto add = [&](const char* label, const char* color, double SurfaceFigures::*mean) {
        std::vector<double> values;
        for (const AmplitudePoint& point : sweep.points) values.push_back(point.figures.*mean);
        view.series.push_back({.label = label,
                               .mark = Mark::kDots,
                               .color = color,
                               .x = x,
                               .y = std::move(values),
                               .joined = true});
    };
    add("mean α", "#3b4048", &SurfaceFigures::mean_alpha);
    add("mean V", kOursColor, &SurfaceFigures::mean_V);
    add("mean E₁", "#009e73", &SurfaceFigures::mean_first_bounce);
    return {.id = "amplitude-means",
            .title = "Means over the surface against amplitude",
            .caption =
                "A flat map (left) is open everywhere and has nothing to bounce from; a "
                "very deep one (right) lets little light in. In between lies the range in "
                "which a map says something of every α.",
            .x = {.label = "amplitude, share of the map's width [%]", .logarithmic = true},
            .y = {"mean over the surface [–]", 0, 1},
            .views = {view}};
}

}  // namespace

std::vector<doc::Fact> FactsOf(const SurfaceFigures& figures) {
    const std::vector<doc::Column> columns = FigureColumns();
    const std::vector<doc::Cell> cells = FigureCells(figures);
    std::vector<doc::Fact> facts;
    for (std::size_t c = 0; c < cells.size(); ++c) facts.push_back({columns[c], cells[c]});
    return facts;
}

doc::Table FiguresTable(std::span<const SurfaceReport> maps) {
    doc::Table table{.key = "surfaces", .columns = {doc::Name("map", "Map")}};
    Append(table.columns, FigureColumns());
    for (const SurfaceReport& map : maps) {
        std::vector<doc::Cell> row{map.name};
        Append(row, FigureCells(map.figures));
        table.Add(std::move(row));
    }
    return table;
}

std::vector<doc::Picture> PicturesOf(const SurfaceReport& map) {
    std::vector<doc::Picture> pictures;
    const auto add = [&](const std::string& uri, const std::string& what) {
        if (uri.empty()) return;
        pictures.push_back(
            {uri, map.name + ": " + what, "*" + doc::Verbatim(map.name) + "*: " + what});
    };
    add(map.heights_picture, "heights, shaded");
    add(map.visibility_picture, "V, black 0 to white 1");
    return pictures;
}

doc::Table HistogramTable(
    std::string key, std::string title, std::string what,
    const std::vector<std::pair<std::string, const BounceHistogram*>>& histograms) {
    doc::Table table{.key = std::move(key),
                     .title = std::move(title),
                     .columns = {doc::Name(what, what), doc::Name("low", "From"),
                                 doc::Name("high", "To"), doc::Value("count", "Facets"),
                                 doc::Value("alpha", "Mean α"), doc::Value("v", "Mean V")},
                     .data = true};
    const auto spread = [&](const std::string& name) {
        std::string quantity = name;
        std::transform(name.begin(), name.end(), quantity.begin(), ::tolower);
        table.columns.push_back({.key = quantity, .title = name + ", mean"});
        for (const auto& [ending, title_of] :
             {std::pair{"_var", "variance among facets"}, std::pair{"_p05", "5 % percentile"},
              std::pair{"_p50", "median"}, std::pair{"_p95", "95 % percentile"}}) {
            table.columns.push_back(
                {.key = quantity + ending, .title = name + ", " + title_of});
        }
    };
    const BounceHistogram none, &first = histograms.empty() ? none : *histograms.front().second;
    for (int k = 0; k <= first.Bounces(); ++k) spread("E" + std::to_string(k));
    for (const double rho : first.albedos) spread(TotalName(Albedo(rho)));
    for (const auto& [name, histogram] : histograms) {
        for (const BounceBin& bin : histogram->bins) {
            if (bin.count == 0) continue;
            std::vector<doc::Cell> row{name, bin.low, bin.high, bin.count, bin.alpha, bin.V};
            for (const auto* spreads : {&bin.bounce, &bin.total}) {
                for (const Spread& s : *spreads) {
                    Append<doc::Cell>(row, {s.mean, s.variance, s.p05, s.p50, s.p95});
                }
            }
            table.Add(std::move(row));
        }
    }
    return table;
}

doc::Section AmplitudeSection(const AmplitudeSweep& sweep) {
    doc::Section section{.id = "amplitude", .title = "Effect of the amplitude"};
    std::vector<std::pair<std::string, const BounceHistogram*>> histograms;
    double lowest = 1, highest = 0;
    for (const AmplitudePoint& point : sweep.points) {
        lowest = std::min(lowest, point.figures.mean_V);
        highest = std::max(highest, point.figures.mean_V);
        if (!point.over_alpha.bins.empty())
            histograms.push_back({PercentOfWidth(point.amplitude_of_width), &point.over_alpha});
    }
    if (!sweep.points.empty()) {
        section.sentences = {
            "Map: " + doc::Verbatim(sweep.map) + ". Its heights were stretched from " +
            PercentOfWidth(sweep.points.front().amplitude_of_width) + " to " +
            PercentOfWidth(sweep.points.back().amplitude_of_width) +
            " of its width; mean V went from " + Digits(highest) + " to " + Digits(lowest) +
            ". The paper says that the amplitude has little influence on the curves but for "
            "extreme values."};
    }
    doc::Plots plots;
    const Plot curves = CurvesAtAmplitudes(sweep);
    if (!curves.views.front().series.empty()) plots.plots.push_back(curves);
    plots.plots.push_back(MeansOverAmplitude(sweep));
    section.plots = {std::move(plots)};
    section.tables = {AmplitudeTable(sweep),
                      HistogramTable("amplitude_histograms", "Histograms over α",
                                     "amplitude_of_width", histograms)};
    return section;
}

doc::Provenance DocumentProvenance(const Provenance& provenance) {
    doc::Provenance out{.version = provenance.tool_version,
                        .command = provenance.command,
                        .seed = provenance.sampling.seed};
    for (const MapSource& map : provenance.maps) out.inputs.push_back({map.name, map.sha256});
    return out;
}

doc::Section OriginSection(const Provenance& provenance, const Timings& timings) {
    doc::Section section{
        .id = "origin",
        .title = "What went in",
        .folded = true,
        .sentences = {"The same command on the same files gives the same figures to the last "
                      "digit, on any number of threads; only times differ."}};
    const auto fact = [&](const char* key, const char* title, doc::Cell value) {
        section.facts.push_back({{.key = key, .title = title}, std::move(value)});
    };
    if (provenance.sampling.per_facet > 0) {
        fact("method", "Links by", provenance.sampling.method);
        fact("per_facet", "Slices or rays a facet", provenance.sampling.per_facet);
        section.facts.push_back(
            {{.key = "cut_texels",
              .title = "Strips of steep facets, height",
              .unit = "texels",
              .meaning = "Of one strip, where a facet needs no more than it may have; 0 = "
                         "no facet is cut"},
             provenance.sampling.cut_texels});
        fact("most_pieces", "Strips of a facet, at most", provenance.sampling.most_pieces);
    }
    fact("bounces", "Bounces kept", provenance.bounces);
    fact("bins", "Bins", provenance.bins);
    if (!provenance.weighting.empty())
        fact("weighting", "Weight of a sample", provenance.weighting);
    doc::Table albedos{.key = "albedos",
                       .columns = {doc::Value("albedo", "Albedos of the totals")},
                       .data = true};
    for (const double rho : provenance.albedos) albedos.Add({rho});

    doc::Table maps{.key = "maps",
                    .columns = {doc::Name("map", "Map"),
                                doc::Value("file", "File"),
                                {.key = "width_texels", .title = "Width", .unit = "texels"},
                                {.key = "height_texels", .title = "Height", .unit = "texels"},
                                {.key = "spacing_x_m", .title = "Spacing x", .unit = "m"},
                                {.key = "spacing_y_m", .title = "Spacing y", .unit = "m"},
                                {.key = "amplitude_m", .title = "Amplitude", .unit = "m"},
                                doc::Value("boundary", "Boundary"),
                                doc::Value("preparation", "Preparation"),
                                doc::Value("source", "Source"),
                                doc::Value("licence", "Licence")}};
    for (const MapSource& map : provenance.maps) {
        const auto text = [](const std::string& said) {
            return said.empty() ? doc::Cell() : doc::Cell(said);
        };
        maps.Add({map.name, map.file.empty() ? "made by the program" : map.file,
                  map.width_texels, map.height_texels, map.spacing_x_m, map.spacing_y_m,
                  map.amplitude_m, text(map.boundary), text(map.preparation), text(map.source),
                  text(map.licence)});
    }
    doc::Table stages{
        .key = "stages",
        .title = "Times of this run",
        .columns = {
            doc::Name("map", "Map"),
            doc::Name("stage", "Stage"),
            {.key = "seconds", .title = "Time", .unit = "s", .role = doc::Role::kTime}}};
    for (const StageTiming& stage : timings) {
        stages.Add({stage.map, stage.stage, stage.seconds});
    }
    section.tables = {std::move(maps), std::move(albedos)};
    if (!timings.empty()) section.tables.push_back(std::move(stages));
    return section;
}

}  // namespace plumb
