#include "reports/fit_plots.h"

#include <algorithm>
#include <cmath>

#include "reports/page.h"
#include "reports/surface_html.h"
#include "reports/text.h"

namespace plumb::page {
namespace {

/// The next round number that is not below x.
double RoundUp(double x) {
    const double decade = std::pow(10, std::floor(std::log10(x)));
    for (const double step : {1.0, 1.5, 2.0, 3.0, 5.0})
        if (step * decade >= x * (1 - 1e-12)) return step * decade;
    return 10 * decade;
}

std::string Strongest(const LeastSquaresFit& fit) {
    double strongest = 0;
    std::string text = "–";
    for (Eigen::Index i = 0; i < fit.correlation.rows(); ++i)
        for (Eigen::Index j = 0; j < i; ++j)
            if (std::abs(fit.correlation(i, j)) > std::abs(strongest)) {
                strongest = fit.correlation(i, j);
                text = Html(fit.parameters[std::size_t(j)].name) + ", " +
                       Html(fit.parameters[std::size_t(i)].name) + ": " + Digits(strongest, 3);
            }
    return text;
}

}  // namespace

std::vector<Choice> Choices(const FitReport& report, BounceHistogram SurfaceReport::*member) {
    std::vector<Choice> choices;
    std::vector<const BounceHistogram*> all;
    for (const SurfaceReport& map : report.maps) all.push_back(&(map.*member));
    if (all.size() > 1)
        if (std::optional<BounceHistogram> pooled = PooledMeans(all))
            choices.push_back({"all maps", std::move(*pooled), true});
    for (const SurfaceReport& map : report.maps)
        choices.push_back({map.name, map.*member, false});
    return choices;
}

std::vector<std::string> Names(const std::vector<Choice>& choices) {
    std::vector<std::string> names;
    for (const Choice& choice : choices) names.push_back(choice.name);
    return names;
}

LightPoint At(const BounceBin& bin, double rho) {
    return {UniformVisibility(bin.alpha), CosineVisibility(bin.V), Albedo(rho)};
}

PlotSeries Series(std::string label, Mark mark, std::string color, Column x, Column y,
                  Column minus, Column high) {
    return {.label = std::move(label),
            .mark = mark,
            .color = std::move(color),
            .x = x,
            .y = y,
            .minus = minus,
            .high = high,
            .joined = false,
            .shape = 0};
}

PlotView View(std::vector<std::pair<std::string, std::string>> keys) {
    return {.keys = std::move(keys), .series = {}, .x = {}, .y = {}};
}

Axis ResidualAxis(std::string label, double largest) {
    const double reach = std::min(largest > 0 ? RoundUp(largest) : 0.01, 0.5);
    return {.label = std::move(label), .low = -reach, .high = reach, .logarithmic = false};
}

void TakeLargest(double& largest, double difference) {
    if (std::isfinite(difference)) largest = std::max(largest, std::abs(difference));
}

std::vector<DrawnCurve> CurvesOf(const FitReport& report, int bounce) {
    static constexpr const char* kFitColors[] = {kOursColor, "#009e73", "#cc79a7"};
    std::vector<DrawnCurve> list;
    const Formula* published = nullptr;
    std::size_t fits = 0;
    for (const CurveFit& curve : report.curves) {
        if (curve.bounce != bounce) continue;
        list.push_back(
            {curve.title + ", refitted", kFitColors[fits++ % 3], Mark::kLine, &curve.fitted});
        if (curve.published && !published) published = &*curve.published;
    }
    if (published) list.push_back({"published", kPublishedColor, Mark::kDashed, published});
    return list;
}

std::string CurveTable(const std::vector<CurveFit>& curves) {
    std::vector<std::vector<Cell>> rows;
    for (const CurveFit& curve : curves)
        for (std::size_t j = 0; j < curve.fit.parameters.size(); ++j) {
            const FittedParameter& parameter = curve.fit.parameters[j];
            std::vector<Cell> row{
                {j == 0 ? Html(curve.title) : "", "", ""},
                {Html(parameter.name), "", ""},
                {WithError(parameter.value, parameter.standard_error.value_or(0)) +
                     (parameter.at_bound ? " (at bound)" : ""),
                 "best", ""},
                {curve.published ? Exact(Rounded(curve.published->values[j], 5)) : "–", "",
                 ""}};
            if (j == 0) {
                const std::vector<std::string> of_fit{
                    Digits(curve.fit.rmse),
                    Digits(curve.fit.max_abs),
                    curve.published_score ? Digits(curve.published_score->rms) : "–",
                    Digits(curve.fit.condition, 2),
                    Strongest(curve.fit),
                    curve.fit.converged ? "yes" : "<b>no</b>"};
                for (const std::string& figure : of_fit) row.push_back({figure, "", ""});
            } else {
                row.resize(10);
            }
            rows.push_back(std::move(row));
        }
    return Table({{"fit"},
                  {"constant", true},
                  {"value ± standard error"},
                  {"published"},
                  {"RMS [–]"},
                  {"worst [–]"},
                  {"RMS published [–]"},
                  {"condition"},
                  {"strongest correlation"},
                  {"converged"}},
                 rows);
}

}  // namespace plumb::page
