#include "jobs/light/convergence_study.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/parallel.h"
#include "formfactor/bounces.h"

namespace plumb {
namespace {

constexpr std::uint64_t kReferenceSeed = 0x5eed;
// Finer than what is judged: a reference cut alike would hide what the cut costs.
constexpr CutOptions kReferenceCut{.extent_texels = 0.5, .most_pieces = 24};

struct Light {
    std::vector<double> V;
    std::vector<float> E_half;
};

Light LightOf(const HeightField& field, const SimulateSettings& settings, Monitor& monitor) {
    const FacetPieces pieces(field, settings.cut);
    const Links links = MakeLinksOf(field, pieces, settings, monitor);
    Series series = RunSeries(
        links, pieces, {.bounces = 0, .albedos = {0.5}}, [](int, std::span<const double>) {},
        monitor);
    return {pieces.FacetMeans(std::span<const double>(links.V)), std::move(series.total[0])};
}

template <class T>
double Rms(const std::vector<T>& a, const std::vector<T>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double d = double(a[i]) - double(b[i]);
        sum += d * d;
    }
    return std::sqrt(sum / double(a.size()));
}

}  // namespace

Convergence StudyConvergence(const std::string& name, const HeightField& field,
                             const ConvergenceSettings& settings, const Clock& clock,
                             Monitor& monitor) {
    SimulateSettings exact;
    exact.slices.slices = settings.reference_slices;
    exact.slices.seed = kReferenceSeed;
    exact.cut = kReferenceCut;
    const Light reference = LightOf(field, exact, monitor);

    Convergence out;
    out.map = name;
    out.reference =
        "slices, " + std::to_string(settings.reference_slices) + " a facet, cut " +
        std::to_string(std::lround(kDefaultCut.extent_texels / kReferenceCut.extent_texels)) +
        " times as fine";
    out.facets = field.Facets();
    out.threads = ThreadCount();
    std::vector<SimulateSettings> judged;
    const auto judge = [&](LinkMethod method, int per_facet) {
        SimulateSettings& one = judged.emplace_back();
        one.method = method;
        one.slices.slices = one.rays.rays = per_facet;
    };
    for (const int n : settings.slices) judge(LinkMethod::kSlices, n);
    for (const int n : settings.rays) judge(LinkMethod::kRays, n);
    std::vector<Light> lights(judged.size());
    std::vector<Turn> turns;
    for (std::size_t k = 0; k < judged.size(); ++k) {
        turns.push_back({.run = [&, k] { lights[k] = LightOf(field, judged[k], monitor); }});
    }
    const TurnTimes times = TimeInTurns(turns, settings.rounds, clock, monitor);
    for (std::size_t k = 0; k < judged.size(); ++k) {
        const Light& light = lights[k];
        ConvergencePoint point;
        point.method = SamplingOf(judged[k]).method;
        point.per_facet = SamplingOf(judged[k]).per_facet;
        point.seconds = times.Seconds(k);
        point.rms_V = Rms(light.V, reference.V);
        point.rms_E_half = Rms(light.E_half, reference.E_half);
        for (std::size_t i = 0; i < light.V.size(); ++i) {
            point.max_abs_V = std::max(point.max_abs_V, std::abs(light.V[i] - reference.V[i]));
        }
        out.points.push_back(point);
    }
    return out;
}

}  // namespace plumb
