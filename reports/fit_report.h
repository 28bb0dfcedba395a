// What a fit says.
//
// Pure: the same input gives the same document. Plots on a page carry six digits, JSON and CSV all.
//
// Source   the plots are those of [Mayaux18], with the published constants beside ours on the
//          same data.
// Symbols  alpha, V, E_k, E(rho) as in core/conventions.h; F0, F1 as in fit/models/direct_factor.h and
//          fit/models/first_bounce.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/visibility.h"
#include "fit/bootstrap.h"
#include "fit/least_squares.h"
#include "fit/mayaux_faults.h"
#include "fit/model.h"
#include "fit/scores.h"
#include "reports/amplitude_sweep.h"
#include "reports/convergence.h"
#include "reports/document.h"
#include "reports/form_choice.h"
#include "reports/provenance.h"
#include "reports/surface_report.h"
#include "reports/timings.h"

namespace plumb {

/// A curve over alpha, fitted to one bounce of all maps.
struct CurveFit {
    std::string title;  ///< "F0", "F1", "F1, free exponents", "E_7".
    int bounce = 0;     ///< k of the E_k that it was fitted to.
    LeastSquaresFit fit;
    Formula fitted;

    std::optional<Formula> published;      ///< The same curve with the published constants ...
    std::optional<Score> published_score;  ///< ... and its score on the samples of the fit.
};

/// A total E(rho), fitted to all maps.
struct TotalFit {
    std::string formula;  ///< FormulaRecord::name of the result.
    LeastSquaresFit fit;
    std::optional<BootstrapResult> bootstrap;
};

/// One row of the score table: a formula, fitted or not, and its record.
struct FormulaRecord {
    std::string name;
    Formula formula;      ///< With the constants of the fit to all maps.
    bool fitted = false;  ///< Its constants were fitted to these maps.

    ScoreRow in_sample;                ///< Scored on the maps, one element a map.
    std::optional<ScoreRow> held_out;  ///< Each map scored by constants that never saw it.
    std::vector<double> facet_rms;     ///< Per map: of E(rho) facet by facet, all albedos.

    /// Drawn in the plots of E(rho). The recommended and the published formula always are.
    bool plotted = false;
};

/// Per map: the facet RMS that no function of the named input can go below.
struct Floors {
    double of_alpha = SurfaceFigures::kUnknown;
    double of_V = SurfaceFigures::kUnknown;
    double of_both = SurfaceFigures::kUnknown;
};

/// Where a set of constants breaks [Mayaux18 eq. 12].
struct FormulaFaults {
    struct Pole {
        Albedo rho;
        std::vector<UniformVisibility> alphas;
    };

    std::string name;  ///< "published", "refitted".
    std::vector<Pole> poles;
    std::vector<BrokenInterval> above_one;    ///< F0 > 1.
    std::vector<BrokenInterval> above_bound;  ///< F0 > alpha (2 - alpha).
    std::vector<BrokenInterval> below_bound;  ///< F0 < alpha^2.
};

struct FitReport {
    Provenance provenance;
    std::vector<SurfaceReport> maps;

    std::vector<CurveFit> curves;         ///< F0 and F1, in every variant.
    std::vector<CurveFit> bounce_family;  ///< E_1, E_2, ...
    std::vector<TotalFit> totals;
    std::vector<FormulaRecord> formulas;  ///< The score table, in the order shown.
    std::vector<Floors> floors;           ///< One a map, or none.
    std::vector<FormulaFaults> faults;

    std::string recommended;       ///< FormulaRecord::name.
    std::string recommended_text;  ///< Its formula in plain text, one or more lines.
    std::string published;  ///< FormulaRecord::name of the formula that is in use, guarded.
    std::string
        printed;  ///< The same as printed, without a guard; empty = `published` has none.
    std::optional<FormChoice> choice;  ///< Of four maps or more.

    std::optional<AmplitudeSweep> amplitudes;
    std::optional<Convergence> convergence;
    Timings timings;
};

/// Throws Error, naming the field, if the parts disagree: published constants of a curve of
/// another number than the fitted ones; and, unless the report is of curves alone (no map and
/// no formula), provenance, scores or floors of another number of maps, a recommended or
/// published name that is no record, a total fit of no record.
void Validate(const FitReport& report);

/// The record of that name: one that Validate() made sure of.
const FormulaRecord& RecordNamed(const FitReport& report, const std::string& name);

/// All of it, or of a report of curves alone its constants. Tables that files are made of:
/// "scores" (scores.csv: one row a formula and map, and one with the map "all") and "forms"
/// (choice.csv).
doc::Document DocumentOf(const FitReport& report);

/// Of every fit, one row a constant (constants.csv).
doc::Table ConstantsTable(const FitReport& report);

}  // namespace plumb
