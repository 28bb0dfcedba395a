// A result as a value: what a study found, before anyone decides how it looks.
//
//       Document   kind, title, where it comes from, sections
//       Section    sentences, facts, tables, plots, pictures, and sections within it
//       Table      columns (key, title, unit, digits, ...) and rows of cells
//       Cell       nothing, a text, an integer, a number, or a number with its uncertainty
//
// HTML, JSON, CSV and terminal (reports/render.h) are renderers of these values and know of no
// algorithm; studies fill them and know of no format. Adding a study is one file.
//
// A sentence is plain text, in which `code` is set as code, *words* are stressed, _{low} and
// ^{high} stand below and above the line; a sentence that is nothing but `code` keeps its lines
// and stands by itself. Put names that come from outside through Verbatim().
//
// Beware   What differs from run to run (seconds, rates, bytes a second) stands in columns and
//          facts of Role::kTime and in plots marked so, never in a sentence, so that
//          WithoutTimes() repeats byte for byte and a baseline can leave the times out.
//          Numbers are stored in the unit of their column: no renderer scales any.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/measured.h"
#include "core/run_context.h"
#include "reports/plot.h"

namespace plumb::doc {

/// Nothing stands for what was not measured, or does not apply.
using Cell = std::variant<std::monostate, std::string, std::int64_t, double, Measured>;

/// What a column is for.
enum class Role {
    kName,   ///< Says which row this is; the names of a row together are its key.
    kValue,  ///< A result: the same in every run.
    kTime,   ///< A result that differs from run to run.
};

/// Which way is better. kNearZero: of a bias.
enum class Better { kNeither, kLess, kMore, kNearZero };

struct Column {
    std::string key;        ///< In JSON and CSV, with its unit: "sao_ms". [a-z0-9_]
    std::string title;      ///< For people, without its unit.
    std::string unit = {};  ///< "ms"; empty = none.
    int digits = 3;         ///< Significant ones, for people.
    Role role = Role::kValue;
    Better better = Better::kNeither;
    std::string meaning = {};  ///< One line: how it is defined.
    bool detail = false;       ///< For machines: page and terminal leave it out.
    bool interval = false;     ///< People see its interval, not its standard error.
};

struct Table {
    std::string key;  ///< Within its document. [a-z0-9_]
    std::string title = {};
    std::string caption = {};  ///< How to read it. A sentence.
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows = {};

    /// Its rows compete: a page marks the best of each column that has a better side and shades
    /// the others by how far they fall behind.
    bool judged = false;
    /// The key of a name column: page and terminal set its names side by side, in a table for
    /// each column of values.
    std::string across = {};
    /// Long, and for machines: JSON lists it column by column; page, terminal and the CSV of the
    /// document leave it out.
    bool data = false;
    bool of_times = false;  ///< Which rows there are differs from run to run.

    /// Keys of two columns that a page draws above it: by how much each row raises or lowers the
    /// first, with the second as a tick. Empty = no drawing.
    std::string steps = {}, ticks = {};

    /// Throws std::logic_error if there are not as many cells as columns.
    void Add(std::vector<Cell> row);

    /// The cell of that row in the column of that key. Throws Error if there is none.
    const Cell& At(std::size_t row, std::string_view key) const;
};

/// One value by itself.
struct Fact {
    Column what;
    Cell value;
};

/// Plots that follow the same selectors. Their captions are sentences.
struct Plots {
    std::vector<PlotSelector> selectors = {};
    std::vector<Plot> plots;
    bool of_times = false;  ///< Some of its numbers differ from run to run.
};

struct Picture {
    std::string data_uri;      ///< PNG.
    std::string alternative;   ///< What it shows, for those who do not see it.
    std::string caption = {};  ///< A sentence.
};

struct Section {
    std::string id;  ///< Within its document. [a-z0-9_]
    std::string title;
    bool folded = false;  ///< Shown on demand.
    bool listed = false;  ///< The sentences are points of a list.
    std::vector<std::string> sentences = {};
    std::vector<Fact> facts = {};
    std::vector<Table> tables = {};
    std::vector<Plots> plots = {};
    std::vector<Picture> pictures = {};
    std::vector<Section> sections = {};
};

/// An input by the hash of its bytes.
struct Input {
    std::string name, sha256;
};

/// Enough to make the document again.
struct Provenance {
    std::string version = {};  ///< Of this program.
    std::string command = {};
    std::uint64_t seed = 0;
    std::vector<Input> inputs = {};
};

/// Without inputs.
Provenance ProvenanceOf(const RunContext& run);

struct Document {
    std::string kind;  ///< Which job made it: "bench_ao".
    std::string title, subtitle = {};
    Provenance provenance = {};
    std::vector<Section> sections = {};
};

/// Without what differs from run to run: such facts and plots left out, such columns too.
Document WithoutTimes(Document document);

/// The tables that people see of it, its columns chosen and set side by side as it says, without
/// columns that hold nothing in any row. None if nothing but names is left.
std::vector<Table> Shown(const Table& table);

/// The table of that key, wherever it stands. Throws Error, naming those that there are.
const Table& TableOf(const Document& document, std::string_view key);

/// The value of the fact of that key, likewise.
const Cell& FactOf(const Document& document, std::string_view key);

/// The number of an integer, a number or a number with its uncertainty; NaN otherwise.
double NumberOf(const Cell& cell);

/// The text with nothing in it that would be set in any special way.
std::string Verbatim(std::string_view text);

}  // namespace plumb::doc
