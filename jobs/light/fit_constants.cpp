#include "jobs/light/fit_constants.h"

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "fit/models/escape_of_alpha_and_v.h"
#include "fit/models/mayaux_total.h"
#include "jobs/light/amplitude_study.h"
#include "jobs/light/convergence_study.h"
#include "jobs/light/fit_totals.h"

namespace plumb {
namespace {

// The pieces that the studies of one map work on: large enough for all bins to be met.
constexpr int kConvergenceTexels = 64, kAmplitudeTexels = 64;

std::string WeightingText(const SampleOptions& sampling) {
    switch (sampling.weighting) {
        case Weighting::kUnweighted:
            return "every bin the same";
        case Weighting::kPopulation:
            return "by population, every map the same";
        case Weighting::kPopulationOverVariance:
            break;
    }
    return "by population over variance, every map the same";
}

}  // namespace

void Validate(const FitSettings& settings) {
    if (settings.simulate.bounces < 1) {
        throw Error(MustBe("bounces", settings.simulate.bounces,
                           "in [1, 1000]: the curve of the first bounce is fitted"));
    }
    if (settings.starts < 1) throw Error(MustBe("starts", settings.starts, ">= 1"));
    const int replicates = settings.bootstrap_replicates;
    if (replicates != 0 && replicates < kFewestReplicates) {
        throw Error(MustBe("bootstrap_replicates", replicates,
                           "0 or at least " + std::to_string(kFewestReplicates) +
                               ": fewer say nothing of a spread"));
    }
}

FitConstantsResult FitConstants(std::span<const Surface> surfaces, const FitSettings& settings,
                                const RunContext& run) {
    if (surfaces.empty()) throw Error("fit: no height map given");
    Validate(settings);
    FitConstantsResult result;
    FitReport& report = result.report;
    report.provenance.tool_version = run.version;
    report.provenance.command = run.command;
    report.provenance.sampling = SamplingOf(settings.simulate);
    report.provenance.bounces = settings.simulate.bounces;
    report.provenance.bins = settings.simulate.bins;
    report.provenance.albedos = settings.simulate.albedos;
    report.provenance.weighting = WeightingText({.weighting = settings.weighting});

    std::vector<SurfaceLight> lights;
    for (const Surface& surface : surfaces) {
        lights.push_back(SimulateSurface(surface.source.name, surface.field, settings.simulate,
                                         run.monitor, &report.timings, run.clock));
        report.provenance.maps.push_back(surface.source);
        const SurfaceLight& light = lights.back();
        report.maps.push_back(
            {light.name, "", "", light.over_alpha, light.over_V, light.figures});
    }
    if (std::all_of(lights.begin(), lights.end(),
                    [](const SurfaceLight& light) { return light.links == 0; })) {
        throw Error(
            "fit: every map is flat or convex, alpha = V = 1 everywhere: no light bounces "
            "and there is nothing to fit");
    }

    for (const SurfaceLight& light : lights) result.V.push_back(light.V);

    const double fits_begin_s = run.clock();
    FitTotals(lights, settings, report, run.monitor);
    report.timings.push_back({"all maps", "fits", run.clock() - fits_begin_s});

    report.recommended = std::string(EscapeOfAlphaAndV::kName) + ", refitted";
    report.recommended_text = std::string(EscapeOfAlphaAndV::kText);
    report.published = std::string(MayauxTotalModel<PoleGuard::kPort>::kName);
    report.printed = std::string(MayauxTotalModel<PoleGuard::kNone>::kName);

    const Surface& first = surfaces.front();
    if (settings.study_convergence) {
        report.convergence = StudyConvergence(
            NameOfMiddle(first.source.name, first.field, kConvergenceTexels),
            MiddleOf(first.field, kConvergenceTexels), {}, run.clock, run.monitor);
    }
    if (settings.study_amplitude && first.field.HighestM() > first.field.LowestM()) {
        SimulateSettings brief = settings.simulate;
        brief.check_furnace = false;
        const Formula recommended = RecordNamed(report, report.recommended).formula;
        const Formula published = RecordNamed(report, report.published).formula;
        report.amplitudes =
            StudyAmplitude(NameOfMiddle(first.source.name, first.field, kAmplitudeTexels),
                           MiddleOf(first.field, kAmplitudeTexels), SweptAmplitudes(), brief,
                           &recommended, &published, run.monitor);
    }
    return result;
}

}  // namespace plumb
