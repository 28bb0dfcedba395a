#include "jobs/light/fit_constants.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/error.h"
#include "fit/baselines.h"
#include "fit/bootstrap.h"
#include "fit/contender.h"
#include "fit/escape_bent.h"
#include "fit/escape_family.h"
#include "fit/escape_forms.h"
#include "fit/escape_of_both.h"
#include "fit/leave_one_out.h"
#include "fit/mayaux_faults.h"
#include "fit/mayaux_refit.h"
#include "fit/model_fit.h"
#include "jobs/light/amplitude_study.h"
#include "jobs/light/convergence_study.h"
#include "jobs/light/curves.h"
#include "jobs/light/facet_scores.h"
#include "jobs/light/histograms.h"

namespace plumb {
namespace {

// The pieces that the studies of one map work on: large enough for all bins to be met.
constexpr int kConvergenceTexels = 64, kAmplitudeTexels = 64;

// Fits of a fold start where theory starts them, and from one more point.
constexpr int kFoldStarts = 2;

using Maps = std::span<const BounceHistogram>;

// The maps over alpha, over V and over both, made once.
struct AllMaps {
    std::array<std::vector<BounceHistogram>, 3> by;
    Maps operator[](BinnedBy binned_by) const { return by[std::size_t(binned_by)]; }
};

// A formula on its way into the table, and how it is learnt again when a map is held out.
struct Entry {
    FormulaRecord record;
    Contender contender;
};

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

class Fitter {
  public:
    Fitter(std::span<const SurfaceLight> lights, const FitSettings& settings, Monitor& monitor)
        : lights_(lights), settings_(settings), monitor_(monitor) {
        for (const BinnedBy by : {BinnedBy::kUniformVisibility, BinnedBy::kCosineVisibility,
                                  BinnedBy::kBothVisibilities}) {
            maps_.by[std::size_t(by)] = HistogramsBy(by, lights);
        }
        sampling_.weighting = settings.weighting;
        options_.starts = settings.starts;
        fold_options_.starts = kFoldStarts;
    }

    void Into(FitReport& report) {
        FitCurves(
            [this](int k) {
                return BounceSamples(maps_[BinnedBy::kUniformVisibility], k, sampling_);
            },
            settings_.simulate.bounces, options_, report);
        monitor_.Progress("fits", 0.2);
        Baselines();
        RefittedPaper(report);
        RefittedTotal(ModelOf<EscapeOfAlphaClamped>(), report);
        RefittedTotal(ModelOf<EscapeOfV>(), report);
        RefittedTotal(ModelOf<EscapeBentOfV>(), report);
        RefittedTotal(ModelOf<EscapeOfBoth>(), report);
        if (settings_.compare_forms) {
            for (const std::string_view form :
                 {EscapeLinearOfV::kName, TwoEscapesLinearOfV::kName, EscapePowerOfAlpha::kName,
                  EscapeOfClosures::kName, EscapeScaledOfBoth::kName, EscapeRaisedOfBoth::kName,
                  TwoEscapesOfBoth::kName}) {
                RefittedTotal(FindModel(form), report);
            }
        }
        monitor_.Progress("fits", 0.6);
        HoldOut();
        monitor_.Progress("fits", 1);
        for (Entry& entry : entries_) {
            for (const SurfaceLight& light : lights_) {
                entry.record.facet_rms.push_back(FacetRms(entry.record.formula, light));
            }
            report.formulas.push_back(std::move(entry.record));
        }
        for (const SurfaceLight& light : lights_) report.floors.push_back(FloorsOf(light));
    }

  private:
    Maps MapsFor(const Model& model) const { return maps_[BinningFor(model.inputs)]; }

    void Baselines() {
        for (Formula& formula : plumb::Baselines()) {
            FormulaRecord record;
            record.name = formula.name;
            record.formula = formula;
            record.in_sample = ScoreOver(formula, MapsFor(formula.model));
            record.plotted = formula.model.name == "cavity";
            entries_.push_back({std::move(record), Unfitted(std::move(formula))});
        }
    }

    void RefittedPaper(FitReport& report) {
        const MayauxConstants<> constants =
            RefitMayaux(maps_[BinnedBy::kUniformVisibility], sampling_, options_).Constants();
        const Contender contender =
            RefittedAsPublished(PoleGuard::kPort, sampling_, fold_options_);
        FormulaRecord record;
        record.name = contender.name;
        record.formula = MayauxFormula(constants, PoleGuard::kPort, contender.name);
        record.fitted = true;
        record.in_sample = ScoreOver(record.formula, maps_[BinnedBy::kUniformVisibility]);
        entries_.push_back({std::move(record), contender});
        report.faults.push_back(FaultsOf("published", kMayaux18));
        report.faults.push_back(FaultsOf("refitted", constants));
    }

    void RefittedTotal(const Model& model, FitReport& report) {
        const Maps maps = MapsFor(model);
        const std::vector<Sample> samples = TotalSamples(maps, sampling_);
        const Contender contender = Refitted(model, sampling_, fold_options_);
        TotalFit total;
        total.formula = contender.name;
        total.fit = FitModel(model, samples, options_);
        if (settings_.bootstrap_replicates > 0 && maps.size() > 1) {
            total.bootstrap = BootstrapOverMaps(model, samples,
                                                {.replicates = settings_.bootstrap_replicates},
                                                {.starts = 1}, monitor_);
        }
        FormulaRecord record;
        record.name = contender.name;
        record.formula = Fitted(model, total.fit, contender.name);
        record.fitted = true;
        record.in_sample = ScoreOver(record.formula, maps);
        record.plotted = true;
        report.totals.push_back(std::move(total));
        entries_.push_back({std::move(record), contender});
    }

