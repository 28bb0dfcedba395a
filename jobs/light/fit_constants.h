// Job 1: height maps in, refitted constants out.
//
//       surfaces -> light -> histograms -> curves F0, F1, E_k; totals E(rho)
//                -> held-out scores, bootstrap, floors -> report and shader headers
//
// Source   [Mayaux18], whole; the models of ours are in fit/.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/run_context.h"
#include "fit/samples.h"
#include "jobs/light/simulate_surface.h"
#include "jobs/light/surface.h"
#include "reports/fit_report.h"
#include "reports/shader_header.h"

namespace plumb {

struct FitSettings {
    SimulateSettings simulate;
    Weighting weighting = Weighting::kPopulation;
    int starts = 8;                 ///< Of every fit to all maps. [1, ...)
    int bootstrap_replicates = 50;  ///< Needs two maps. 0 = none, or [10, ...)
    bool compare_forms = false;  ///< Also fits the forms of fit/models/escape_alternatives.h.
    bool study_convergence = true;  ///< On the middle of the first map.
    bool study_amplitude = true;    ///< On the middle of the first map.
};

/// Fewer say little of a spread: the standard error of n is itself known to 1 / sqrt(2 (n - 1)), that
/// of ten to a quarter.
inline constexpr int kFewestReplicates = 10;

/// Throws Error, naming field, value and rule: before the light is simulated.
void Validate(const FitSettings& settings);

struct FitConstantsResult {
    FitReport report;                    ///< Everything but the pictures.
    std::vector<std::vector<double>> V;  ///< Of every facet of every map, for pictures.
};

/// With one map nothing can be held out, and the report says so by leaving it
/// empty. Throws Error if there is no map, or if no map has anything to fit (all of them flat).
FitConstantsResult FitConstants(std::span<const Surface> surfaces, const FitSettings& settings,
                                const RunContext& run);

/// The headers that follow from a report: the recommended formula and its alternatives.
ShaderHeader ShaderHeaderOf(const FitReport& report);

}  // namespace plumb
