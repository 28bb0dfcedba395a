// The choice of the form on the page: one sentence, one table.
#include "reports/fit_report_page.h"
#include "reports/fit_report_parts.h"
#include "reports/page.h"
#include "reports/text.h"

namespace plumb::page {

std::string ChoiceSentence(const FitReport& report) {
    const FormChoice& choice = *report.choice;
    const FormScore& winner = choice.Winner();
    const std::string recommended(parts::Find(report, report.recommended).formula.model.name);
    std::vector<std::string> choosing, reporting;
    for (const std::string& name : choice.choosing) choosing.push_back(Html(name));
    for (const std::string& name : choice.reporting) reporting.push_back(Html(name));
    std::string text =
        "Of " + std::to_string(choice.forms.size()) + " forms, <b>" + Html(winner.form) +
        "</b> wins on the choosing half of the maps (" + Listed(choosing) + "; RMS held out " +
        Digits(winner.choosing_rms) + "). On the other half (" + Listed(reporting) +
        "), which neither the choice nor the constants have seen, its RMS is <b>" +
        Digits(winner.reporting_rms) + "</b>, rank " +
        std::to_string(choice.RankOnReporting(winner)) + ".";
    if (winner.form == recommended) return text + " It is the recommended form.";
    for (const FormScore& score : choice.forms)
        if (score.form == recommended)
            text += " The recommended form has " + Digits(score.choosing_rms) +
                    " on the choosing half and " + Digits(score.reporting_rms) +
                    " on the other, rank " + std::to_string(choice.RankOnReporting(score)) +
                    ".";
    return text;
}

std::string FormsCompared(const FitReport& report) {
    const FormChoice& choice = *report.choice;
    std::vector<std::vector<Cell>> rows;
    for (const FormScore& score : choice.forms)
        rows.push_back(
            {{Html(score.form), "", ""},
             {std::to_string(score.constants), "", ""},
             {Digits(score.choosing_rms, 4), &score == &choice.Winner() ? "best" : "", ""},
             {Digits(score.reporting_rms, 4), choice.RankOnReporting(score) == 1 ? "best" : "",
              ""}});
    return "<p>A form that is chosen on the maps that it is scored on looks better than it is. "
           "The first, third, fifth ... map given choose, each held out in its turn; the "
           "second, "
           "fourth ... report, with constants fitted to the choosing half.</p>\n<p>" +
           ChoiceSentence(report) + "</p>\n" +
           Table({{"form"},
                  {"constants"},
                  {"RMS, choosing half, held out [–]"},
                  {"RMS, reporting half [–]"}},
                 rows);
}

}  // namespace plumb::page
