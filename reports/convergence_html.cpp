// Error against simulation time, on logarithmic axes.
#include <algorithm>
#include <cmath>

#include "reports/fit_plots.h"
#include "reports/fit_report_page.h"
#include "reports/fit_report_parts.h"
#include "reports/page.h"
#include "reports/render.h"
#include "reports/surface_html.h"
#include "reports/text.h"

namespace plumb::page {
namespace {

/// The abscissa at which a falling series of (x, error) reaches `error`, interpolated between
/// logarithms. NaN if it does not.
double Reaches(const std::vector<double>& x, const std::vector<double>& errors, double error) {
    for (std::size_t i = 0; i + 1 < x.size(); ++i)
        if (errors[i] >= error && errors[i + 1] <= error && errors[i + 1] < errors[i]) {
            const double t = std::log(errors[i] / error) / std::log(errors[i] / errors[i + 1]);
            return x[i] * std::pow(x[i + 1] / x[i], t);
        }
    return SurfaceFigures::kUnknown;
}

struct MethodSeries {
    std::string method;
    std::vector<double> per_facet, seconds, rms_V, rms_E;
};

std::vector<MethodSeries> ByMethod(const Convergence& convergence) {
    std::vector<MethodSeries> methods;
    for (const ConvergencePoint& point : convergence.points) {
        auto found = std::find_if(
            methods.begin(), methods.end(),
            [&](const MethodSeries& series) { return series.method == point.method; });
        if (found == methods.end()) {
            methods.push_back({point.method, {}, {}, {}, {}});
            found = methods.end() - 1;
        }
        found->per_facet.push_back(point.per_facet);
        found->seconds.push_back(point.seconds.value);
        found->rms_V.push_back(point.rms_V);
        found->rms_E.push_back(point.rms_E_half);
    }
    return methods;
}

/// "At the error of 1024 rays (...), slices take 0.3 s instead of 5 s."
std::string SpeedSentence(const std::vector<MethodSeries>& methods) {
    std::string text;
    for (const MethodSeries& slow : methods)
        for (const MethodSeries& fast : methods) {
            const double error = slow.rms_V.back();
            const double seconds = Reaches(fast.seconds, fast.rms_V, error);
            if (&slow == &fast || !(seconds < slow.seconds.back())) continue;
            text += " The error of " + Count((long long)slow.per_facet.back()) + " " +
                    Html(slow.method) + " a facet (RMS " + Digits(error, 2) + ") costs " +
                    Digits(slow.seconds.back(), 3) + " s; " + Html(fast.method) +
                    " reach it in " + Digits(seconds, 2) + " s, " +
                    Digits(slow.seconds.back() / seconds, 2) + " times faster.";
        }
    return text;
}

}  // namespace

std::string ErrorAgainstTime(const Convergence& convergence, PlotSheet& sheet) {
    const std::vector<MethodSeries> methods = ByMethod(convergence);
    const std::string by_time = "simulation time", by_count = "rays or slices of a facet";
    Plot visibility{.id = "time-visibility",
                    .title = "Error of V",
                    .caption =
                        "Each point is a whole simulation. Down and to the left is "
                        "better; a slope of –1/2 is that of random rays.",
                    .x = {},
                    .y = {.label = "RMS error of V over facets [–]",
                          .low = {},
                          .high = {},
                          .logarithmic = true},
                    .views = {}};
    Plot total = visibility;
    total.id = "time-total";
    total.title = "Error of all bounces, E(0.5)";
    total.caption = "The same simulations, judged by the light of all bounces at albedo 0.5.";
    total.y.label = "RMS error of E(0.5) over facets [–]";
    for (const bool timed : {true, false}) {
        PlotView of_V = View({{"against", timed ? by_time : by_count}});
        of_V.x = Axis{.label = timed ? "simulation time [s]" : by_count,
                      .low = {},
                      .high = {},
                      .logarithmic = true};
        PlotView of_E = of_V;
        for (std::size_t i = 0; i < methods.size(); ++i) {
            const Column x = sheet.Add(timed ? methods[i].seconds : methods[i].per_facet);
            PlotSeries series = Series(methods[i].method, Mark::kDots, CategoryColor(int(i)), x,
                                       sheet.Add(methods[i].rms_V));
            series.joined = true;
            of_V.series.push_back(series);
            series.y = sheet.Add(methods[i].rms_E);
            of_E.series.push_back(series);
        }
        visibility.views.push_back(std::move(of_V));
        total.views.push_back(std::move(of_E));
    }
    std::vector<std::vector<Cell>> rows;
    for (const ConvergencePoint& point : convergence.points)
        rows.push_back(
            {{Html(point.method), "", ""},
             {Count(point.per_facet), "", ""},
             {doc::CellText({.key = "time_s", .title = "Time"}, point.seconds), "", ""},
             {Digits(point.rms_V), "", ""},
             {Digits(point.max_abs_V), "", ""},
             {Digits(point.rms_E_half), "", ""}});
    std::string html = "<p>Map: " + Html(convergence.map) + ", " + Count(convergence.facets) +
                       " facets, " + std::to_string(convergence.threads) +
                       (convergence.threads == 1 ? " thread" : " threads") +
                       "; errors against " + Html(convergence.reference) + ".";
    if (convergence.machine_rays_per_second > 0)
        html += " This machine casts " + Digits(convergence.machine_rays_per_second / 1e6) +
                " million raw rays a second, measured in the same run.";
    html += SpeedSentence(methods) + "</p>\n";
    html += sheet.Group({{"against", "Against", {by_time, by_count}}}, {visibility, total});
    return html + Table({{"method"},
                         {"a facet"},
                         {"time [s]"},
                         {"RMS of V [–]"},
                         {"worst V [–]"},
                         {"RMS of E(0.5) [–]"}},
                        rows);
}

}  // namespace plumb::page
