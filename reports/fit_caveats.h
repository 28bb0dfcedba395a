// What must be said beside a fitted formula wherever it is praised: on the page, in the terminal,
// in the JSON, in the shader header.
#pragma once

#include <string>
#include <vector>

#include "reports/fit_report.h"

namespace plumb {

/// Sentences in ASCII, none if there is nothing to say: only one map; a formula of the same table
/// with less error; constants at the bound of their range; an input that a constant of 0 leaves
/// unread; a fit that did not converge. `record` is one of the report's. A formula that was not
/// fitted has none.
std::vector<std::string> CaveatsOf(const FitReport& report, const FormulaRecord& record);

}  // namespace plumb
