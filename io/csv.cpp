#include "io/csv.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

#include "core/error.h"
#include "io/whole_file.h"

namespace plumb {
namespace {

std::string_view Trim(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

/// Cuts `text` at every `separator`; a last piece that is empty counts too.
std::vector<std::string_view> Split(std::string_view text, char separator) {
    std::vector<std::string_view> pieces;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        pieces.push_back(Trim(text.substr(begin, end - begin)));
        begin = end + 1;
    }
    return pieces;
}

std::string WithoutQuotes(std::string_view name) {
    if (name.size() >= 2 && name.front() == '"' && name.back() == '"') {
        name = name.substr(1, name.size() - 2);
    }
    return std::string(name);
}

std::vector<std::string> ParseNames(std::string_view line, const std::string& where) {
    std::vector<std::string> names;
    for (std::string_view cell : Split(line, ',')) {
        std::string name = WithoutQuotes(cell);
        const std::string column = where + ": column " + std::to_string(names.size() + 1);
        if (name.empty()) throw Error(column + " has no name");
        if (std::find(names.begin(), names.end(), name) != names.end()) {
            throw Error(column + " = " + name + ", must be a name of its own");
        }
        names.push_back(std::move(name));
    }
    return names;
}

double ParseNumber(std::string_view cell, const std::string& where) {
    double number = 0;
    const std::string_view digits = cell.substr(!cell.empty() && cell.front() == '+' ? 1 : 0);
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc() || end != digits.data() + digits.size() ||
        !std::isfinite(number)) {
        throw Error(where + " = " + std::string(cell) + ", must be a finite number");
    }
    return number;
}

void AppendNumber(std::string& text, double number) {
    std::array<char, 32> digits;
    text.append(digits.data(),
                std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
}

}  // namespace

std::vector<double> NumbersIn(const NumberTable& table, const std::string& name) {
    const auto found = std::find(table.names.begin(), table.names.end(), name);
    if (found == table.names.end()) {
        std::string known;
        for (const std::string& other : table.names) {
            known += (known.empty() ? "" : ", ") + other;
        }
        throw Error("column " + name + " is missing, there are " + known);
    }
    const auto column = std::size_t(found - table.names.begin());
    std::vector<double> values;
    for (const std::vector<double>& row : table.rows) values.push_back(row[column]);
    return values;
}

NumberTable ParseCsv(std::string_view text, const std::string& name) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    NumberTable table;
    int line_number = 0;
    for (std::string_view line : Split(text, '\n')) {
        const std::string where = name + ":" + std::to_string(++line_number);
        if (line.empty() || line.front() == '#') continue;
        if (table.names.empty()) {
            table.names = ParseNames(line, where);
            continue;
        }
        const std::vector<std::string_view> cells = Split(line, ',');
        if (cells.size() != table.names.size()) {
            throw Error(where + ": has " + std::to_string(cells.size()) + " cells, must be " +
                        std::to_string(table.names.size()) + " as in the header");
        }
        std::vector<double>& row = table.rows.emplace_back();
        for (std::size_t i = 0; i < cells.size(); ++i) {
            row.push_back(ParseNumber(cells[i], where + ": " + table.names[i]));
        }
    }
    if (table.names.empty()) throw Error(name + ": has no header line of column names");
    if (table.rows.empty()) throw Error(name + ": has a header but no row of numbers");
    return table;
}

NumberTable ReadCsv(const std::filesystem::path& path) {
    return ParseCsv(ReadWholeFile(path), path.string());
}

std::string ToCsv(const NumberTable& table, const std::vector<std::string>& comments) {
    std::string text;
    for (const std::string& comment : comments) text += "# " + comment + "\n";
    for (std::size_t i = 0; i < table.names.size(); ++i) {
        text += (i > 0 ? "," : "") + table.names[i];
    }
    text += "\n";
    for (const std::vector<double>& row : table.rows) {
        assert(row.size() == table.names.size());
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (i > 0) text += ",";
            AppendNumber(text, row[i]);
        }
        text += "\n";
    }
    return text;
}

void WriteCsv(const std::filesystem::path& path, const NumberTable& table,
              const std::vector<std::string>& comments) {
    WriteWholeFile(path, ToCsv(table, comments));
}

}  // namespace plumb
