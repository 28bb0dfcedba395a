// The sections of a fit report's page, each as HTML; those with plots add them to the sheet.
#pragma once

#include <string>

#include "reports/fit_report.h"
#include "reports/plot.h"

namespace plumb::page {

std::string Findings(const FitReport& report);
std::string Recommended(const FitReport& report);
std::string Scores(const FitReport& report);
std::string FormsCompared(const FitReport& report);   ///< report.choice must be there.
std::string ChoiceSentence(const FitReport& report);  ///< The same in words.
std::string Totals(const FitReport& report, PlotSheet& sheet);
std::string Curves(const FitReport& report, PlotSheet& sheet);
std::string BounceFamily(const FitReport& report, PlotSheet& sheet);
std::string Faults(const FitReport& report, PlotSheet& sheet);
std::string ErrorAgainstTime(const Convergence& convergence, PlotSheet& sheet);

}  // namespace plumb::page
