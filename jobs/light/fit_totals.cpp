#include "jobs/light/fit_totals.h"

#include <array>
#include <utility>

#include "fit/baselines.h"
#include "fit/bootstrap.h"
#include "fit/fitting_method.h"
#include "fit/leave_one_out.h"
#include "fit/mayaux_faults.h"
#include "fit/mayaux_refit.h"
#include "fit/model_fit.h"
#include "jobs/light/curves.h"
#include "jobs/light/facet_scores.h"
#include "jobs/light/form_choice.h"
#include "jobs/light/histograms.h"

namespace plumb {
namespace {

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
    FittingMethod method;
};

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
        RefittedTotals(ModelUse::kRefitted, report);
        if (settings_.compare_forms) RefittedTotals(ModelUse::kForm, report);
        monitor_.Progress("fits", 0.6);
        HoldOut();
        monitor_.Progress("fits", 0.8);
        report.choice =
            ChooseForm(lights_, ComparedForms(), sampling_, fold_options_, monitor_);
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
        const FittingMethod method =
            RefittedAsPublished(PoleGuard::kPort, sampling_, fold_options_);
        FormulaRecord record;
        record.name = method.name;
        record.formula = MayauxFormula(constants, PoleGuard::kPort, method.name);
        record.fitted = true;
        record.in_sample = ScoreOver(record.formula, maps_[BinnedBy::kUniformVisibility]);
        entries_.push_back({std::move(record), method});
        report.faults.push_back(FaultsOf("published", kMayaux18));
        report.faults.push_back(FaultsOf("refitted", constants));
    }

    void RefittedTotals(ModelUse use, FitReport& report) {
        for (const Model& model : AllModels()) {
            if (model.use == use) RefittedTotal(model, report);
        }
    }

    void RefittedTotal(const Model& model, FitReport& report) {
        const Maps maps = MapsFor(model);
        const std::vector<Sample> samples = TotalSamples(maps, sampling_);
        const FittingMethod method = Refitted(model, sampling_, fold_options_);
        TotalFit total;
        total.formula = method.name;
        total.fit = FitModel(model, samples, options_);
        if (settings_.bootstrap_replicates > 0 && maps.size() > 1) {
            total.bootstrap = BootstrapOverMaps(model, samples,
                                                {.replicates = settings_.bootstrap_replicates},
                                                {.starts = 1}, monitor_);
        }
        FormulaRecord record;
        record.name = method.name;
        record.formula = Fitted(model, total.fit, method.name);
        record.fitted = true;
        record.in_sample = ScoreOver(record.formula, maps);
        record.plotted = true;
        report.totals.push_back(std::move(total));
        entries_.push_back({std::move(record), method});
    }

    // One pass a histogram: methods of one pass learn from the same maps.
    void HoldOut() {
        if (lights_.size() < 2) return;
        for (const BinnedBy by : {BinnedBy::kUniformVisibility, BinnedBy::kCosineVisibility,
                                  BinnedBy::kBothVisibilities}) {
            std::vector<FittingMethod> methods;
            std::vector<Entry*> whose;
            for (Entry& entry : entries_) {
                if (BinningFor(entry.record.formula.model.inputs) != by) continue;
                methods.push_back(entry.method);
                whose.push_back(&entry);
            }
            const std::vector<HeldOut> held_out = LeaveOneMapOut(maps_[by], methods, monitor_);
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

}  // namespace

void FitTotals(std::span<const SurfaceLight> lights, const FitSettings& settings,
               FitReport& report, Monitor& monitor) {
    Fitter(lights, settings, monitor).Into(report);
}

}  // namespace plumb
