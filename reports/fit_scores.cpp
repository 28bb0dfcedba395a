// The scores of a fit: formulas x criteria, formulas x maps, and the choice among the forms.
#include <cmath>

#include "reports/columns.h"
#include "reports/fit_sections.h"
#include "reports/text.h"

namespace plumb::fit_sections {
namespace {

/// The score on maps not fitted to. A formula that was not fitted has never seen any; of a
/// fitted one without held-out scores it is not known.
const Score* HeldOut(const FormulaRecord& record) {
    if (record.held_out) return &record.held_out->pooled;
    return record.fitted ? nullptr : &record.in_sample.pooled;
}

std::string UseOf(const FitReport& report, const std::string& name) {
    return name == report.recommended ? "recommended"
           : name == report.published ? "published"
           : name == report.printed   ? "as printed"
                                      : "";
}

doc::Table Summary(const FitReport& report) {
    doc::Table table{
        .key = "formulas",
        .columns = {doc::Name("formula", "Formula"), doc::Value("use", ""),
                    doc::Value("reads", "Reads"),
                    doc::Value("constants_fitted", "Constants fitted"),
                    doc::ErrorOf("rms", "RMS"),
                    doc::ErrorOf("held_out_rms", "RMS held out", 3,
                                 "each map scored by constants fitted to the others"),
                    doc::ErrorOf("facet_rms", "RMS a facet", 3,
                                 "of single facets, with the scatter that no bin mean shows"),
                    doc::ErrorOf("max_abs", "Worst bin"),
                    doc::ErrorOf("held_out_max_abs", "Worst bin held out"),
                    doc::Value("poles", "Samples not finite"),
                    doc::Value("out_of_range", "Samples outside [0, 1]")},
        .judged = true};
    for (const FormulaRecord& record : report.formulas) {
        const Score &score = record.in_sample.pooled, *held_out = HeldOut(record);
        const std::string inputs = Inputs(record.formula.model, ", ");
        table.Add({record.name, UseOf(report, record.name),
                   inputs == "alpha" ? "α"
                   : inputs == "V"   ? "V"
                                     : "α, V",
                   record.fitted ? doc::Cell(std::int64_t(record.formula.values.size()))
                                 : doc::Cell(),
                   score.rms, held_out ? doc::Cell(held_out->rms) : doc::Cell(),
                   PooledFacetRms(record), score.max_abs,
                   held_out ? doc::Cell(held_out->max_abs) : doc::Cell(), score.poles,
                   score.out_of_range});
    }
    return table;
}

doc::Table ByMap(const FitReport& report) {
    doc::Table table{
        .key = "scores",
        .columns = {doc::Name("formula", "Formula"), doc::Name("map", "Map"),
                    doc::Detail("fitted", "Fitted"), doc::Detail("inputs", "Reads"),
                    doc::Detail("samples", "Samples"), doc::ErrorOf("rms", "RMS on each map"),
                    doc::ErrorOf("max_abs", "Worst bin on each map"),
                    doc::Detail("poles", "Samples not finite"),
                    doc::Detail("out_of_range", "Samples outside [0, 1]"),
                    doc::ErrorOf("held_out_rms", "RMS on each map, held out"),
                    doc::Detail("held_out_max_abs", "Worst bin, held out"),
                    doc::ErrorOf("facet_rms", "RMS a facet on each map"),
                    doc::Detail("held_out_samples", "Samples, held out"),
                    doc::Detail("held_out_poles", "Samples not finite, held out"),
                    doc::Detail("held_out_out_of_range", "Samples outside [0, 1], held out")},
        .judged = true,
        .across = "map"};
    for (const FormulaRecord& record : report.formulas) {
        const auto add = [&](const std::string& map, const Score& s, const Score* held_out,
                             double facet_rms) {
            const auto of = [&](auto Score::*value) {
                return held_out ? doc::Cell(held_out->*value) : doc::Cell();
            };
            table.Add({record.name, map, YesNo(record.fitted),
                       Inputs(record.formula.model, " + "), s.samples, s.rms, s.max_abs,
                       s.poles, s.out_of_range, of(&Score::rms), of(&Score::max_abs), facet_rms,
                       of(&Score::samples), of(&Score::poles), of(&Score::out_of_range)});
        };
        for (std::size_t m = 0; m < report.maps.size(); ++m) {
            add(report.maps[m].name, record.in_sample.maps[m],
                record.held_out ? &record.held_out->maps[m] : nullptr,
                record.facet_rms.empty() ? SurfaceFigures::kUnknown : record.facet_rms[m]);
        }
        add("all", record.in_sample.pooled,
            record.held_out ? &record.held_out->pooled : nullptr, PooledFacetRms(record));
    }
    return table;
}

doc::Table FloorsTable(const FitReport& report) {
    doc::Table table{.key = "floors",
                     .title = "RMS a facet that nothing can go below",
                     .columns = {doc::Name("map", "Map"),
                                 doc::Value("of_uniform_visibility", "Any function of α"),
                                 doc::Value("of_cosine_visibility", "Any function of V"),
                                 doc::Value("of_both", "Any function of both")}};
    for (std::size_t m = 0; m < report.floors.size(); ++m) {
        const Floors& floors = report.floors[m];
        table.Add({report.maps[m].name, floors.of_alpha, floors.of_V, floors.of_both});
    }
    return table;
}

/// Of every formula, those that were not fitted too.
doc::Table FormulaConstants(const FitReport& report) {
    doc::Table table{
        .key = "formula_constants",
        .title = "The constants of every formula",
        .columns = {doc::Name("formula", "Formula"), doc::Value("model", "Form"),
                    doc::Name("constant", "Constant"), doc::Value("value", "Value")},
        .data = true};
    for (const FormulaRecord& record : report.formulas) {
        const Formula& formula = record.formula;
        for (std::size_t j = 0; j < formula.values.size(); ++j) {
            table.Add({record.name, std::string(formula.model.name),
                       std::string(formula.model.parameters[j].name), formula.values[j]});
        }
    }
    return table;
}

}  // namespace

doc::Section Scores(const FitReport& report) {
    doc::Section by_map{.id = "scores_by_map",
                        .title = "Map by map",
                        .folded = true,
                        .tables = {ByMap(report), FormulaConstants(report)}};
    if (!report.floors.empty()) by_map.tables.push_back(FloorsTable(report));
    return {
        .id = "scores",
        .title = "Every formula on every map",
        .sentences = {"Root mean square and worst error of E(ρ) over bins and albedos, every "
                      "map the same say. *Held out*: each map is scored by constants fitted "
                      "to the other maps only; a formula with no fitted constant has never "
                      "seen any, and its figure is the same. *A facet*: the error of single "
                      "facets, with the scatter that no bin mean shows. On the "
                      "page darker is worse, and the best of a column is bold."},
        .tables = {Summary(report)},
        .sections = {std::move(by_map)}};
}

std::string ChoiceSentence(const FitReport& report) {
    const FormChoice& choice = *report.choice;
    const FormScore& winner = choice.Winner();
    const std::string recommended(RecordNamed(report, report.recommended).formula.model.name);
    std::string text =
        "Of " + std::to_string(choice.forms.size()) + " forms, *" + doc::Verbatim(winner.form) +
        "* wins on the choosing half of the maps (" + doc::Verbatim(Listed(choice.choosing)) +
        "; RMS held out " + Digits(winner.choosing_rms) + "). On the other half (" +
        doc::Verbatim(Listed(choice.reporting)) +
        "), which neither the choice nor the constants have seen, its RMS is *" +
        Digits(winner.reporting_rms) + "*, rank " +
        std::to_string(choice.RankOnReporting(winner)) + ".";
    if (winner.form == recommended) return text + " It is the recommended form.";
    for (const FormScore& score : choice.forms) {
        if (score.form != recommended) continue;
        text += " The recommended form has " + Digits(score.choosing_rms) +
                " on the choosing half and " + Digits(score.reporting_rms) +
                " on the other, rank " + std::to_string(choice.RankOnReporting(score)) + ".";
    }
    return text;
}

doc::Section FormsCompared(const FitReport& report) {
    const FormChoice& choice = *report.choice;
    doc::Table table{
        .key = "forms",
        .columns = {doc::Name("form", "Form"), doc::Value("constants", "Constants"),
                    doc::ErrorOf("choosing_rms", "RMS, choosing half", 4,
                                 "each of its maps held out in its turn"),
                    doc::ErrorOf("reporting_rms", "RMS, reporting half", 4,
                                 "which neither form nor constants have seen"),
                    doc::Value("winner", "Wins on the choosing half")},
        .judged = true};
    for (const FormScore& score : choice.forms) {
        table.Add({score.form, score.constants, score.choosing_rms, score.reporting_rms,
                   YesNo(&score == &choice.Winner())});
    }
    return {
        .id = "choice",
        .title = "Chosen on one half, reported on the other",
        .sentences = {"A form that is chosen on the maps that it is scored on looks better "
                      "than it is. The first, third, fifth ... map given choose, each held "
                      "out in its turn; the second, fourth ... report, with constants fitted "
                      "to the choosing half.",
                      ChoiceSentence(report)},
        .tables = {std::move(table)}};
}

}  // namespace plumb::fit_sections
