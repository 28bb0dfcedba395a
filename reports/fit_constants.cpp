// The constants of a fit, how sure they are, and how each fit went.
#include <cmath>

#include "reports/columns.h"
#include "reports/fit_caveats.h"
#include "reports/fit_sections.h"
#include "reports/text.h"

namespace plumb::fit_sections {
namespace {

const BootstrapInterval* IntervalOf(const std::optional<BootstrapResult>& bootstrap,
                                    const std::string& name) {
    if (!bootstrap) return nullptr;
    for (const BootstrapInterval& interval : bootstrap->parameters)
        if (interval.name == name) return &interval;
    return nullptr;
}

}  // namespace

doc::Table ConstantsTable(std::string key, std::span<const CurveFit> curves,
                          std::span<const TotalFit> totals) {
    doc::Table table{
        .key = std::move(key),
        .columns = {
            doc::Name("fit", "Fit"), doc::Detail("samples", "Samples"),
            doc::Name("constant", "Constant"), doc::Value("value", "Value", 6),
            doc::Value("standard_error", "Standard error", 2,
                       "takes every sample to be independent: too small"),
            doc::Value("bootstrap_standard_error", "Standard error over maps", 2,
                       "whole maps drawn anew: the one to trust"),
            doc::Value("bootstrap_low", "Interval over maps, from", 4),
            doc::Value("bootstrap_high", "to", 4), doc::Value("published", "Published", 5),
            doc::Value("rms", "RMS"), doc::Value("published_rms", "RMS published"),
            doc::Value("condition", "Condition", 2,
                       "above about 100 constants trade against each other"),
            doc::Value("converged", "Converged"), doc::Value("at_bound", "At its bound")}};
    const auto add = [&](const std::string& name, const LeastSquaresFit& fit,
                         const std::optional<BootstrapResult>& bootstrap,
                         const std::optional<Formula>& published,
                         const std::optional<Score>& published_score) {
        for (std::size_t j = 0; j < fit.parameters.size(); ++j) {
            const FittedParameter& p = fit.parameters[j];
            const BootstrapInterval* over_maps = IntervalOf(bootstrap, p.name);
            const auto of = [&](double BootstrapInterval::*value) {
                return over_maps ? doc::Cell(over_maps->*value) : doc::Cell();
            };
            table.Add({name, fit.samples, p.name, p.value,
                       p.standard_error ? doc::Cell(*p.standard_error) : doc::Cell(),
                       of(&BootstrapInterval::standard_error), of(&BootstrapInterval::low),
                       of(&BootstrapInterval::high),
                       published ? doc::Cell(published->values[j]) : doc::Cell(), fit.rmse,
                       published_score ? doc::Cell(published_score->rms) : doc::Cell(),
                       fit.condition, YesNo(fit.converged), YesNo(p.at_bound)});
        }
    };
    for (const CurveFit& curve : curves)
        add(curve.title, curve.fit, {}, curve.published, curve.published_score);
    for (const TotalFit& total : totals) add(total.formula, total.fit, total.bootstrap, {}, {});
    return table;
}

doc::Section Recommended(const FitReport& report) {
    doc::Section section{.id = "recommended", .title = "The recommended formula"};
    section.sentences = {
        "`" + doc::Verbatim(report.recommended_text) + "`",
        "The first standard error takes every sample to be independent and is "
        "too small; the second comes from drawing whole maps anew and is the one "
        "to trust."};
    std::vector<TotalFit> ours, others;
    for (const TotalFit& total : report.totals)
        (total.formula == report.recommended ? ours : others).push_back(total);
    section.tables = {ConstantsTable("recommended_constants", {}, ours)};
    doc::Table caveats{.key = "caveats",
                       .title = "Beware",
                       .columns = {doc::Name("formula", "Formula"),
                                   doc::Value("caveat", "What must be said of it")}};
    for (const FormulaRecord& record : report.formulas)
        for (const std::string& caveat : CaveatsOf(report, record))
            caveats.Add({record.name, caveat});
    section.sections = {{.id = "other_totals",
                         .title =
                             "Constants of the other fitted totals, and what must be said of "
                             "each formula",
                         .folded = true,
                         .tables = {ConstantsTable("total_constants", {}, others)}}};
    if (!caveats.rows.empty()) section.sections[0].tables.push_back(std::move(caveats));
    return section;
}

doc::Section Fits(const FitReport& report) {
    doc::Table table{
        .key = "fits",
        .columns = {doc::Name("fit", "Fit"), doc::Value("bounce", "Bounce"),
                    doc::Value("samples", "Samples"), doc::Value("rms", "RMS"),
                    doc::Value("max_abs", "Worst"),
                    doc::Value("chi2_per_dof", "χ² a degree of freedom"),
                    doc::Value("condition_unscaled", "Condition, unscaled"),
                    doc::Value("iterations", "Iterations"), doc::Value("starts", "Starts"),
                    doc::Value("starts_agreeing", "that agree"),
                    doc::Value("replicates", "Bootstrap replicates"),
                    doc::Value("failed", "that failed"),
                    doc::Value("published_max_abs", "Worst, published"),
                    doc::Detail("published_samples", "Samples, published"),
                    doc::Detail("published_poles", "not finite"),
                    doc::Detail("published_out_of_range", "outside [0, 1]"),
                    doc::Value("termination", "Ended by")}};
    doc::Table correlations{
        .key = "correlations",
        .title = "Correlations of constants",
        .columns = {doc::Name("fit", "Fit"), doc::Name("constant", "Constant"),
                    doc::Name("other", "with"), doc::Value("correlation", "Correlation")}};
    const auto add = [&](const std::string& name, const LeastSquaresFit& fit, doc::Cell bounce,
                         const std::optional<Score>& published,
                         const std::optional<BootstrapResult>& bootstrap) {
        const auto of = [&](auto Score::*value) {
            return published ? doc::Cell((*published).*value) : doc::Cell();
        };
        table.Add({name, std::move(bounce), fit.samples, fit.rmse, fit.max_abs,
                   fit.chi2_per_dof, fit.condition_unscaled, fit.iterations, fit.starts,
                   fit.starts_agreeing,
                   bootstrap ? doc::Cell(bootstrap->replicates) : doc::Cell(),
                   bootstrap ? doc::Cell(bootstrap->failed) : doc::Cell(), of(&Score::max_abs),
                   of(&Score::samples), of(&Score::poles), of(&Score::out_of_range),
                   fit.termination});
        for (Eigen::Index i = 0; i < fit.correlation.rows(); ++i)
            for (Eigen::Index j = 0; j < i; ++j)
                correlations.Add({name, fit.parameters[std::size_t(j)].name,
                                  fit.parameters[std::size_t(i)].name, fit.correlation(i, j)});
    };
    for (const std::vector<CurveFit>* curves : {&report.curves, &report.bounce_family})
        for (const CurveFit& curve : *curves)
            add(curve.title, curve.fit, curve.bounce, curve.published_score, {});
    for (const TotalFit& total : report.totals)
        add(total.formula, total.fit, {}, {}, total.bootstrap);
    return {.id = "fits",
            .title = "How each fit went",
            .folded = true,
            .sentences = {"A condition number above about 100, or a correlation near ±1, says "
                          "that constants trade against each other: the curve is sure, its "
                          "constants are not."},
            .tables = {std::move(table), std::move(correlations)}};
}

}  // namespace plumb::fit_sections
