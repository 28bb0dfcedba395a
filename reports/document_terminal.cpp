// Documents as lines of a terminal.
#include <algorithm>
#include <sstream>

#include "reports/render.h"
#include "reports/sentence.h"
#include "reports/text.h"

namespace plumb::doc {
namespace {

constexpr std::size_t kColumns = 100;

std::string Wrapped(const std::string& text, const std::string& indent) {
    std::istringstream words(text);
    std::string lines, line = indent, word;
    while (words >> word) {
        if (line.size() + 1 + word.size() > kColumns && line != indent) {
            lines += line + "\n";
            line = indent;
        }
        line += (line == indent ? "" : " ") + word;
    }
    return lines + line + "\n";
}

std::string Titled(const Column& column) {
    return column.unit.empty() ? column.title : column.title + " [" + column.unit + "]";
}

/// Its columns of values, so many at a time that a line holds them beside the names.
std::string TableText(const Table& table, const std::string& indent) {
    std::vector<std::vector<std::string>> lines(1);
    for (const Column& column : table.columns) lines[0].push_back(Titled(column));
    for (const auto& row : table.rows) {
        lines.emplace_back();
        for (std::size_t c = 0; c < row.size(); ++c) {
            lines.back().push_back(CellText(table.columns[c], row[c]));
        }
    }
    std::string text;
    if (!table.title.empty()) text += indent + table.title + "\n";
    std::vector<int> widths(table.columns.size());
    for (const auto& line : lines) {
        for (std::size_t c = 0; c < line.size(); ++c) {
            widths[c] = std::max(widths[c], Characters(line[c]));
        }
    }
    constexpr int kBetween = 3;
    const auto is_name = [&](std::size_t c) { return table.columns[c].role == Role::kName; };
    int names = int(indent.size()) - 1;
    for (std::size_t c = 0; c < widths.size(); ++c) {
        if (is_name(c)) names += kBetween + widths[c];
    }
    for (std::size_t begin = 0, end = 0; begin < widths.size(); begin = end) {
        int used = names;
        for (bool any = false; end < widths.size(); ++end) {
            if (is_name(end)) continue;
            used += kBetween + widths[end];
            if (any && used > int(kColumns)) break;
            any = true;
        }
        for (const auto& line : lines) {
            std::string row = indent + "  ";
            const char* between = "";
            for (std::size_t c = 0; c < line.size(); ++c) {
                if (!is_name(c) && (c < begin || c >= end)) continue;
                row += between +
                       (is_name(c) ? Left(line[c], widths[c]) : Right(line[c], widths[c]));
                between = "   ";
            }
            row.erase(row.find_last_not_of(' ') + 1);
            text += row + "\n";
        }
    }
    if (!table.caption.empty()) text += Wrapped(PlainText(table.caption), indent + "  ");
    return text;
}

std::string SectionText(const Section& section, const std::string& indent) {
    std::string text;
    for (const std::string& sentence : section.sentences) {
        const std::string plain = PlainText(sentence);
        if (IsCode(sentence)) {
            text += indent + "  " + plain + "\n";
        } else {
            text +=
                section.listed ? Wrapped("- " + plain, indent + "  ") : Wrapped(plain, indent);
        }
    }
    int width = 0;
    for (const Fact& fact : section.facts) {
        width = std::max(width, Characters(Titled(fact.what)));
    }
    for (const Fact& fact : section.facts) {
        text += indent + "  " + Left(Titled(fact.what), width) + "   " +
                CellText(fact.what, fact.value) + "\n";
    }
    for (const Table& table : section.tables) {
        for (const Table& shown : Shown(table)) text += TableText(shown, indent);
    }
    for (const Section& within : section.sections) {
        if (!within.folded) text += SectionText(within, indent + "  ");
    }
    // A section of plots says nothing here.
    return text.empty() ? text : "\n" + indent + section.title + "\n" + text;
}

}  // namespace

std::string ToTerminal(const Document& document) {
    std::string text = document.title + "\n";
    if (!document.subtitle.empty()) text += Wrapped(document.subtitle, "");
    for (const Section& section : document.sections) {
        if (!section.folded) text += SectionText(section, "");
    }
    return text;
}

}  // namespace plumb::doc
