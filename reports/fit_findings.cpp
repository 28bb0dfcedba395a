// What the figures say, in sentences computed from them.
#include <algorithm>
#include <cmath>

#include "reports/fit_caveats.h"
#include "reports/fit_sections.h"
#include "reports/text.h"

namespace plumb::fit_sections {
namespace {

std::string Greek(const std::string& inputs) {
    return inputs == "alpha" ? "α" : inputs == "V" ? "V" : "α and V";
}

/// The best formula that was never fitted to anything here, by its pooled RMS.
const FormulaRecord* BestUnfitted(const FitReport& report) {
    const FormulaRecord* best = nullptr;
    for (const FormulaRecord& record : report.formulas)
        if (!record.fitted && record.name != report.published &&
            record.name != report.recommended &&
            (!best || record.in_sample.pooled.rms < best->in_sample.pooled.rms))
            best = &record;
    return best;
}

std::string Compared(double ours, double theirs, const std::string& than) {
    if (!(ours > 0) || !(theirs > 0)) return "";
    return theirs >= ours ? Digits(theirs / ours, 2) + " times " + than
                          : "only " + Digits(theirs / ours, 2) + " of " + than;
}

std::string RecommendedSentence(const FitReport& report, const FormulaRecord& ours) {
    const Score& score = ours.in_sample.pooled;
    std::string text = "*" + doc::Verbatim(ours.name) +
                       "* is recommended: it predicts E(ρ) from " +
                       Greek(Inputs(ours.formula.model, ", ")) + " with an RMS error of *" +
                       Digits(score.rms) + "* over " + std::to_string(report.maps.size()) +
                       (report.maps.size() == 1 ? " map" : " maps") + " (worst bin " +
                       Digits(score.max_abs) + ")";
    if (ours.held_out)
        text += ", and of *" + Digits(ours.held_out->pooled.rms) +
                "* on maps that it was not fitted to";
    return text + ".";
}

std::string PublishedSentence(const FormulaRecord& ours, const FormulaRecord& published) {
    const Score& theirs = published.in_sample.pooled;
    std::string text = "The published formula (" + doc::Verbatim(published.name) +
                       ") has an RMS error of *" + Digits(theirs.rms) +
                       "* on the same data (worst bin " + Digits(theirs.max_abs) + "), " +
                       Compared(JudgedBy(ours).rms, theirs.rms, "the recommended one's");
    if (ours.held_out) text += " on unseen maps";
    text += ".";
    if (theirs.poles > 0)
        text += " At " + Count(theirs.poles) + " of " + Count(theirs.samples) +
                " samples it is not even finite.";
    if (theirs.out_of_range > 0)
        text += " At " + Count(theirs.out_of_range) + " of " + Count(theirs.samples) +
                " it leaves [0, 1]: light from nowhere, or less than none.";
    return text;
}

std::string UnfittedSentence(const FormulaRecord& ours, const FormulaRecord& unfitted) {
    const double us = JudgedBy(ours).rms, them = unfitted.in_sample.pooled.rms;
    return "The best formula without any constant fitted here is *" +
           doc::Verbatim(unfitted.name) + "*, RMS " + Digits(them) + ": " +
           (them < us ? "on surfaces it has not seen, the recommended formula does not beat it."
                      : Compared(us, them, "the recommended one's") +
                            (ours.held_out ? " on unseen maps." : "."));
}

std::string FloorSentence(const FitReport& report, const FormulaRecord& ours) {
    return "Facet by facet, not bin by bin, the recommended formula errs by " +
           Digits(PooledFacetRms(ours)) + ". No function of V alone can err by less than " +
           Digits(PooledFloor(report, &Floors::of_V)) +
           " on these maps, none of α alone by "
           "less than " +
           Digits(PooledFloor(report, &Floors::of_alpha)) + ", none of both by less than " +
           Digits(PooledFloor(report, &Floors::of_both)) + ".";
}

std::string SpreadSentence(const FitReport& report, const FormulaRecord& ours) {
    const ScoreRow& row = ours.held_out ? *ours.held_out : ours.in_sample;
    const auto [best, worst] =
        std::minmax_element(row.maps.begin(), row.maps.end(),
                            [](const Score& a, const Score& b) { return a.rms < b.rms; });
    const auto name = [&](auto at) {
        return doc::Verbatim(report.maps[std::size_t(at - row.maps.begin())].name);
    };
    return "It depends on the surface: the recommended formula's RMS runs from " +
           Digits(best->rms) + " (" + name(best) + ") to " + Digits(worst->rms) + " (" +
           name(worst) + ")" + (ours.held_out ? ", each map held out in its turn." : ".");
}

std::string CurveSentence(const CurveFit& curve) {
    std::vector<std::string> constants, published;
    for (std::size_t j = 0; j < curve.fit.parameters.size(); ++j) {
        const FittedParameter& parameter = curve.fit.parameters[j];
        constants.push_back(doc::Verbatim(parameter.name) + " = " +
                            WithError(parameter.value, parameter.standard_error.value_or(0)) +
                            (parameter.at_bound ? " (at its bound)" : ""));
        if (curve.published) published.push_back(Exact(Rounded(curve.published->values[j], 5)));
    }
    std::string text = "*" + doc::Verbatim(curve.title) + "* refitted: " + Listed(constants);
    if (curve.published) text += " (published " + Listed(published) + ")";
    text += "; RMS " + Digits(curve.fit.rmse);
    if (curve.published_score) text += " against " + Digits(curve.published_score->rms);
    return text + (curve.fit.converged ? "." : ". *This fit did not converge.*");
}

std::string EnergySentence(const FitReport& report) {
    double furnace = 0, aperture = 0;
    bool known = true, closed = false;
    for (const SurfaceReport& map : report.maps) {
        known = known && std::isfinite(map.figures.max_furnace_error);
        furnace = std::max(furnace, map.figures.max_furnace_error);
        if (map.figures.aperture) {
            closed = true;
            aperture = std::max(aperture, std::abs(map.figures.aperture->value - 1));
        }
    }
    std::string text = "The simulation keeps its energy: ";
    if (known)
        text += "at albedo 1 the bounces of every facet sum to 1 " +
                (furnace > 0 ? "within " + Digits(furnace, 2) : "exactly");
    if (known && closed) text += "; ";
    if (closed)
        text += "the openings of every closed map add up to its ground area within " +
                Digits(aperture, 2);
    return known || closed ? text + "." : "";
}

std::string FaultSentence(const FormulaFaults& faults) {
    std::vector<std::string> poles;
    for (const FormulaFaults::Pole& pole : faults.poles)
        for (const UniformVisibility& alpha : pole.alphas)
            poles.push_back("α = " + Digits(alpha.value, 4) + " (ρ = " + Exact(pole.rho.value) +
                            ")");
    std::string text;
    if (!poles.empty()) {
        const std::size_t shown = std::min<std::size_t>(poles.size(), 3);
        text += "With the " + doc::Verbatim(faults.name) +
                " constants, eq. 12 of the paper has poles: " +
                Listed({poles.begin(), poles.begin() + std::ptrdiff_t(shown)}) +
                (shown < poles.size() ? " and more" : "") + ".";
    }
    for (const BrokenInterval& interval : faults.above_one)
        text += (text.empty() ? "With the " + doc::Verbatim(faults.name) + " constants F₀"
                              : std::string(" F₀")) +
                " exceeds 1 for α between " + Exact(Rounded(interval.low, 4)) + " and " +
                Exact(Rounded(interval.high, 4)) + ".";
    return text;
}

std::string UnconvergedSentence(const FitReport& report) {
    std::vector<std::string> names;
    for (const std::vector<CurveFit>* list : {&report.curves, &report.bounce_family})
        for (const CurveFit& curve : *list)
            if (!curve.fit.converged) names.push_back(curve.title);
    for (const TotalFit& total : report.totals)
        if (!total.fit.converged) names.push_back(total.formula);
    return names.empty()
               ? ""
               : "Not converged, do not use their constants: " + doc::Verbatim(Listed(names)) +
                     ".";
}

std::vector<doc::Fact> Headlines(const FitReport& report, const FormulaRecord& ours,
                                 const FormulaRecord& published) {
    std::int64_t facets = 0;
    for (const SurfaceReport& map : report.maps) facets += map.figures.facets;
    const auto error = [](const char* key, std::string title, double rms) {
        return doc::Fact{{.key = key, .title = std::move(title), .better = doc::Better::kLess},
                         rms};
    };
    std::vector<doc::Fact> facts{
        error("recommended_rms",
              ours.held_out ? "RMS error of E(ρ), recommended formula, maps not fitted to"
                            : "RMS error of E(ρ), recommended formula",
              JudgedBy(ours).rms),
        error("published_rms", "RMS error of E(ρ), published formula, same maps",
              published.in_sample.pooled.rms),
        {{.key = "facets", .title = "Facets simulated"}, facets}};
    if (std::isfinite(PooledFacetRms(ours)))
        facts.push_back(error("recommended_facet_rms", "RMS error a facet, recommended formula",
                              PooledFacetRms(ours)));
    if (!report.floors.empty())
        facts.push_back(error("facet_floor",
                              "RMS error a facet that no function of V goes below",
                              PooledFloor(report, &Floors::of_V)));
    return facts;
}

}  // namespace

doc::Section Findings(const FitReport& report) {
    const FormulaRecord &ours = RecordNamed(report, report.recommended),
                        &published = RecordNamed(report, report.published);
    std::vector<std::string> sentences{RecommendedSentence(report, ours)};
    for (const std::string& caveat : CaveatsOf(report, ours))
        sentences.push_back("*Beware:* " + doc::Verbatim(caveat));
    if (report.choice) sentences.push_back(ChoiceSentence(report));
    if (published.name != ours.name) sentences.push_back(PublishedSentence(ours, published));
    if (const FormulaRecord* unfitted = BestUnfitted(report))
        sentences.push_back(UnfittedSentence(ours, *unfitted));
    if (report.maps.size() > 1) sentences.push_back(SpreadSentence(report, ours));
    if (!report.floors.empty()) sentences.push_back(FloorSentence(report, ours));
    for (const CurveFit& curve : report.curves)
        if (curve.published) sentences.push_back(CurveSentence(curve));
    for (const FormulaFaults& faults : report.faults)
        sentences.push_back(FaultSentence(faults));
    sentences.push_back(EnergySentence(report));
    sentences.push_back(UnconvergedSentence(report));
    sentences.push_back(
        "E(ρ) is the light that arrives with all bounces at albedo ρ, over what open ground "
        "receives: 0 is black, 1 is open ground, so an error of 0.01 is one hundredth of full "
        "light. α is the open share of the hemisphere's solid angle, V the same weighted by "
        "the "
        "cosine; they are two different numbers.");
    std::erase(sentences, "");
    return {.id = "findings",
            .title = "Read this first",
            .listed = true,
            .sentences = std::move(sentences),
            .facts = Headlines(report, ours, published)};
}

}  // namespace plumb::fit_sections