    // One pass a histogram: contenders of one pass learn from the same maps.
    void HoldOut() {
        if (lights_.size() < 2) return;
        for (const BinnedBy by : {BinnedBy::kUniformVisibility, BinnedBy::kCosineVisibility,
                                  BinnedBy::kBothVisibilities}) {
            std::vector<Contender> contenders;
            std::vector<Entry*> whose;
            for (Entry& entry : entries_) {
                if (BinningFor(entry.record.formula.model.inputs) != by) continue;
                contenders.push_back(entry.contender);
                whose.push_back(&entry);
            }
            const std::vector<HeldOut> held_out =
                LeaveOneMapOut(maps_[by], contenders, monitor_);
            for (std::size_t k = 0; k < whose.size(); ++k) {
                whose[k]->record.held_out = held_out[k].scores;
            }
        }
    }

    static FormulaFaults FaultsOf(std::string name, const MayauxConstants<>& constants) {
        FormulaFaults faults;
        faults.name = std::move(name);
        for (const double rho : ScoredAlbedos()) {
            faults.poles.push_back({Albedo(rho), PolesOf(constants, Albedo(rho))});
        }
        faults.above_one = DirectFactorAboveOne(constants.F0);
        faults.above_bound = DirectFactorAboveBound(constants.F0);
        faults.below_bound = DirectFactorBelowBound(constants.F0);
        return faults;
    }

    std::span<const SurfaceLight> lights_;
    const FitSettings& settings_;
    Monitor& monitor_;
    AllMaps maps_;
    SampleOptions sampling_;
    LeastSquaresOptions options_, fold_options_;
    std::vector<Entry> entries_;
};

const FormulaRecord& RecordNamed(const FitReport& report, const std::string& name) {
    return *std::find_if(report.formulas.begin(), report.formulas.end(),
                         [&](const FormulaRecord& record) { return record.name == name; });
}

ShaderFormula ShaderFormulaOf(const FormulaRecord& record, std::string function,
                              std::string comment) {
    ShaderFormula shader;
    shader.formula = record.formula;
    shader.function = std::move(function);
    shader.comment = std::move(comment);
    shader.rms = record.in_sample.pooled.rms;
    if (record.held_out) shader.held_out_rms = record.held_out->pooled.rms;
    return shader;
}

std::string RefittedName(std::string_view model) {
    return std::string(model) + ", refitted";
}

}  // namespace

FitConstantsResult FitConstants(std::span<const Surface> surfaces, const FitSettings& settings,
                                const std::string& tool_version, const std::string& command,
                                const Clock& clock, Monitor& monitor) {
    if (surfaces.empty()) throw Error("fit: no height map given");
    FitConstantsResult result;
    FitReport& report = result.report;
    report.provenance.tool_version = tool_version;
    report.provenance.command = command;
    report.provenance.sampling = SamplingOf(settings.simulate);
    report.provenance.bounces = settings.simulate.bounces;
    report.provenance.bins = settings.simulate.bins;
    report.provenance.albedos = settings.simulate.albedos;
    report.provenance.weighting = WeightingText({.weighting = settings.weighting});

    std::vector<SurfaceLight> lights;
    for (const Surface& surface : surfaces) {
        lights.push_back(SimulateSurface(surface.source.name, surface.field, settings.simulate,
                                         monitor, &report.timings, clock));
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

    const double fits_begin_s = clock();
    Fitter(lights, settings, monitor).Into(report);
    report.timings.stages.push_back({"all maps", "fits", clock() - fits_begin_s});

    report.recommended = RefittedName(EscapeOfBoth::kName);
    report.recommended_text = std::string(EscapeOfBoth::kText);
    report.published = std::string(MayauxTotalModel<PoleGuard::kPort>::kName);

    const Surface& first = surfaces.front();
    if (settings.study_convergence) {
        report.convergence = StudyConvergence(
            first.source.name, MiddleOf(first.field, kConvergenceTexels), {}, clock, monitor);
    }
    if (settings.study_amplitude && first.field.HighestM() > first.field.LowestM()) {
        SimulateSettings brief = settings.simulate;
        brief.check_furnace = false;
        const Formula recommended = RecordNamed(report, report.recommended).formula;
        const Formula published = RecordNamed(report, report.published).formula;
        report.amplitudes =
            StudyAmplitude(first.source.name, MiddleOf(first.field, kAmplitudeTexels),
                           SweptAmplitudes(), brief, &recommended, &published, monitor);
    }
    return result;
}

ShaderHeader ShaderHeaderOf(const FitReport& report) {
    ShaderHeader header;
    header.provenance = report.provenance;
    header.recommended = ShaderFormulaOf(
        RecordNamed(report, report.recommended), "PlumbTotal",
        "From both visibilities: the least error on maps that it has not seen.");
    header.alternatives = {
        ShaderFormulaOf(RecordNamed(report, RefittedName(EscapeBentOfV::kName)),
                        "PlumbTotalOfV", "From cosine visibility alone, bent."),
        ShaderFormulaOf(RecordNamed(report, RefittedName(EscapeOfV::kName)), "PlumbEscapeOfV",
                        "From cosine visibility alone, a power law."),
        ShaderFormulaOf(RecordNamed(report, RefittedName(EscapeOfAlphaClamped::kName)),
                        "PlumbEscapeOfAlpha", "From uniform visibility alone."),
    };
    for (const FormulaRecord& record : report.formulas) {
        if (record.fitted && record.name.starts_with("Mayaux18")) {
            header.alternatives.push_back(ShaderFormulaOf(
                record, "PlumbMayaux18Refitted",
                "The paper's formula with refitted constants, guarded: for comparison."));
        }
    }
    header.published_rms = RecordNamed(report, report.published).in_sample.pooled.rms;
    return header;
}

}  // namespace plumb
