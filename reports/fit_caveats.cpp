#include "reports/fit_caveats.h"

#include <algorithm>

#include "fit/models/escape_of_alpha_and_v.h"
#include "reports/fit_sections.h"
#include "reports/text.h"

namespace plumb {
namespace {

/// The fits that gave the record its constants: its own, or those of the paper's two curves.
std::vector<const LeastSquaresFit*> FitsOf(const FitReport& report,
                                           const FormulaRecord& record) {
    std::vector<const LeastSquaresFit*> fits;
    for (const TotalFit& total : report.totals)
        if (total.formula == record.name) fits.push_back(&total.fit);
    if (fits.empty())
        for (const CurveFit& curve : report.curves)
            if (curve.title == "F0" || curve.title == "F1") fits.push_back(&curve.fit);
    return fits;
}

std::string AtBound(const FormulaRecord& record, const FittedParameter& parameter) {
    std::string text = parameter.name + " = " + Digits(parameter.value, 4) +
                       " stands at the bound of its range";
    for (const Parameter& known : record.formula.model.parameters)
        if (known.name == parameter.name)
            text += " [" + Exact(known.low) + ", " + Exact(known.high) + "]";
    return text + ": it has no error bar.";
}

/// The record with the least error, judged as `record` is.
const FormulaRecord* BetterOne(const FitReport& report, const FormulaRecord& record) {
    const FormulaRecord* best = nullptr;
    for (const FormulaRecord& other : report.formulas) {
        // Constants that saw a map are no rival for constants that did not.
        if (record.held_out && other.fitted && !other.held_out) continue;
        const double rms = fit_sections::JudgedBy(other).rms;
        if (!(rms < fit_sections::JudgedBy(record).rms)) continue;
        if (!best || rms < fit_sections::JudgedBy(*best).rms) best = &other;
    }
    return best;
}

}  // namespace

std::vector<std::string> CaveatsOf(const FitReport& report, const FormulaRecord& record) {
    std::vector<std::string> caveats;
    if (!record.fitted) return caveats;
    if (report.maps.size() == 1)
        caveats.push_back("Fitted to one map: its error on any other is not known.");
    if (const FormulaRecord* better = BetterOne(report, record))
        caveats.push_back("\"" + better->name + "\" has less error on " +
                          (record.held_out ? "maps held out, " : "the same maps, ") +
                          Digits(fit_sections::JudgedBy(*better).rms, 4) + " against " +
                          Digits(fit_sections::JudgedBy(record).rms, 4) + ".");
    for (const LeastSquaresFit* fit : FitsOf(report, record)) {
        for (const FittedParameter& parameter : fit->parameters)
            if (parameter.at_bound) caveats.push_back(AtBound(record, parameter));
        if (!fit->converged)
            caveats.push_back("The fit did not converge: do not use its constants.");
    }
    if (record.formula.model.name == EscapeOfAlphaAndV::kName) {
        if (record.formula.values[0] == 0)
            caveats.push_back("With b = 0 the escape probability does not read V.");
        if (record.formula.values[1] == 0)
            caveats.push_back("With c = 0 the escape probability does not read alpha.");
    }
    return caveats;
}

}  // namespace plumb
