#include "reports/fit_plots.h"

#include <algorithm>
#include <cmath>

#include "reports/histogram_plots.h"

namespace plumb::fit_sections {
namespace {

/// The next round number that is not below x.
double RoundUp(double x) {
    const double decade = std::pow(10, std::floor(std::log10(x)));
    for (const double step : {1.0, 1.5, 2.0, 3.0, 5.0})
        if (step * decade >= x * (1 - 1e-12)) return step * decade;
    return 10 * decade;
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

Axis ResidualAxis(std::string label, double largest) {
    const double reach = std::min(largest > 0 ? RoundUp(largest) : 0.01, 0.5);
    return {.label = std::move(label), .low = -reach, .high = reach};
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

}  // namespace plumb::fit_sections
