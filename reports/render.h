// Documents as files and text: one renderer each, of the same values.
//
// JSON and CSV hold every digit of every number, in the unit of its column; page and terminal
// round the same numbers to the column's digits (CellText). What is not finite, or nothing, is
// null, an empty field and a dash.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "reports/document.h"

namespace plumb::doc {

/// A cell for people, without its unit:
///     12,345    0.0123    27.58 ± 0.12    4.00 (1.00 to 16.0)    –
/// A number that has a standard error is rounded by it; one that has but an interval is followed
/// by that.
std::string CellText(const Column& column, const Cell& cell);

/// A whole page that loads nothing from elsewhere.
std::string ToHtml(const Document& document);

/// By docs/schema/document-1.json. Rows of numbers that plots share stand there once.
nlohmann::ordered_json ToJson(const Document& document);
std::string ToJsonText(const Document& document);

/// A table as it stands: a column a column, by their keys; behind a column that has uncertain
/// numbers three more: KEY_se, KEY_low, KEY_high, with only those that are known.
std::string ToCsv(const Table& table);

/// All numbers of all facts and of all tables but those of data, one a line: table, row, column, unit, value,
/// standard_error, low, high. A row is called by its names, joined by "; ".
std::string ToCsv(const Document& document);

/// For a terminal of 100 columns: a table that is wider is broken, its names said again. Sections
/// that would show nothing are left out.
std::string ToTerminal(const Document& document);

}  // namespace plumb::doc
