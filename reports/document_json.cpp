// Documents as JSON: docs/schema/document-1.json says what is in it.
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "reports/json_text.h"
#include "reports/render.h"
#include "reports/sentence.h"

namespace plumb::doc {
namespace {

using Json = nlohmann::ordered_json;

Json NumberJson(double x) {
    return std::isfinite(x) ? Json(x) : Json(nullptr);
}

Json CellJson(const Cell& cell) {
    struct Visitor {
        Json operator()(std::monostate) const { return nullptr; }
        Json operator()(const std::string& text) const { return text; }
        Json operator()(std::int64_t n) const { return n; }
        Json operator()(double x) const { return NumberJson(x); }
        Json operator()(const Measured& m) const {
            return {{"value", NumberJson(m.value)},
                    {"standard_error", NumberJson(m.standard_error)},
                    {"low", NumberJson(m.interval.low)},
                    {"high", NumberJson(m.interval.high)},
                    {"noise_error", NumberJson(m.noise_error)}};
        }
    };
    return std::visit(Visitor{}, cell);
}

const char* NameOf(Role role) {
    return role == Role::kName ? "name" : role == Role::kTime ? "time" : "value";
}

const char* NameOf(Better better) {
    switch (better) {
        case Better::kNeither:
            return "neither";
        case Better::kLess:
            return "less";
        case Better::kMore:
            return "more";
        case Better::kNearZero:
            return "near zero";
    }
    return "";
}

Json ColumnJson(const Column& column) {
    return {{"key", column.key},           {"title", column.title},
            {"unit", column.unit},         {"digits", column.digits},
            {"role", NameOf(column.role)}, {"better", NameOf(column.better)},
            {"meaning", column.meaning}};
}

Json FactJson(const Fact& fact) {
    Json json = ColumnJson(fact.what);
    json["value"] = CellJson(fact.value);
    return json;
}

Json TableJson(const Table& table) {
    Json columns = Json::array(), rows = Json::array();
    for (const Column& column : table.columns) columns.push_back(ColumnJson(column));
    Json json{{"key", table.key},
              {"title", table.title},
              {"caption", PlainText(table.caption)},
              {"columns", std::move(columns)}};
    if (table.data) {
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
            Json& values = json["values"][table.columns[c].key] = Json::array();
            for (const auto& cells : table.rows) values.push_back(CellJson(cells[c]));
        }
        return json;
    }
    for (const auto& cells : table.rows) {
        Json row = Json::object();
        for (std::size_t c = 0; c < cells.size(); ++c) {
            row[table.columns[c].key] = CellJson(cells[c]);
        }
        rows.push_back(std::move(row));
    }
    json["rows"] = std::move(rows);
    return json;
}

/// Rows of numbers, each once however many series share it.
class Plotted {
  public:
    std::size_t PlaceOf(const plumb::Column& column) {
        const auto [at, is_new] = places_.emplace(&column.Values(), places_.size());
        if (is_new) {
            rows.push_back(Json::array());
            for (const double x : column.Values()) rows.back().push_back(NumberJson(x));
        }
        return at->second;
    }

    Json rows = Json::array();

  private:
    std::map<const std::vector<double>*, std::size_t> places_;
};

Json SeriesJson(const PlotSeries& series, Plotted& plotted) {
    Json json{{"label", series.label}};
    const auto add = [&](const char* name, const plumb::Column& column) {
        if (column.Given()) json[name] = plotted.PlaceOf(column);
    };
    add("x", series.x);
    add("y", series.y);
    add("minus", series.minus);
    add("high", series.high);
    return json;
}

Json PlotJson(const Plot& plot, Plotted& plotted) {
    Json views = Json::array();
    for (const PlotView& view : plot.views) {
        Json keys = Json::object(), series = Json::array();
        for (const auto& [key, value] : view.keys) keys[key] = value;
        for (const PlotSeries& one : view.series) series.push_back(SeriesJson(one, plotted));
        views.push_back({{"keys", std::move(keys)},
                         {"x_label", view.x ? view.x->label : plot.x.label},
                         {"y_label", view.y ? view.y->label : plot.y.label},
                         {"series", std::move(series)}});
    }
    return {{"id", plot.id},
            {"title", plot.title},
            {"caption", PlainText(plot.caption)},
            {"views", std::move(views)}};
}

Json SectionsJson(const std::vector<Section>& sections, Plotted& plotted) {
    Json all = Json::array();
    for (const Section& section : sections) {
        Json json{{"id", section.id},         {"title", section.title},
                  {"folded", section.folded}, {"sentences", Json::array()},
                  {"facts", Json::array()},   {"tables", Json::array()},
                  {"plots", Json::array()},   {"pictures", Json::array()}};
        for (const std::string& sentence : section.sentences) {
            json["sentences"].push_back(PlainText(sentence));
        }
        for (const Fact& fact : section.facts) json["facts"].push_back(FactJson(fact));
        for (const Table& table : section.tables) json["tables"].push_back(TableJson(table));
        for (const Plots& group : section.plots) {
            for (const Plot& plot : group.plots)
                json["plots"].push_back(PlotJson(plot, plotted));
        }
        for (const Picture& picture : section.pictures) {
            json["pictures"].push_back({{"alternative", picture.alternative},
                                        {"caption", PlainText(picture.caption)}});
        }
        json["sections"] = SectionsJson(section.sections, plotted);
        all.push_back(std::move(json));
    }
    return all;
}

}  // namespace

Json ToJson(const Document& document) {
    Json inputs = Json::array();
    for (const Input& input : document.provenance.inputs) {
        inputs.push_back({{"name", input.name}, {"sha256", input.sha256}});
    }
    Plotted plotted;
    Json sections = SectionsJson(document.sections, plotted);
    return {{"schema", "plumb document"},
            {"version", 1},
            {"kind", document.kind},
            {"title", document.title},
            {"subtitle", document.subtitle},
            {"provenance",
             {{"version", document.provenance.version},
              {"command", document.provenance.command},
              {"seed", document.provenance.seed},
              {"inputs", std::move(inputs)}}},
            {"sections", std::move(sections)},
            {"plotted", std::move(plotted.rows)}};
}

std::string ToJsonText(const Document& document) {
    return JsonText(ToJson(document));
}

}  // namespace plumb::doc
