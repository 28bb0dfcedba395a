#include "reports/fit_report.h"
#include "reports/fit_report_page.h"
#include "reports/page.h"
#include "reports/surface_html.h"
#include "reports/text.h"

namespace plumb {

std::string ToHtml(const FitReport& report) {
    Validate(report);
    std::vector<std::string> names;
    for (const SurfaceReport& map : report.maps) names.push_back(map.name);
    Page page(
        "Ambient light constants, refitted",
        "How much light reaches a point of an uneven surface under a uniform sky, with all "
        "bounces: simulated on " +
            Listed(names) + ", fitted, and set against the formulas in print.");
    PlotSheet& sheet = page.Plots();
    page.AddSection("findings", "Read this first", page::Findings(report));
    page.AddSection("recommended", "The recommended formula", page::Recommended(report));
    page.AddSection("scores", "Every formula on every map", page::Scores(report));
    if (report.choice)
        page.AddSection("choice", "Chosen on one half, reported on the other",
                        page::FormsCompared(report));
    page.AddSection("totals", "All bounces: E(ρ)", page::Totals(report, sheet));
    page.AddSection("curves", "The paper's curves: F₀ and F₁", page::Curves(report, sheet));
    if (!report.bounce_family.empty())
        page.AddSection("bounces", "Bounce by bounce", page::BounceFamily(report, sheet));
    if (!report.faults.empty())
        page.AddSection("faults", "Where the formula in print breaks",
                        page::Faults(report, sheet));
    page.AddSection("maps", "The surfaces", SurfaceCards(report.maps));
    if (report.amplitudes)
        page.AddSection("amplitude", "Effect of the amplitude",
                        AmplitudeHtml(*report.amplitudes, sheet));
    if (report.convergence)
        page.AddSection("time", "Error against simulation time",
                        page::ErrorAgainstTime(*report.convergence, sheet));
    page.AddSection("again", "How to make this again",
                    ProvenanceHtml(report.provenance, report.timings));
    return page.Text();
}

}  // namespace plumb
