// The paper's curves over alpha: F0, F1, and one for each bounce.
#include <algorithm>

#include "reports/fit_plots.h"
#include "reports/fit_sections.h"
#include "reports/histogram_plots.h"
#include "reports/text.h"

namespace plumb::fit_sections {
namespace {

constexpr int kCurvePoints = 201;

Column CurveColumn(const Formula& formula) {
    std::vector<double> y;
    for (int i = 0; i < kCurvePoints; ++i)
        y.push_back(formula({UniformVisibility(i / double(kCurvePoints - 1)), {}, {}}));
    return y;
}

Column EvenColumn() {
    std::vector<double> x;
    for (int i = 0; i < kCurvePoints; ++i) x.push_back(i / double(kCurvePoints - 1));
    return x;
}

void AddBounds(PlotView& view, Column even) {
    std::vector<double> least, greatest;
    for (int i = 0; i < kCurvePoints; ++i) {
        const UniformVisibility alpha(i / double(kCurvePoints - 1));
        least.push_back(LeastCosineVisibility(alpha));
        greatest.push_back(GreatestCosineVisibility(alpha));
    }
    view.series.push_back(
        Series("bounds of V: α², α(2 – α)", Mark::kDashed, kBoundColor, even, least));
    view.series.push_back(Series("", Mark::kDashed, kBoundColor, even, greatest));
}

void AddBand(PlotView& view, const BounceHistogram& histogram, std::size_t k, Column x) {
    view.series.push_back(Series(
        "5 to 95 % of facets", Mark::kBand, kDataBandColor, x,
        BinColumn(histogram, [&](const BounceBin& bin) { return bin.bounce[k].p05; }), {},
        BinColumn(histogram, [&](const BounceBin& bin) { return bin.bounce[k].p95; })));
    view.series.push_back(
        Series("median", Mark::kLine, "#7d8694", x,
               BinColumn(histogram, [&](const BounceBin& bin) { return bin.bounce[k].p50; })));
}

/// Value and residual of one bounce, for every choice of map.
std::pair<Plot, Plot> CurvePlots(const FitReport& report, int bounce) {
    const std::string symbol = bounce == 0 ? "F₀" : "F₁";
    const std::string id = "curve-" + std::to_string(bounce);
    Plot value{
        .id = id,
        .title = bounce == 0 ? "Direct light F₀: V guessed from α"
                             : "First bounce F₁: E₁ guessed from α",
        .caption = bounce == 0
                       ? "Dots: simulated mean V of the facets of one α (several maps: "
                         "one colour each). Lines: the curve fitted to all maps, and the "
                         "one in print. No surface can leave the grey bounds."
                       : "Dots: simulated mean light of the first bounce. The band, where "
                         "a single map is chosen, holds nine facets in ten: its width is "
                         "what no curve over α can know.",
        .x = {"uniform visibility α [–]", 0, 1},
        .y = {bounce == 0 ? "V = E₀ [–]" : "E₁ [–, open ground = 1]", 0, {}},
    };
    if (bounce == 0) value.y.high = 1.05;
    Plot residual{
        .id = id + "-residual",
        .title = "What the curves of " + symbol + " leave",
        .caption = "Curve minus simulated mean, for all maps or the one chosen.",
        .x = value.x,
        .y = {},
    };
    const std::vector<DrawnCurve> curves = CurvesOf(report, bounce);
    const Column even = EvenColumn();
    std::vector<Column> lines;
    for (const DrawnCurve& curve : curves) lines.push_back(CurveColumn(*curve.formula));
    const auto k = std::size_t(bounce);
    const auto mean = [k](const BounceBin& bin) { return bin.bounce[k].mean; };

    double largest = 0;
    for (const Choice& choice : Choices(report, &SurfaceReport::over_alpha)) {
        const Column x = Abscissae(choice.histogram);
        const Column data = BinColumn(choice.histogram, mean);
        PlotView view = PlotView{.keys = {{"map", choice.name}}}, left = view;
        // What is drawn first lies on top: curves, then data, then its band.
        for (std::size_t i = 0; i < curves.size(); ++i)
            view.series.push_back(
                Series(curves[i].label, curves[i].mark, curves[i].color, even, lines[i]));
        if (choice.pooled) {
            for (std::size_t m = 0; m < report.maps.size(); ++m) {
                PlotSeries dots = Series(report.maps[m].name, Mark::kDots, DotColor(int(m)),
                                         Abscissae(report.maps[m].over_alpha),
                                         BinColumn(report.maps[m].over_alpha, mean));
                dots.shape = int(m) % 5;
                view.series.push_back(std::move(dots));
            }
        } else {
            view.series.push_back(Series("mean", Mark::kDots, kDataColor, x, data));
            AddBand(view, choice.histogram, k, x);
        }
        if (bounce == 0) AddBounds(view, even);
        for (const DrawnCurve& curve : curves) {
            const Column y = BinColumn(choice.histogram, [&](const BounceBin& bin) {
                const double predicted = (*curve.formula)(At(bin));
                TakeLargest(largest, predicted - mean(bin));
                return predicted;
            });
            left.series.push_back(Series(curve.label, curve.mark, curve.color, x, y, data));
        }
        value.views.push_back(std::move(view));
        residual.views.push_back(std::move(left));
    }
    residual.y = ResidualAxis("curve – simulation [–]", largest);
    return {value, residual};
}

}  // namespace

doc::Section Curves(const FitReport& report) {
    doc::Section section{
        .id = "curves",
        .title = "The paper's curves: F₀ and F₁",
        .sentences =
            {"`F₀(α) = α (1 + a (1 – α)^p)                       direct light\n"
             "F₁(α) = A α (1 – α)^q exp(–B α^C)                 first bounce; in print q "
             "= 3/2, C = 1/4`"},
        .tables = {ConstantsTable("curve_constants", report.curves, {})}};
    // Of curves measured elsewhere: what their unit was taken to be.
    if (report.maps.empty() && report.provenance.maps.size() == 1)
        section.sentences.push_back(doc::Verbatim(report.provenance.maps[0].preparation + "."));
    if (report.maps.empty()) return section;
    auto [direct, direct_residual] = CurvePlots(report, 0);
    auto [first, first_residual] = CurvePlots(report, 1);
    section.plots = {
        {.selectors = {{"map", "Map", Names(Choices(report, &SurfaceReport::over_alpha))}},
         .plots = {direct, first, direct_residual, first_residual}}};
    return section;
}

doc::Section BounceFamily(const FitReport& report) {
    doc::Section section{.id = "bounces",
                         .title = "Bounce by bounce",
                         .sections = {{.id = "bounce_constants",
                                       .title = "Constants of every bounce",
                                       .folded = true,
                                       .tables = {ConstantsTable("bounce_constants",
                                                                 report.bounce_family, {})}}}};
    if (report.maps.empty()) return section;
    Plot linear{.id = "family",
                .title = "Light of each bounce",
                .caption =
                    "Dots: simulated, one colour a bounce. Lines: A α (1 – α)^1.5 exp(–B "
                    "α^C), its three constants fitted to each bounce by itself.",
                .x = {"uniform visibility α [–]", 0, 1},
                .y = {"E_k [–, open ground = 1]", 0, {}}};
    Plot log = linear;
    log.id = "family-log";
    log.title = "The same, to see the faint ones";
    log.caption =
        "On a logarithmic scale equal steps between curves mean a constant ratio τ from bounce "
        "to bounce, as the paper assumes; steps that shrink mean that it is not constant.";
    log.y = {.label = "E_k [–, open ground = 1]", .low = 1e-4, .high = 1, .logarithmic = true};
    Plot residual = linear;
    residual.id = "family-residual";
    residual.title = "What the curves leave";
    residual.caption = "Curve minus simulated mean, one colour a bounce.";
    Plot sum = linear;
    sum.id = "family-sum";
    sum.title = "All bounces sum to 1";
    sum.caption =
        "Light that has arrived after the direct light and so many bounces, at albedo 1. "
        "However closed the surface, all light comes back in the end: the sums rise to 1. What "
        "is missing at the top curve is still under way.";
    sum.y = {"Σ E_k at albedo 1 [–]", 0, 1.05};

    double largest = 0;
    const std::vector<Choice> choices = Choices(report, &SurfaceReport::over_alpha);
    for (const Choice& choice : choices) {
        const BounceHistogram& histogram = choice.histogram;
        const Column x = Abscissae(histogram);
        PlotView drawn = PlotView{.keys = {{"map", choice.name}}}, left = drawn, sums = drawn;
        const int bounces = histogram.Bounces();
        const auto color = [&](int k) { return BounceColor(k, bounces); };
        for (const CurveFit& curve : report.bounce_family) {
            const auto k = std::size_t(curve.bounce);
            if (curve.bounce > bounces) continue;
            const auto mean = [k](const BounceBin& bin) { return bin.bounce[k].mean; };
            const Column data = BinColumn(histogram, mean);
            const Column y = BinColumn(histogram, [&](const BounceBin& bin) {
                const double predicted = curve.fitted(At(bin));
                TakeLargest(largest, predicted - mean(bin));
                return predicted;
            });
            const std::string label =
                InLegend(curve.bounce) ? "bounce " + std::to_string(curve.bounce) : "";
            drawn.series.push_back(Series("", Mark::kDots, color(curve.bounce), x, data));
            drawn.series.push_back(Series(label, Mark::kLine, color(curve.bounce), x, y));
            left.series.push_back(Series(label, Mark::kLine, color(curve.bounce), x, y, data));
        }
        for (int last = 0; last <= bounces; ++last) {
            if (last != 0 && last != bounces && !InLegend(last)) continue;
            sums.series.push_back(
                Series(last == 0 ? "direct" : "to bounce " + std::to_string(last), Mark::kLine,
                       last == 0 ? kDataColor : color(last), x,
                       BinColumn(histogram, [&](const BounceBin& bin) {
                           double total = 0;
                           for (int k = 0; k <= last; ++k)
                               total += bin.bounce[std::size_t(k)].mean;
                           return total;
                       })));
        }
        linear.views.push_back(drawn);
        log.views.push_back(std::move(drawn));
        residual.views.push_back(std::move(left));
        sum.views.push_back(std::move(sums));
    }
    residual.y = ResidualAxis("curve – simulation [–]", largest);
    section.plots = {
        {.selectors = {{"map", "Map", Names(choices)}}, .plots = {linear, log, residual, sum}}};
    return section;
}

}  // namespace plumb::fit_sections
