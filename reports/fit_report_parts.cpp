#include "reports/fit_report_parts.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace plumb::parts {

const FormulaRecord& Find(const FitReport& report, const std::string& name) {
    const auto found =
        std::find_if(report.formulas.begin(), report.formulas.end(),
                     [&](const FormulaRecord& record) { return record.name == name; });
    assert(found != report.formulas.end());
    return *found;
}

double PooledFacetRms(const FormulaRecord& record) {
    double sum = 0;
    for (const double rms : record.facet_rms) sum += rms * rms;
    return record.facet_rms.empty() ? SurfaceFigures::kUnknown
                                    : std::sqrt(sum / double(record.facet_rms.size()));
}

double PooledFloor(const FitReport& report, double Floors::*floor) {
    double sum = 0;
    for (const Floors& floors : report.floors) sum += floors.*floor * (floors.*floor);
    return report.floors.empty() ? SurfaceFigures::kUnknown
                                 : std::sqrt(sum / double(report.floors.size()));
}

std::string Inputs(const Model& model, const std::string& separator) {
    std::string list = model.inputs.alpha ? "alpha" : "";
    if (model.inputs.V) list += (list.empty() ? "" : separator) + "V";
    return list;
}

const Score& JudgedBy(const FormulaRecord& record) {
    return record.held_out ? record.held_out->pooled : record.in_sample.pooled;
}

}  // namespace plumb::parts
