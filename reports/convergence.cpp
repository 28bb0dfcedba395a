#include "reports/convergence.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/columns.h"
#include "reports/text.h"

namespace plumb {
namespace {

using doc::Better;
using doc::Role;

/// The abscissa at which a falling series of (x, error) reaches `error`, interpolated between
/// logarithms. NaN if it does not.
double Reaches(const std::vector<double>& x, const std::vector<double>& errors, double error) {
    for (std::size_t i = 0; i + 1 < x.size(); ++i)
        if (errors[i] >= error && errors[i + 1] <= error && errors[i + 1] < errors[i]) {
            const double t = std::log(errors[i] / error) / std::log(errors[i] / errors[i + 1]);
            return x[i] * std::pow(x[i + 1] / x[i], t);
        }
    return std::numeric_limits<double>::quiet_NaN();
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

doc::Column Time(const char* key, const char* title, const char* unit, Better better) {
    return {.key = key, .title = title, .unit = unit, .role = Role::kTime, .better = better};
}

doc::Table Points(const Convergence& convergence) {
    doc::Table table{
        .key = "convergence",
        .columns = {doc::Name("method", "Method"), doc::Name("per_facet", "A facet"),
                    Time("time_s", "Time", "s", Better::kLess),
                    doc::ErrorOf("rms_v", "RMS error of V"),
                    doc::ErrorOf("max_abs_v", "Largest error of V"),
                    doc::ErrorOf("rms_e_half", "RMS error of E(1/2)")}};
    for (const ConvergencePoint& p : convergence.points)
        table.Add({p.method, p.per_facet, p.seconds, p.rms_V, p.max_abs_V, p.rms_E_half});
    return table;
}

/// What one method takes to the error that another one has at its greatest count.
doc::Table SameError(const std::vector<MethodSeries>& methods) {
    doc::Table table{
        .key = "same_error",
        .title = "Time to the same error of V",
        .columns = {doc::Name("method", "Method"), doc::Name("per_facet", "A facet"),
                    doc::Value("rms_v", "RMS error of V"),
                    Time("time_s", "Time", "s", Better::kNeither),
                    doc::Name("other", "Reached by"),
                    Time("reached_s", "in", "s", Better::kLess),
                    Time("times_faster", "Times faster", "", Better::kMore)}};
    for (const MethodSeries& one : methods)
        for (const MethodSeries& other : methods) {
            const double error = one.rms_V.back();
            if (&one == &other || std::isnan(Reaches(other.per_facet, other.rms_V, error)))
                continue;
            const double reached_s = Reaches(other.seconds, other.rms_V, error);
            table.Add({one.method, std::int64_t(one.per_facet.back()), error,
                       one.seconds.back(), other.method, reached_s,
                       one.seconds.back() / reached_s});
        }
    return table;
}

doc::Plots Drawn(const std::vector<MethodSeries>& methods) {
    const std::string by_time = "simulation time", by_count = "rays or slices of a facet";
    Plot visibility{.id = "time-visibility",
                    .title = "Error of V",
                    .caption =
                        "Each point is a whole simulation. Down and to the left is better; "
                        "a slope of –1/2 is that of random rays.",
                    .y = {.label = "RMS error of V over facets [–]", .logarithmic = true}};
    Plot total{
        .id = "time-total",
        .title = "Error of all bounces, E(0.5)",
        .caption = "The same simulations, judged by the light of all bounces at albedo 0.5.",
        .y = {.label = "RMS error of E(0.5) over facets [–]", .logarithmic = true}};
    for (const bool timed : {true, false}) {
        PlotView of_V{.keys = {{"against", timed ? by_time : by_count}}};
        of_V.x = Axis{.label = timed ? "simulation time [s]" : by_count, .logarithmic = true};
        PlotView of_E = of_V;
        for (std::size_t i = 0; i < methods.size(); ++i) {
            PlotSeries series{.label = methods[i].method,
                              .mark = Mark::kDots,
                              .color = CategoryColor(int(i)),
                              .x = timed ? methods[i].seconds : methods[i].per_facet,
                              .y = methods[i].rms_V,
                              .joined = true};
            of_V.series.push_back(series);
            series.y = methods[i].rms_E;
            of_E.series.push_back(series);
        }
        visibility.views.push_back(std::move(of_V));
        total.views.push_back(std::move(of_E));
    }
    return {.selectors = {{"against", "Against", {by_time, by_count}}},
            .plots = {visibility, total},
            .of_times = true};
}

}  // namespace

doc::Section ConvergenceSection(const Convergence& convergence) {
    const std::vector<MethodSeries> methods = ByMethod(convergence);
    return {.id = "time",
            .title = "Error against simulation time",
            .sentences = {"Map: " + doc::Verbatim(convergence.map) + ", " +
                          Count(convergence.facets) + " facets; errors against " +
                          doc::Verbatim(convergence.reference) + "."},
            .facts = {{{.key = "threads", .title = "Threads", .role = Role::kTime},
                       convergence.threads}},
            .tables = {Points(convergence), SameError(methods)},
            .plots = {Drawn(methods)}};
}

}  // namespace plumb
