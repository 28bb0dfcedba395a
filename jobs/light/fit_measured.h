// Curves measured elsewhere, fitted as the paper fits its own: every bin with the same weight.
//
// Two kinds of table are understood:
//
//       bin, E0, E1, ...                      irradiance, open ground = pi; the abscissa of
//                                             bin k of n is (k + 1)/n unless told otherwise
//       ..., count, alpha, ..., E0, E1, ...   plumb's own histogram CSV: true mean alpha, open
//                                             ground = 1; empty bins are left out
//
// Source   [Mayaux18]: its tables are of the first kind, and its constants match the right
//          edge.
#pragma once

#include <filesystem>
#include <string>

#include "reports/fit_report.h"

namespace plumb {

/// Which point of a bin stands for it where its true mean is not known.
enum class BinAbscissa { kLeft, kCentre, kRight };

struct MeasuredOptions {
    BinAbscissa abscissa = BinAbscissa::kRight;
    int starts = 16;  ///< Of every fit. [1, ...)
};

/// A report of curves alone: F0, F1 (two constants, four constants) beside the published ones,
/// and the family of all bounces in the table. Throws Error, naming the file, if it has no row,
/// lacks a column, or is flat.
FitReport FitMeasuredCurves(const std::filesystem::path& table, const MeasuredOptions& options,
                            const std::string& tool_version, const std::string& command);

}  // namespace plumb
