#include "reports/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "reports/text.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kPlotDigits = 6;

Json AxisJson(const Axis& axis) {
    Json json = Json::object();
    json["label"] = axis.label;
    if (axis.low) json["min"] = *axis.low;
    if (axis.high) json["max"] = *axis.high;
    if (axis.logarithmic) json["log"] = true;
    return json;
}

std::string MarkName(Mark mark) {
    switch (mark) {
        case Mark::kDots:
            return "dots";
        case Mark::kLine:
            return "line";
        case Mark::kDashed:
            return "dashed";
        case Mark::kBand:
            return "band";
    }
    return {};
}

// The places of columns on a sheet, by where their numbers are.
using Places = std::map<const std::vector<double>*, std::size_t>;

Json SeriesJson(const PlotSeries& series, const Places& places) {
    Json json{
        {"label", series.label}, {"mark", MarkName(series.mark)}, {"color", series.color}};
    const auto point_to = [&](const char* name, const Column& column) {
        if (column.Given()) json[name] = places.at(&column.Values());
    };
    point_to("x", series.x);
    point_to("y", series.y);
    point_to("minus", series.minus);
    point_to("high", series.high);
    if (series.joined) json["joined"] = true;
    if (series.shape != 0) json["shape"] = series.shape;
    return json;
}

Json PlotJson(const Plot& plot, std::size_t group, const Places& places) {
    Json views = Json::array();
    for (const PlotView& view : plot.views) {
        Json keys = Json::object();
        for (const auto& [key, value] : view.keys) keys[key] = value;
        Json series = Json::array();
        for (const PlotSeries& one : view.series) series.push_back(SeriesJson(one, places));
        Json json{{"keys", keys}, {"series", series}};
        if (view.x) json["x"] = AxisJson(*view.x);
        if (view.y) json["y"] = AxisJson(*view.y);
        views.push_back(std::move(json));
    }
    return {{"id", plot.id},
            {"group", group},
            {"x", AxisJson(plot.x)},
            {"y", AxisJson(plot.y)},
            {"views", views}};
}

}  // namespace

Column PlotSheet::Add(std::span<const double> values) {
    columns_.push_back(std::vector<double>(values.begin(), values.end()));
    return columns_.back();
}

void PlotSheet::Place(const Column& column) {
    if (!column.Given()) return;
    for (const Column& placed : columns_) {
        if (&placed.Values() == &column.Values()) return;
    }
    columns_.push_back(column);
}

std::string PlotSheet::Group(const std::vector<PlotSelector>& selectors,
                             std::vector<Plot> plots) {
    const std::size_t group = groups_.size();
    std::string html;
    for (const PlotSelector& selector : selectors) {
        if (selector.options.size() < 2) continue;
        html += "<label>" + Html(selector.label) + " <select data-group=\"" +
                std::to_string(group) + "\" data-key=\"" + Html(selector.key) + "\">";
        for (const std::string& option : selector.options)
            html += "<option>" + Html(option) + "</option>";
        html += "</select></label>\n";
    }
    if (!html.empty()) html = "<div class=\"selectors\">" + html + "</div>\n";

    html += "<div class=\"plots\">\n";
    for (const Plot& plot : plots) {
        html += std::string("<figure class=\"plot") + (plot.wide ? " wide" : "") + "\"><h3>" +
                Html(plot.title) + "</h3><div class=\"canvas\"><canvas id=\"" + Html(plot.id) +
                "\" role=\"img\" aria-label=\"" + Html(plot.title) +
                "\"></canvas></div><figcaption>" + plot.caption + "</figcaption></figure>\n";
    }
    for (const Plot& plot : plots) {
        for (const PlotView& view : plot.views) {
            for (const PlotSeries& series : view.series) {
                for (const Column& column : {series.x, series.y, series.minus, series.high}) {
                    Place(column);
                }
            }
        }
    }
    groups_.push_back(std::move(plots));
    return html + "</div>\n";
}

Json PlotSheet::ToJson() const {
    Json plots = Json::array(), columns = Json::array();
    Places places;
    for (const Column& column : columns_) {
        places[&column.Values()] = places.size();
        Json numbers = Json::array();
        for (const double x : column.Values()) numbers.push_back(Rounded(x, kPlotDigits));
        columns.push_back(std::move(numbers));
    }
    for (std::size_t group = 0; group < groups_.size(); ++group)
        for (const Plot& plot : groups_[group]) plots.push_back(PlotJson(plot, group, places));
    return {{"columns", columns}, {"plots", plots}};
}

std::string CategoryColor(int i) {
    static constexpr std::array<const char*, 7> kColors{
        "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#3b4048"};
    return kColors[std::size_t(i) % kColors.size()];
}

std::string DotColor(int i) {
    static constexpr std::array<const char*, 9> kColors{"#88ccee", "#cc6677", "#ddcc77",
                                                        "#332288", "#44aa99", "#aa4499",
                                                        "#999933", "#882255", "#117733"};
    return kColors[std::size_t(i) % kColors.size()];
}

std::string ScaleColor(double share) {
    // Every eighth of viridis [matplotlib], from 0 to 7/8.
    static constexpr std::array<std::array<int, 3>, 8> kAnchors{{{68, 1, 84},
                                                                 {71, 45, 123},
                                                                 {59, 82, 139},
                                                                 {44, 114, 142},
                                                                 {33, 145, 140},
                                                                 {40, 174, 128},
                                                                 {94, 201, 98},
                                                                 {173, 220, 48}}};
    const double at =
        std::clamp(share, 0.0, 1.0) * 6.6;  // Short of the last, too light anchor.
    const auto i = std::size_t(at);
    char text[8];
    std::array<int, 3> rgb{};
    for (std::size_t c = 0; c < 3; ++c)
        rgb[c] = int(std::lround(kAnchors[i][c] +
                                 (at - double(i)) * (kAnchors[i + 1][c] - kAnchors[i][c])));
    std::snprintf(text, sizeof text, "#%02x%02x%02x", unsigned(rgb[0]) & 255u,
                  unsigned(rgb[1]) & 255u, unsigned(rgb[2]) & 255u);
    return text;
}

}  // namespace plumb
