// What the figures say, in sentences computed from them, and the tables of the first sections.
#include <algorithm>
#include <cmath>

#include "reports/fit_caveats.h"
#include "reports/fit_report_page.h"
#include "reports/fit_report_parts.h"
#include "reports/page.h"
#include "reports/text.h"

namespace plumb::page {
namespace {

using parts::Find;
using parts::JudgedBy;

std::string Greek(const std::string& inputs) {
    return inputs == "alpha" ? "α" : inputs == "V" ? "V" : "α and V";
}

std::string Tile(const std::string& css, const std::string& figure, const std::string& text) {
    return "<div class=\"tile " + css + "\"><b>" + figure + "</b><span>" + text +
           "</span></div>\n";
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
    std::string text = "<b>" + Html(ours.name) + "</b> is recommended: it predicts E(ρ) from " +
                       Greek(parts::Inputs(ours.formula.model, ", ")) +
                       " with an RMS error of <b>" + Digits(score.rms) + "</b> over " +
                       std::to_string(report.maps.size()) +
                       (report.maps.size() == 1 ? " map" : " maps") + " (worst bin " +
                       Digits(score.max_abs) + ")";
    if (ours.held_out)
        text += ", and of <b>" + Digits(ours.held_out->pooled.rms) +
                "</b> on maps that it was not fitted to";
    return text + ".";
}

std::string PublishedSentence(const FormulaRecord& ours, const FormulaRecord& published) {
    const Score& theirs = published.in_sample.pooled;
    std::string text = "The published formula (" + Html(published.name) +
                       ") has an RMS error of <b>" + Digits(theirs.rms) +
                       "</b> on the same data (worst bin " + Digits(theirs.max_abs) + "), " +
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
    return "The best formula without any constant fitted here is <b>" + Html(unfitted.name) +
           "</b>, RMS " + Digits(them) + ": " +
           (them < us ? "on surfaces it has not seen, the recommended formula does not beat it."
                      : Compared(us, them, "the recommended one's") +
                            (ours.held_out ? " on unseen maps." : "."));
}

std::string FloorSentence(const FitReport& report, const FormulaRecord& ours) {
    return "Facet by facet, not bin by bin, the recommended formula errs by " +
           Digits(parts::PooledFacetRms(ours)) +
           ". No function of V alone can err by less than " +
           Digits(parts::PooledFloor(report, &Floors::of_V)) +
           " on these maps, none of α alone by "
           "less than " +
           Digits(parts::PooledFloor(report, &Floors::of_alpha)) +
           ", none of both by less than " +
           Digits(parts::PooledFloor(report, &Floors::of_both)) + ".";
}

std::string SpreadSentence(const FitReport& report, const FormulaRecord& ours) {
    const ScoreRow& row = ours.held_out ? *ours.held_out : ours.in_sample;
    const auto [best, worst] =
        std::minmax_element(row.maps.begin(), row.maps.end(),
                            [](const Score& a, const Score& b) { return a.rms < b.rms; });
    const auto name = [&](auto at) {
        return Html(report.maps[std::size_t(at - row.maps.begin())].name);
    };
    return "It depends on the surface: the recommended formula's RMS runs from " +
           Digits(best->rms) + " (" + name(best) + ") to " + Digits(worst->rms) + " (" +
           name(worst) + ")" + (ours.held_out ? ", each map held out in its turn." : ".");
}

std::string CurveSentence(const CurveFit& curve) {
    std::vector<std::string> constants, published;
    for (std::size_t j = 0; j < curve.fit.parameters.size(); ++j) {
        const FittedParameter& parameter = curve.fit.parameters[j];
        constants.push_back(Html(parameter.name) + " = " +
                            WithError(parameter.value, parameter.standard_error.value_or(0)) +
                            (parameter.at_bound ? " (at its bound)" : ""));
        if (curve.published) published.push_back(Exact(Rounded(curve.published->values[j], 5)));
    }
    std::string text = "<b>" + Html(curve.title) + "</b> refitted: " + Listed(constants);
    if (curve.published) text += " (published " + Listed(published) + ")";
    text += "; RMS " + Digits(curve.fit.rmse);
    if (curve.published_score) text += " against " + Digits(curve.published_score->rms);
    return text + (curve.fit.converged ? "." : ". <b>This fit did not converge.</b>");
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
        text += "With the " + Html(faults.name) +
                " constants, eq. 12 of the paper has poles: " +
                Listed({poles.begin(), poles.begin() + std::ptrdiff_t(shown)}) +
                (shown < poles.size() ? " and more" : "") + ".";
    }
    for (const BrokenInterval& interval : faults.above_one)
        text += (text.empty() ? "With the " + Html(faults.name) + " constants F<sub>0</sub>"
                              : std::string(" F<sub>0</sub>")) +
                " exceeds 1 for α between " + Exact(Rounded(interval.low, 4)) + " and " +
                Exact(Rounded(interval.high, 4)) + ".";
    return text;
}

std::string UnconvergedSentence(const FitReport& report) {
    std::vector<std::string> names;
    for (const std::vector<CurveFit>* list : {&report.curves, &report.bounce_family})
        for (const CurveFit& curve : *list)
            if (!curve.fit.converged) names.push_back(Html(curve.title));
    for (const TotalFit& total : report.totals)
        if (!total.fit.converged) names.push_back(Html(total.formula));
    return names.empty() ? ""
                         : "Not converged, do not use their constants: " + Listed(names) + ".";
}

const TotalFit* TotalFitOf(const FitReport& report, const std::string& formula) {
    for (const TotalFit& total : report.totals)
        if (total.formula == formula) return &total;
    return nullptr;
}

std::string ConstantsTable(const TotalFit& total) {
    std::vector<std::vector<Cell>> rows;
    for (const FittedParameter& parameter : total.fit.parameters) {
        std::string interval = "–", over_maps = "–";
        if (total.bootstrap)
            for (const BootstrapInterval& one : total.bootstrap->parameters)
                if (one.name == parameter.name) {
                    interval = Digits(one.low, 4) + " … " + Digits(one.high, 4);
                    over_maps = Digits(one.standard_error, 2);
                }
        rows.push_back(
            {{Html(parameter.name), "", ""},
             {Digits(parameter.value, 6), "best", ""},
             {parameter.standard_error ? Digits(*parameter.standard_error, 2) : "–", "", ""},
             {over_maps, "", ""},
             {interval, "", ""},
             {parameter.at_bound ? "at its bound" : "", "", ""}});
    }
    return Table({{"constant"},
                  {"value [–]"},
                  {"standard error, samples independent"},
                  {"standard error over maps"},
                  {"interval over maps"},
                  {"", true}},
                 rows);
}

std::string TotalFitHtml(const FitReport& report, const TotalFit& total) {
    std::string html = "<h3>" + Html(total.formula) + "</h3>\n" + ConstantsTable(total);
    html += "<p class=\"note\">" + Count(total.fit.samples) + " samples, RMS " +
            Digits(total.fit.rmse) + ", worst " + Digits(total.fit.max_abs) +
            ", condition number " + Digits(total.fit.condition, 2) + ", " +
            std::to_string(total.fit.starts_agreeing) + " of " +
            std::to_string(total.fit.starts) + " starts agree" +
            (total.fit.converged ? "" : ", <b>did not converge</b>");
    if (total.bootstrap)
        html += ", " + std::to_string(total.bootstrap->replicates) +
                " bootstrap replicates over maps";
    html += ".";
    for (const std::string& caveat : CaveatsOf(report, Find(report, total.formula)))
        html += " <b>Beware:</b> " + Html(caveat);
    return html + "</p>\n";
}

}  // namespace

