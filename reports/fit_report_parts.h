// What the tables and the page of a fit report both ask of it.
#pragma once

#include <string>

#include "reports/fit_report.h"

namespace plumb::parts {

/// The record of that name. Validate() made sure that there is one.
const FormulaRecord& Find(const FitReport& report, const std::string& name);

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

}  // namespace plumb::parts
