// What a test reads back from a page: its tables as text, its plots as numbers.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace plumb {

using Rows = std::vector<std::vector<std::string>>;

/// Text of HTML: tags left out, entities as they are.
inline std::string WithoutTags(const std::string& html) {
    std::string text;
    bool tag = false;
    for (const char c : html) {
        if (c == '<') tag = true;
        if (!tag) text += c;
        if (c == '>') tag = false;
    }
    return text;
}

/// What stands between two marks, from `at` on, which moves behind it; empty at the end.
inline std::string Between(const std::string& text, const std::string& open,
                           const std::string& close, std::size_t& at) {
    const std::size_t begin = text.find(open, at);
    if (begin == std::string::npos) return at = std::string::npos, "";
    const std::size_t end = text.find(close, begin);
    at = end;
    return text.substr(begin + open.size(), end - begin - open.size());
}

/// All rows of the table whose head starts with `first` columns (as text), the head included.
inline Rows TableOf(const std::string& html, const std::vector<std::string>& first) {
    for (std::size_t at = 0;;) {
        const std::string table = Between(html, "<table", "</table>", at);
        if (at == std::string::npos) break;
        Rows rows;
        for (std::size_t row_at = 0;;) {
            const std::string row = Between(table, "<tr", "</tr>", row_at);
            if (row_at == std::string::npos) break;
            std::vector<std::string> cells;
            for (std::size_t cell_at = 0; cell_at < row.size();) {
                const std::size_t th = row.find("<th", cell_at), td = row.find("<td", cell_at);
                const std::size_t begin = std::min(th, td);
                if (begin == std::string::npos) break;
                const std::size_t content = row.find('>', begin) + 1;
                const std::size_t end = row.find(th < td ? "</th>" : "</td>", content);
                cells.push_back(WithoutTags(row.substr(content, end - content)));
                cell_at = end;
            }
            rows.push_back(std::move(cells));
        }
        if (!rows.empty() && rows[0].size() >= first.size() &&
            std::equal(first.begin(), first.end(), rows[0].begin()))
            return rows;
    }
    ADD_FAILURE() << "no table " << first.front();
    return {};
}

/// The fact or the table of that key in the JSON of a document, wherever it stands: of a fact its
/// value.
inline nlohmann::ordered_json PartOf(const nlohmann::ordered_json& sections, const char* list,
                                     const std::string& key) {
    for (const auto& section : sections) {
        for (const auto& part : section[list]) {
            if (part["key"] == key) return part;
        }
        const nlohmann::ordered_json within = PartOf(section["sections"], list, key);
        if (!within.is_null()) return within;
    }
    return nullptr;
}
inline nlohmann::ordered_json FactIn(const nlohmann::ordered_json& document,
                                     const std::string& key) {
    const auto fact = PartOf(document["sections"], "facts", key);
    EXPECT_TRUE(fact.is_object()) << "no fact " << key;
    return fact.is_object() ? fact["value"] : nullptr;
}
inline nlohmann::ordered_json TableIn(const nlohmann::ordered_json& document,
                                      const std::string& key) {
    const auto table = PartOf(document["sections"], "tables", key);
    EXPECT_TRUE(table.is_object()) << "no table " << key;
    return table;
}

/// The rows of the table with that id, its head left out.
inline Rows TableWithId(const std::string& html, const std::string& id) {
    std::size_t at = html.find("<table id=\"" + id + "\"");
    if (at == std::string::npos) {
        ADD_FAILURE() << "no table " << id;
        return {};
    }
    const std::string body = Between(html, "<tbody>", "</tbody>", at);
    Rows rows;
    for (std::size_t row_at = 0;;) {
        const std::string row = Between(body, "<tr>", "</tr>", row_at);
        if (row_at == std::string::npos) return rows;
        rows.emplace_back();
        for (std::size_t cell_at = 0;;) {
            const std::string cell = Between(row, "<td", "</td>", cell_at);
            if (cell_at == std::string::npos) break;
            std::string text = WithoutTags(cell.substr(cell.find('>') + 1));
            for (std::size_t q; (q = text.find("&#39;")) != std::string::npos;) {
                text.replace(q, 5, "'");
            }
            rows.back().push_back(text);
        }
    }
}

inline nlohmann::ordered_json PlotDataOf(const std::string& html) {
    std::size_t at = 0;
    return nlohmann::ordered_json::parse(
        Between(html, "<script type=\"application/json\" id=\"plumb-data\">", "</script>", at));
}

/// The series of a plot, in the view of those keys ({} = the only one), with that label and mark
/// ("" = any): its column `which`.
inline std::vector<double> SeriesOf(const nlohmann::ordered_json& data, const std::string& plot,
                                    const nlohmann::ordered_json& keys,
                                    const std::string& label, const std::string& which,
                                    const std::string& mark = "") {
    for (const auto& one : data["plots"]) {
        if (one["id"] != plot) continue;
        for (const auto& view : one["views"]) {
            if (!keys.empty() && view["keys"] != keys) continue;
            for (const auto& series : view["series"]) {
                if (series.value("label", "") != label) continue;
                if (!mark.empty() && series["mark"] != mark) continue;
                std::vector<double> values;
                for (const auto& value : data["columns"].at(series[which].get<std::size_t>()))
                    values.push_back(value.is_null() ? std::nan("") : value.get<double>());
                return values;
            }
        }
    }
    ADD_FAILURE() << "no series " << label << " of " << plot << " " << keys.dump();
    return {};
}

}  // namespace plumb
