// The shader headers that follow from a fit report.
#include <utility>

#include "fit/models/escape_bent_of_v.h"
#include "fit/models/escape_probability.h"
#include "fit/models/gtao_cubic.h"
#include "jobs/light/fit_constants.h"
#include "reports/fit_caveats.h"

namespace plumb {
namespace {

ShaderFormula ShaderFormulaOf(const FitReport& report, const FormulaRecord& record,
                              std::string function, std::string comment) {
    ShaderFormula shader;
    shader.formula = record.formula;
    shader.function = std::move(function);
    shader.comment = std::move(comment);
    shader.rms = record.in_sample.pooled.rms;
    if (record.held_out) shader.held_out_rms = record.held_out->pooled.rms;
    shader.caveats = CaveatsOf(report, record);
    return shader;
}

std::string RefittedName(std::string_view model) {
    return std::string(model) + ", refitted";
}

}  // namespace

ShaderHeader ShaderHeaderOf(const FitReport& report) {
    ShaderHeader header;
    header.provenance = report.provenance;
    header.recommended = ShaderFormulaOf(report, RecordNamed(report, report.recommended),
                                         "PlumbTotal", "From both visibilities.");
    header.alternatives = {
        ShaderFormulaOf(report, RecordNamed(report, RefittedName(EscapeBentOfV::kName)),
                        "PlumbTotalOfV", "From cosine visibility alone, bent."),
        ShaderFormulaOf(report, RecordNamed(report, RefittedName(EscapeOfV::kName)),
                        "PlumbEscapeOfV", "From cosine visibility alone, a power law."),
        ShaderFormulaOf(report, RecordNamed(report, RefittedName(EscapeOfAlphaClamped::kName)),
                        "PlumbEscapeOfAlpha", "From uniform visibility alone."),
        ShaderFormulaOf(report, RecordNamed(report, RefittedName(GtaoCubicModel::kName)),
                        "PlumbGtaoCubicRefitted",
                        "The cubic of [Jimenez16] from cosine visibility, its constants "
                        "refitted to all bounces: for comparison."),
    };
    for (const FormulaRecord& record : report.formulas) {
        if (record.fitted && record.name.starts_with("Mayaux18")) {
            header.alternatives.push_back(ShaderFormulaOf(
                report, record, "PlumbMayaux18Refitted",
                "The paper's formula with refitted constants, guarded: for comparison."));
        }
    }
    header.published_rms = RecordNamed(report, report.published).in_sample.pooled.rms;
    return header;
}

}  // namespace plumb
