// Tables of numbers as text: comma-separated, a header line of names, '#' for comments.
//
//       # what this is
//       bin,E0,E1
//       0,0.04218207,0.246685
//
// Numbers are written with the fewest digits that read back to the same double. Blank lines,
// spaces about a cell, CRLF and a byte order mark are read over.
//
// Beware   Only finite numbers are read: a cell that is empty, nan or inf is an error that
//          names file, line and column, as in "curves.csv:17: E3 = abc, must be a number".
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// Columns by name; every row has as many numbers as there are names.
struct NumberTable {
    std::vector<std::string> names;
    std::vector<std::vector<double>> rows;

    friend bool operator==(const NumberTable&, const NumberTable&) = default;
};

/// The column `name` from top to bottom. Throws Error naming it and those that exist.
std::vector<double> NumbersIn(const NumberTable& table, const std::string& name);

/// Curves measured elsewhere, too: the columns are the caller's to interpret. `name` is what
/// errors call the text. At least one column and one row.
NumberTable ParseCsv(std::string_view text, const std::string& name);
NumberTable ReadCsv(const std::filesystem::path& path);

/// Each line of `comments` is written after "# ".
std::string ToCsv(const NumberTable& table, const std::vector<std::string>& comments = {});
void WriteCsv(const std::filesystem::path& path, const NumberTable& table,
              const std::vector<std::string>& comments = {});

}  // namespace plumb
