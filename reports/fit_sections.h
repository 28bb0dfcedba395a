// The sections of a fit's document, and what several of them ask of the report.
#pragma once

#include <span>
#include <string>

#include "reports/document.h"
#include "reports/fit_report.h"

namespace plumb::fit_sections {

doc::Section Findings(const FitReport& report);
doc::Section Recommended(const FitReport& report);
doc::Section Scores(const FitReport& report);
doc::Section FormsCompared(const FitReport& report);  ///< report.choice must be there.
doc::Section Totals(const FitReport& report);
doc::Section Curves(const FitReport& report);
doc::Section BounceFamily(const FitReport& report);
doc::Section Faults(const FitReport& report);
doc::Section Fits(const FitReport& report);

std::string ChoiceSentence(const FitReport& report);

/// A row a constant, as constants.csv has them, of curves and totals.
doc::Table ConstantsTable(std::string key, std::span<const CurveFit> curves,
                          std::span<const TotalFit> totals);

/// Root mean square over maps of FormulaRecord::facet_rms: every map the same say. NaN if there
/// are none.
double PooledFacetRms(const FormulaRecord& record);

/// The same of one of the floors.
double PooledFloor(const FitReport& report, double Floors::*floor);

/// "alpha", "V" or "alpha, V": what the formula is given besides the albedo.
std::string Inputs(const Model& model, const std::string& separator);

/// The error to judge a formula by: held out where there is one, else in sample (a formula that
/// was not fitted has never seen any map).
const Score& JudgedBy(const FormulaRecord& record);

inline std::string YesNo(bool yes) {
    return yes ? "yes" : "no";
}

}  // namespace plumb::fit_sections
