#include "reports/document.h"

#include <functional>
#include <stdexcept>

#include "core/error.h"
#include "core/names.h"

namespace plumb::doc {
namespace {

// All sections, each before those within it.
template <class S, class F>
void ForEach(std::vector<S>& sections, const F& see) {
    for (S& section : sections) {
        see(section);
        ForEach(section.sections, see);
    }
}
template <class F>
void ForEach(const std::vector<Section>& sections, const F& see) {
    for (const Section& section : sections) {
        see(section);
        ForEach(section.sections, see);
    }
}

void RemoveTimes(Table& table) {
    for (std::size_t c = table.columns.size(); c-- > 0;) {
        if (table.columns[c].role != Role::kTime) continue;
        table.columns.erase(table.columns.begin() + std::ptrdiff_t(c));
        for (std::vector<Cell>& row : table.rows) row.erase(row.begin() + std::ptrdiff_t(c));
    }
}

}  // namespace

Provenance ProvenanceOf(const RunContext& run) {
    return {.version = run.version, .command = run.command, .seed = run.seed};
}

void Table::Add(std::vector<Cell> row) {
    if (row.size() != columns.size()) {
        throw std::logic_error("table " + key + ": " + std::to_string(row.size()) +
                               " cells, must be as many as its " +
                               std::to_string(columns.size()) + " columns");
    }
    rows.push_back(std::move(row));
}

const Cell& Table::At(std::size_t row, std::string_view column_key) const {
    std::vector<std::string> keys;
    for (const Column& column : columns) keys.push_back(column.key);
    const std::size_t c =
        PlaceOf(column_key, keys, "table " + key + ": column = " + std::string(column_key));
    if (row >= rows.size()) {
        throw Error(MustBe("table " + key + ": row", double(row),
                           "below " + std::to_string(rows.size())));
    }
    return rows[row][c];
}

Document WithoutTimes(Document document) {
    ForEach(document.sections, [](Section& section) {
        std::erase_if(section.facts,
                      [](const Fact& fact) { return fact.what.role == Role::kTime; });
        std::erase_if(section.plots, [](const Plots& plots) { return plots.of_times; });
        std::erase_if(section.tables, [](const Table& table) { return table.of_times; });
        for (Table& table : section.tables) RemoveTimes(table);
    });
    return document;
}

const Table& TableOf(const Document& document, std::string_view key) {
    std::vector<std::string> keys;
    std::vector<const Table*> tables;
    ForEach(document.sections, [&](const Section& section) {
        for (const Table& table : section.tables) {
            keys.push_back(table.key);
            tables.push_back(&table);
        }
    });
    return *tables[PlaceOf(key, keys, document.kind + ": table = " + std::string(key))];
}

const Cell& FactOf(const Document& document, std::string_view key) {
    std::vector<std::string> keys;
    std::vector<const Cell*> values;
    ForEach(document.sections, [&](const Section& section) {
        for (const Fact& fact : section.facts) {
            keys.push_back(fact.what.key);
            values.push_back(&fact.value);
        }
    });
    return *values[PlaceOf(key, keys, document.kind + ": fact = " + std::string(key))];
}

double NumberOf(const Cell& cell) {
    if (const auto* n = std::get_if<std::int64_t>(&cell)) return double(*n);
    if (const auto* x = std::get_if<double>(&cell)) return *x;
    if (const auto* m = std::get_if<Measured>(&cell)) return m->value;
    return std::numeric_limits<double>::quiet_NaN();
}

std::string Verbatim(std::string_view text) {
    std::string verbatim;
    for (const char c : text) {
        if (std::string_view("\\`*_^").find(c) != std::string_view::npos) verbatim += '\\';
        verbatim += c;
    }
    return verbatim;
}

}  // namespace plumb::doc
