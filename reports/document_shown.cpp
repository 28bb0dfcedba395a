// What people see of a table.
#include <algorithm>
#include <cmath>

#include "core/names.h"
#include "reports/render.h"
#include "reports/text.h"

namespace plumb::doc {
namespace {

std::string NameOf(const Cell& cell) {
    const auto* text = std::get_if<std::string>(&cell);
    return text != nullptr ? *text : Exact(NumberOf(cell));
}

/// The place of `name`, put at the end if it is new.
std::size_t PlaceIn(std::vector<std::string>& names, std::string name) {
    const auto at = std::find(names.begin(), names.end(), name);
    const auto place = std::size_t(at - names.begin());
    if (at == names.end()) names.push_back(std::move(name));
    return place;
}

/// The names of column `across` as columns, each of them of the values of column `v`.
Table SideBySide(const Table& table, std::size_t across, std::size_t v) {
    const Column& value = table.columns[v];
    Table wide{.key = table.key + "_" + value.key,
               .title = value.title + (value.unit.empty() ? "" : " [" + value.unit + "]"),
               .columns = {},
               .judged = table.judged};
    std::vector<std::size_t> names;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        if (c == across || table.columns[c].role != Role::kName) continue;
        names.push_back(c);
        wide.columns.push_back(table.columns[c]);
    }
    std::vector<std::string> heads, firsts;
    for (const auto& row : table.rows) {
        const std::string head = NameOf(row[across]);
        const std::size_t column = names.size() + PlaceIn(heads, head);
        if (column == wide.columns.size()) {
            wide.columns.push_back(value);
            wide.columns.back().title = head;
            wide.columns.back().unit.clear();
        }
        std::string joined;
        for (const std::size_t c : names) joined += NameOf(row[c]) + '\0';
        const std::size_t place = PlaceIn(firsts, joined);
        if (place == wide.rows.size()) {
            wide.rows.emplace_back();
            for (const std::size_t c : names) wide.rows.back().push_back(row[c]);
        }
        wide.rows[place].resize(std::max(column + 1, wide.rows[place].size()));
        wide.rows[place][column] = row[v];
    }
    for (auto& row : wide.rows) row.resize(wide.columns.size());
    return wide;
}

}  // namespace

std::vector<Table> Shown(const Table& table) {
    // What is drawn stays, whatever it holds.
    const auto drawn = [&](const std::string& key) {
        return !table.steps.empty() && (key == table.steps || key == table.ticks);
    };
    const auto holds = [&](std::size_t c) {
        return drawn(table.columns[c].key) ||
               std::any_of(table.rows.begin(), table.rows.end(), [&](const auto& row) {
                   return std::holds_alternative<std::string>(row[c]) ||
                          std::isfinite(NumberOf(row[c]));
               });
    };
    Table seen = table;
    seen.columns.clear();
    for (auto& row : seen.rows) row.clear();
    std::vector<std::size_t> values;
    std::vector<std::string> keys;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        if (table.columns[c].detail || !holds(c)) continue;
        if (table.columns[c].role != Role::kName) values.push_back(keys.size());
        keys.push_back(table.columns[c].key);
        seen.columns.push_back(table.columns[c]);
        for (std::size_t r = 0; r < table.rows.size(); ++r) {
            seen.rows[r].push_back(table.rows[r][c]);
        }
    }
    if (table.data || values.empty()) return {};
    if (table.across.empty()) return {std::move(seen)};
    const std::size_t across =
        PlaceOf(table.across, keys, "table " + table.key + ": across = " + table.across);
    std::vector<Table> tables;
    for (const std::size_t v : values) tables.push_back(SideBySide(seen, across, v));
    tables.back().caption = table.caption;
    return tables;
}

}  // namespace plumb::doc
