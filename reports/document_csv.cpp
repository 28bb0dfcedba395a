// Documents and their tables as comma-separated values [RFC 4180].
#include "reports/render.h"
#include "reports/text.h"

namespace plumb::doc {
namespace {

bool Uncertain(const Table& table, std::size_t c) {
    for (const auto& row : table.rows) {
        if (std::holds_alternative<Measured>(row[c])) return true;
    }
    return false;
}

// value, standard error, low, high
struct Fields {
    std::string value = {}, standard_error = {}, low = {}, high = {};
};

Fields FieldsOf(const Cell& cell) {
    struct Visitor {
        Fields operator()(std::monostate) const { return {}; }
        Fields operator()(const std::string& text) const { return {.value = Csv(text)}; }
        Fields operator()(std::int64_t n) const { return {.value = std::to_string(n)}; }
        Fields operator()(double x) const { return {.value = Exact(x)}; }
        Fields operator()(const Measured& m) const {
            return {Exact(m.value), Exact(m.standard_error), Exact(m.interval.low),
                    Exact(m.interval.high)};
        }
    };
    return std::visit(Visitor{}, cell);
}

std::string Line(const std::string& table, const std::string& row, const Column& column,
                 const Cell& cell) {
    const Fields f = FieldsOf(cell);
    return Csv(table) + "," + Csv(row) + "," + Csv(column.key) + "," + Csv(column.unit) + "," +
           f.value + "," + f.standard_error + "," + f.low + "," + f.high + "\n";
}

std::string NameOf(const Table& table, const std::vector<Cell>& row) {
    std::string name;
    for (std::size_t c = 0; c < row.size(); ++c) {
        if (table.columns[c].role != Role::kName) continue;
        if (!name.empty()) name += "; ";
        const auto* text = std::get_if<std::string>(&row[c]);
        name += text != nullptr ? *text : FieldsOf(row[c]).value;
    }
    return name;
}

void AddLines(const std::vector<Section>& sections, std::string& csv) {
    for (const Section& section : sections) {
        for (const Fact& fact : section.facts) {
            csv += Line(section.id, "", fact.what, fact.value);
        }
        for (const Table& table : section.tables) {
            if (table.data) continue;
            for (const auto& row : table.rows) {
                const std::string name = NameOf(table, row);
                for (std::size_t c = 0; c < row.size(); ++c) {
                    if (table.columns[c].role == Role::kName) continue;
                    csv += Line(table.key, name, table.columns[c], row[c]);
                }
            }
        }
        AddLines(section.sections, csv);
    }
}

}  // namespace

std::string ToCsv(const Table& table) {
    std::string csv;
    const auto line = [&](const auto& field_of) {
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
            csv += (c == 0 ? "" : ",") + field_of(c);
        }
        csv += "\n";
    };
    line([&](std::size_t c) {
        const std::string& key = table.columns[c].key;
        if (!Uncertain(table, c)) return Csv(key);
        return Csv(key) + "," + Csv(key + "_se") + "," + Csv(key + "_low") + "," +
               Csv(key + "_high");
    });
    for (const auto& row : table.rows) {
        line([&](std::size_t c) {
            const Fields f = FieldsOf(row[c]);
            if (!Uncertain(table, c)) return f.value;
            return f.value + "," + f.standard_error + "," + f.low + "," + f.high;
        });
    }
    return csv;
}

std::string ToCsv(const Document& document) {
    std::string csv = "table,row,column,unit,value,standard_error,low,high\n";
    AddLines(document.sections, csv);
    return csv;
}

}  // namespace plumb::doc
