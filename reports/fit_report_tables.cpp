// The fit report as tables: CSV for a spreadsheet, columns of text for a terminal.
#include <algorithm>
#include <cmath>

#include "reports/fit_caveats.h"
#include "reports/fit_report.h"
#include "reports/fit_report_parts.h"
#include "reports/text.h"

namespace plumb {
namespace {

using parts::PooledFacetRms;

std::string YesNo(bool yes) {
    return yes ? "yes" : "no";
}

void WriteScoreLine(std::ostream& out, const FormulaRecord& record, const std::string& map,
                    const Score& score, const Score* held_out, double facet_rms) {
    out << Csv(record.name) << ',' << Csv(map) << ',' << YesNo(record.fitted) << ','
        << parts::Inputs(record.formula.model, " + ") << ',' << score.samples << ','
        << Exact(score.rms) << ',' << Exact(score.max_abs) << ',' << score.poles << ','
        << score.out_of_range << ',' << (held_out ? Exact(held_out->rms) : "") << ','
        << (held_out ? Exact(held_out->max_abs) : "") << ',' << Exact(facet_rms) << '\n';
}

struct FitLine {
    std::string name;
    const LeastSquaresFit& fit;
    const BootstrapResult* bootstrap;
    const Formula* published;
    double published_rms;
};

/// Every fit of the report: curves, bounce family, totals.
std::vector<FitLine> AllFits(const FitReport& report) {
    std::vector<FitLine> lines;
    for (const std::vector<CurveFit>* list : {&report.curves, &report.bounce_family})
        for (const CurveFit& curve : *list)
            lines.push_back({curve.title, curve.fit, nullptr,
                             curve.published ? &*curve.published : nullptr,
                             curve.published_score ? curve.published_score->rms
                                                   : SurfaceFigures::kUnknown});
    for (const TotalFit& total : report.totals)
        lines.push_back({total.formula, total.fit,
                         total.bootstrap ? &*total.bootstrap : nullptr, nullptr,
                         SurfaceFigures::kUnknown});
    return lines;
}

double PublishedValue(const Formula* published, const std::string& name) {
    if (published)
        for (std::size_t j = 0; j < published->values.size(); ++j)
            if (published->model.parameters[j].name == name) return published->values[j];
    return SurfaceFigures::kUnknown;
}

const BootstrapInterval* IntervalOf(const BootstrapResult* bootstrap, const std::string& name) {
    if (bootstrap)
        for (const BootstrapInterval& interval : bootstrap->parameters)
            if (interval.name == name) return &interval;
    return nullptr;
}

void WriteChoice(std::ostream& out, const FitReport& report) {
    const FormChoice& choice = *report.choice;
    out << "\nForms, chosen on " << choice.choosing.size()
        << " maps (every other one, each held "
        << "out), reported on the other " << choice.reporting.size() << " [-]\n\n"
        << Left("form", 46) << Right("constants", 10) << Right("choosing", 10)
        << Right("reporting", 10) << '\n';
    for (const FormScore& score : choice.forms)
        out << Left(score.form + (&score == &choice.Winner() ? " <" : ""), 46)
            << Right(std::to_string(score.constants), 10)
            << Right(Digits(score.choosing_rms), 10) << Right(Digits(score.reporting_rms), 10)
            << '\n';
    out << "< wins on the choosing half; rank " << choice.RankOnReporting(choice.Winner())
        << " of " << choice.forms.size() << " on the other\n";
}

}  // namespace

void WriteChoiceCsv(std::ostream& out, const FitReport& report) {
    Validate(report);
    const FormScore& winner = report.choice->Winner();
    out << "form,constants,choosing_rms,reporting_rms,winner\n";
    for (const FormScore& score : report.choice->forms)
        out << Csv(score.form) << ',' << score.constants << ',' << Exact(score.choosing_rms)
            << ',' << Exact(score.reporting_rms) << ',' << YesNo(&score == &winner) << '\n';
}

void WriteScoresCsv(std::ostream& out, const FitReport& report) {
    Validate(report);
    out << "formula,map,fitted,inputs,samples,rms,max_abs,poles,out_of_range,held_out_rms,"
           "held_out_max_abs,facet_rms\n";
    for (const FormulaRecord& record : report.formulas) {
        for (std::size_t m = 0; m < report.maps.size(); ++m)
            WriteScoreLine(
                out, record, report.maps[m].name, record.in_sample.maps[m],
                record.held_out ? &record.held_out->maps[m] : nullptr,
                record.facet_rms.empty() ? SurfaceFigures::kUnknown : record.facet_rms[m]);
        WriteScoreLine(out, record, "all", record.in_sample.pooled,
                       record.held_out ? &record.held_out->pooled : nullptr,
                       PooledFacetRms(record));
    }
}

void WriteConstantsCsv(std::ostream& out, const FitReport& report) {
    Validate(report);
    out << "fit,samples,constant,value,standard_error,bootstrap_standard_error,bootstrap_low,"
           "bootstrap_high,published,rms,published_rms,condition,converged,at_bound\n";
    for (const FitLine& line : AllFits(report)) {
        for (const FittedParameter& parameter : line.fit.parameters) {
            const BootstrapInterval* interval = IntervalOf(line.bootstrap, parameter.name);
            out << Csv(line.name) << ',' << line.fit.samples << ',' << Csv(parameter.name)
                << ',' << Exact(parameter.value) << ','
                << (parameter.standard_error ? Exact(*parameter.standard_error) : "") << ','
                << (interval ? Exact(interval->standard_error) : "") << ','
                << (interval ? Exact(interval->low) : "") << ','
                << (interval ? Exact(interval->high) : "") << ','
                << Exact(PublishedValue(line.published, parameter.name)) << ','
                << Exact(line.fit.rmse) << ',' << Exact(line.published_rms) << ','
                << Exact(line.fit.condition) << ',' << YesNo(line.fit.converged) << ','
                << YesNo(parameter.at_bound) << '\n';
        }
    }
}

void WriteTable(std::ostream& out, const FitReport& report) {
    Validate(report);
    const std::size_t sources = report.provenance.maps.size();
    out << "Constants, fitted to " << sources << (sources == 1 ? " map" : " maps") << "\n";
    // Curves measured elsewhere: their unit was taken from the table or the command line.
    if (report.maps.empty() && sources == 1)
        out << report.provenance.maps[0].preparation << '\n';
    out << '\n'
        << Left("fit", 36) << Left("constant", 10) << Right("value", 22)
        << Right("interval (maps)", 20) << Right("published", 12) << '\n';
    for (const FitLine& line : AllFits(report)) {
        const bool of_family =
            std::any_of(report.bounce_family.begin(), report.bounce_family.end(),
                        [&](const CurveFit& curve) { return &curve.fit == &line.fit; });
        if (of_family) continue;  // 60 constants that nobody reads in a terminal.
        std::string name = line.name;
        if (name.size() > 35) {
            out << name << '\n';
            name.clear();
        }
        for (const FittedParameter& parameter : line.fit.parameters) {
            const BootstrapInterval* interval = IntervalOf(line.bootstrap, parameter.name);
            const double published = PublishedValue(line.published, parameter.name);
            out << Left(name, 36) << Left(parameter.name, 10)
                << Right(WithError(parameter.value, parameter.standard_error.value_or(0)) +
                             (parameter.at_bound ? " (at bound)" : ""),
                         22)
                << Right(interval
                             ? Digits(interval->low, 4) + " ... " + Digits(interval->high, 4)
                             : "",
                         20)
                << Right(std::isfinite(published) ? Exact(Rounded(published, 5)) : "", 12)
                << '\n';
            name.clear();
        }
        out << Left("", 36) << "RMS " << Digits(line.fit.rmse, 4);
        if (std::isfinite(line.published_rms))
            out << ", with the published constants " << Digits(line.published_rms, 4);
        out << '\n';
        if (!line.fit.converged) out << "  did not converge: " << line.fit.termination << '\n';
    }

    if (report.formulas.empty()) return;
    out << "\nError of E(rho), mean over the maps [-]\n\n"
        << Left("formula", 46) << Left("from", 10) << Right("RMS", 9) << Right("max", 9)
        << Right("held out", 10) << Right("facets", 9) << Right("poles", 7) << '\n';
    for (const FormulaRecord& record : report.formulas) {
        const Score& score = record.in_sample.pooled;
        out << Left(record.name + (record.name == report.recommended ? " *" : ""), 46)
            << Left(parts::Inputs(record.formula.model, ", "), 10)
            << Right(Digits(score.rms), 9) << Right(Digits(score.max_abs), 9)
            << Right(record.held_out ? Digits(record.held_out->pooled.rms) : "–", 10)
            << Right(Digits(PooledFacetRms(record)), 9) << Right(std::to_string(score.poles), 7)
            << '\n';
    }
    out << "* recommended\n";
    for (const std::string& caveat : CaveatsOf(report, parts::Find(report, report.recommended)))
        out << Wrapped("  Beware: " + caveat, 100, "  ") << '\n';
    if (report.choice) WriteChoice(out, report);
}

}  // namespace plumb