std::string Findings(const FitReport& report) {
    const FormulaRecord& ours = Find(report, report.recommended);
    const FormulaRecord& published = Find(report, report.published);

    std::string tiles = "<div class=\"tiles\">\n";
    tiles += Tile("ours", Digits(JudgedBy(ours).rms),
                  ours.held_out ? "RMS error of E(ρ), recommended formula, maps not fitted to"
                                : "RMS error of E(ρ), recommended formula");
    tiles += Tile("published", Digits(published.in_sample.pooled.rms),
                  "RMS error of E(ρ), published formula, same maps");
    if (std::isfinite(parts::PooledFacetRms(ours)))
        tiles += Tile("", Digits(parts::PooledFacetRms(ours)),
                      "RMS error a facet, recommended formula" +
                          (report.floors.empty()
                               ? std::string()
                               : "; no function of V can go below " +
                                     Digits(parts::PooledFloor(report, &Floors::of_V))));
    std::int64_t facets = 0;
    for (const SurfaceReport& map : report.maps) facets += map.figures.facets;
    tiles += Tile("", Count(facets),
                  "facets simulated on " + std::to_string(report.maps.size()) +
                      (report.maps.size() == 1 ? " map, " : " maps, ") +
                      std::to_string(report.provenance.bounces) + " bounces");
    tiles += "</div>\n";

    std::vector<std::string> sentences{RecommendedSentence(report, ours)};
    for (const std::string& caveat : CaveatsOf(report, ours))
        sentences.push_back("<b>Beware:</b> " + Html(caveat));
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

    std::string html = tiles + "<ul class=\"findings\">\n";
    for (const std::string& sentence : sentences)
        if (!sentence.empty()) html += "<li>" + sentence + "</li>\n";
    return html +
           "</ul>\n<p class=\"note\">E(ρ) is the light that arrives with all bounces at "
           "albedo ρ, over what open ground receives: 0 is black, 1 is open ground, so an "
           "error "
           "of 0.01 is one hundredth of full light. α is the open share of the hemisphere's "
           "solid angle, V the same weighted by the cosine; they are two different "
           "numbers.</p>\n";
}

std::string Recommended(const FitReport& report) {
    std::string html = "<pre>" + Html(report.recommended_text) + "</pre>\n";
    if (const TotalFit* total = TotalFitOf(report, report.recommended))
        html += TotalFitHtml(report, *total);
    html +=
        "<p class=\"note\">The first standard error takes every sample to be independent "
        "and is too small; the second comes from drawing whole maps anew and is the one to "
        "trust.</p>\n";
    std::string others;
    for (const TotalFit& total : report.totals)
        if (total.formula != report.recommended) others += TotalFitHtml(report, total);
    if (!others.empty())
        html += "<details><summary>Constants of the other fitted totals</summary>\n" + others +
                "</details>\n";
    return html;
}

}  // namespace plumb::page
