// Curves measured elsewhere, fitted as the paper fits its own: every bin with the same weight.
//
// Three kinds of table are understood:
//
//       bin, E0, E1, ...            the paper's: irradiance, open ground = pi; the abscissa of
//                                   bin k of n is (k + 1)/n unless told otherwise
//       count, alpha, E0, E0_var    plumb's own histogram CSV (docs/light.md): true mean alpha,
//                                   open ground = 1; empty bins are left out
//       alpha, E0, E1, ...          anything else: the caller must say what open ground is
//
// Whatever is said is checked: no sky sends less than alpha^2 or more than alpha (2 - alpha) of
// the light of open ground, and a table of which a row is out of that by a tenth is refused. A
// unit that is wrong by pi never passes.
//
// Source   [Mayaux18]: its tables are of the first kind, and its constants match the right
//          edge.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/run_context.h"
#include "reports/fit_report.h"

namespace plumb {

/// Which point of a bin stands for it where its true mean is not known.
enum class BinAbscissa { kLeft, kCentre, kRight };

struct MeasuredOptions {
    /// E of open ground in the table's unit: pi, 1 ... (0, ...) None: as the kind of table says.
    std::optional<double> open_ground = {};
    BinAbscissa abscissa = BinAbscissa::kRight;
    int starts = 16;  ///< Of every fit. [1, ...)
};

/// A report of curves alone: F0, F1 (two constants, four constants) beside the published ones,
/// and the family of all bounces in the table. Throws Error, naming the file, if it has no row,
/// lacks a column, is flat, does not say its unit, or cannot be in that unit.
FitReport FitMeasuredCurves(const std::filesystem::path& table, const MeasuredOptions& options,
                            const RunContext& run);

}  // namespace plumb
