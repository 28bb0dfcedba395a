#include "reports/fit_report.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>

#include "core/error.h"
#include "reports/fit_sections.h"
#include "reports/surface_sections.h"
#include "reports/text.h"

namespace plumb {
namespace {

void MustHave(const std::string& field, std::size_t size, std::size_t maps) {
    if (size != maps)
        throw Error("FitReport::" + field + " has " + std::to_string(size) +
                    " entries, must have one for each of " + std::to_string(maps) + " maps");
}

/// Figures, pictures and histograms of all maps.
doc::Section Surfaces(const FitReport& report) {
    doc::Section section{.id = "maps", .title = "The surfaces"};
    std::vector<std::pair<std::string, const BounceHistogram*>> over_alpha, over_V;
    for (const SurfaceReport& map : report.maps) {
        over_alpha.push_back({map.name, &map.over_alpha});
        over_V.push_back({map.name, &map.over_V});
        for (doc::Picture& picture : PicturesOf(map))
            section.pictures.push_back(std::move(picture));
    }
    section.tables = {FiguresTable(report.maps),
                      HistogramTable("over_alpha", "Bins over α", "map", over_alpha),
                      HistogramTable("over_v", "Bins over V", "map", over_V)};
    return section;
}

}  // namespace

void Validate(const FitReport& report) {
    for (const CurveFit& curve : report.curves) {
        if (curve.published && curve.published->values.size() != curve.fitted.values.size())
            throw Error("FitReport::curves[" + curve.title +
                        "].published must have a constant for each of fitted");
    }
    // Curves measured elsewhere: no surface of ours, no total.
    if (report.maps.empty() && report.formulas.empty()) return;
    const std::size_t maps = report.maps.size();
    MustHave("provenance.maps", report.provenance.maps.size(), maps);
    if (!report.floors.empty()) MustHave("floors", report.floors.size(), maps);
    std::set<std::string> names;
    for (const FormulaRecord& record : report.formulas) {
        const std::string field = "formulas[" + record.name + "]";
        if (!names.insert(record.name).second)
            throw Error("FitReport::" + field + " stands there twice, must be one record");
        MustHave(field + ".in_sample", record.in_sample.maps.size(), maps);
        if (record.held_out) MustHave(field + ".held_out", record.held_out->maps.size(), maps);
        if (!record.facet_rms.empty())
            MustHave(field + ".facet_rms", record.facet_rms.size(), maps);
    }
    const auto must_be_record = [&](const std::string& field, const std::string& name) {
        if (!names.contains(name))
            throw Error("FitReport::" + field + " = " + name + ", must name one of formulas");
    };
    must_be_record("recommended", report.recommended);
    must_be_record("published", report.published);
    if (!report.printed.empty()) must_be_record("printed", report.printed);
    for (const TotalFit& total : report.totals) must_be_record("totals.formula", total.formula);
}

const FormulaRecord& RecordNamed(const FitReport& report, const std::string& name) {
    const auto found =
        std::find_if(report.formulas.begin(), report.formulas.end(),
                     [&](const FormulaRecord& record) { return record.name == name; });
    assert(found != report.formulas.end());
    return *found;
}

doc::Table ConstantsTable(const FitReport& report) {
    std::vector<CurveFit> curves = report.curves;
    curves.insert(curves.end(), report.bounce_family.begin(), report.bounce_family.end());
    return fit_sections::ConstantsTable("constants", curves, report.totals);
}

doc::Document DocumentOf(const FitReport& report) {
    using namespace fit_sections;
    Validate(report);
    std::vector<std::string> names;
    for (const MapSource& map : report.provenance.maps) names.push_back(map.name);
    const bool of_curves = report.formulas.empty();
    doc::Document document{
        .kind = "fit",
        .title = "Ambient light constants, refitted",
        .subtitle =
            of_curves
                ? "The paper's curves, fitted to the measurements of " + Listed(names) + "."
                : "How much light reaches a point of an uneven surface under a uniform "
                  "sky, with all bounces: simulated on " +
                      Listed(names) + ", fitted, and compared with the formulas in print.",
        .provenance = DocumentProvenance(report.provenance)};
    std::vector<doc::Section>& sections = document.sections;
    if (!of_curves) {
        sections = {Findings(report), Recommended(report), Scores(report)};
        if (report.choice) sections.push_back(FormsCompared(report));
        sections.push_back(Totals(report));
    }
    sections.push_back(Curves(report));
    if (!report.bounce_family.empty()) sections.push_back(BounceFamily(report));
    if (!report.faults.empty()) sections.push_back(Faults(report));
    if (!report.maps.empty()) sections.push_back(Surfaces(report));
    if (report.amplitudes) sections.push_back(AmplitudeSection(*report.amplitudes));
    if (report.convergence) sections.push_back(ConvergenceSection(*report.convergence));
    sections.push_back(Fits(report));
    sections.push_back(OriginSection(report.provenance, report.timings));
    return document;
}

namespace fit_sections {

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

}  // namespace fit_sections

}  // namespace plumb
