#include "tests/architecture/citations.h"

#include <regex>
#include <sstream>

namespace plumb {
namespace {

// A family name and two digits of the year, sometimes a letter.
const std::string kKey = "[A-Z][A-Za-z]{2,}[0-9]{2}[a-z]?";

/// Comments as running text: a line break and the next line's "//" become one space.
std::string Unwrap(const std::string& text) {
    static const std::regex line_break("[ \t]*\n[ \t]*(///?<?)?[ \t]*");
    return std::regex_replace(text, line_break, " ");
}

/// The first group of every match.
std::vector<std::string> Matches(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    std::vector<std::string> found;
    for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it) {
        found.push_back((*it)[1]);
    }
    return found;
}

std::set<std::string> MatchSet(const std::string& text, const std::string& pattern) {
    const std::vector<std::string> found = Matches(text, pattern);
    return {found.begin(), found.end()};
}

std::string Trim(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(' ');
    if (begin == std::string::npos) return {};
    return text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

}  // namespace

std::set<std::string> EquationsIn(const std::string& text) {
    return MatchSet(Unwrap(text), "\\[(" + kKey + " eq\\. [0-9]+)\\]");
}

std::vector<std::string> MisshapenEquationsIn(const std::string& text) {
    std::vector<std::string> misshapen;
    const std::regex exact("\\[" + kKey + " eq\\. [0-9]+\\]");
    for (const std::string& tag :
         Matches(Unwrap(text), "(\\[" + kKey + "[^\\]]{0,40}\\b[Ee]qs?\\b[^\\]]{0,40}\\])")) {
        if (!std::regex_match(tag, exact)) misshapen.push_back(tag);
    }
    return misshapen;
}

std::set<std::string> PapersIn(const std::string& text) {
    return MatchSet(Unwrap(text), "\\[(" + kKey + ")(?: [^\\]\\[]{1,40})?\\]");
}

std::set<std::string> BibKeysIn(const std::string& bib) {
    return MatchSet(bib, "@[a-z]+\\{(" + kKey + "),");
}

std::vector<EquationRow> EquationRowsIn(const std::string& page) {
    std::vector<EquationRow> rows;
    std::istringstream lines(page);
    const std::regex key(kKey);
    for (std::string line; std::getline(lines, line);) {
        std::vector<std::string> cells;
        std::istringstream parts(line);
        for (std::string cell; std::getline(parts, cell, '|');) cells.push_back(Trim(cell));
        // A leading bar leaves an empty first cell.
        if (cells.size() < 6 || !std::regex_match(cells[1], key)) continue;
        rows.push_back({cells[1] + " eq. " + cells[2],
                        Matches(cells[4], "([a-z_]+/[a-z_0-9/]+\\.(?:h|cpp))"),
                        Matches(cells[5], "([A-Za-z0-9_]+\\.[A-Za-z0-9_]+)")});
    }
    return rows;
}

std::set<std::string> TestsIn(const std::string& text) {
    const std::regex test("\\b(?:TYPED_)?TEST(?:_F|_P)?\\(\\s*(\\w+),\\s*(\\w+)\\s*\\)");
    std::set<std::string> names;
    for (std::sregex_iterator it(text.begin(), text.end(), test), end; it != end; ++it) {
        names.insert((*it)[1].str() + "." + (*it)[2].str());
    }
    return names;
}

}  // namespace plumb
