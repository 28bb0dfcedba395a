#include "made_report.h"

#include <cmath>

#include "fit/models/direct_factor.h"
#include "fit/models/escape_probability.h"
#include "fit/models/first_bounce.h"
#include "fit/models/mayaux_total.h"
#include "fit/models/uniform_cavity.h"

namespace plumb::made {
namespace {

/// An infinite wedge for each bin: V = alpha^2 (3 - 2 alpha) is close enough to it, and
/// E_k = V (1 - V)^k is its series.
/// `number` of the surface: no two histograms hold the same means.
BounceHistogram MakeHistogram(const std::string& surface, BinnedBy binned_by, int number) {
    const double shift = 0.01 * number + (binned_by == BinnedBy::kCosineVisibility ? 0.02 : 0);
    BounceHistogram histogram{
        .surface = surface, .binned_by = binned_by, .albedos = {0, 0.5, 1}, .bins = {}};
    for (int b = 0; b < 4; ++b) {
        BounceBin bin;
        bin.low = b / 4.0;
        bin.high = (b + 1) / 4.0;
        bin.bounce.resize(4);
        bin.total.resize(3);
        if (b != 1) {
            bin.count = (10 + 3 * number * b) * (b + 1);
            bin.alpha = bin.low + 0.1 + shift;
            bin.V = bin.alpha * bin.alpha * (3 - 2 * bin.alpha);
            for (int k = 0; k < 4; ++k) {
                const double mean = bin.V * std::pow(1 - bin.V, k);
                bin.bounce[std::size_t(k)] = {mean, 1e-4 * (k + 1), mean - 0.02, mean + 0.001,
                                              mean + 0.02};
            }
            for (std::size_t r = 0; r < 3; ++r) {
                const double mean =
                    CavityTotal(CosineVisibility(bin.V), Albedo(histogram.albedos[r]));
                bin.total[r] = {mean, 1e-4 * double(r + 6), mean - 0.02, mean + 0.002,
                                mean + 0.02};
            }
        }
        histogram.bins.push_back(std::move(bin));
    }
    return histogram;
}

SurfaceReport MakeSurface(const std::string& name, int number) {
    SurfaceReport surface;
    surface.name = name;
    surface.heights_picture = "data:image/png;base64,iVBORw0KGgo=";
    surface.over_alpha = MakeHistogram(name, BinnedBy::kUniformVisibility, number);
    surface.over_V = MakeHistogram(name, BinnedBy::kCosineVisibility, number);
    return surface;
}

MapSource MakeSource(const std::string& name) {
    return {.name = name,
            .file = "x.png",
            .sha256 = std::string(64, 'a'),
            .width_texels = 8,
            .height_texels = 4,
            .spacing_x_m = 0.125,
            .spacing_y_m = 0.1,  // Not a sum of powers of two: its digits must survive.
            .amplitude_m = 0.15,
            .boundary = "wrap",
            .preparation = "",
            .source = "by hand",
            .licence = "public domain"};
}

LeastSquaresFit MakeFit(const Model& model, double scale) {
    LeastSquaresFit fit;
    for (const Parameter& parameter : model.parameters)
        fit.parameters.push_back({.name = std::string(parameter.name),
                                  .value = scale * parameter.initial,
                                  .standard_error = 0.01 * parameter.initial,
                                  .at_bound = false});
    const auto n = Eigen::Index(model.parameters.size());
    fit.correlation = Eigen::MatrixXd::Identity(n, n);
    if (n > 1) fit.correlation(0, 1) = fit.correlation(1, 0) = -0.75;
    fit.condition = 12 + double(n);
    fit.rmse = 0.0125 + 1e-3 * double(n) + 1e-4 * scale;
    fit.max_abs = 0.05 + 1e-2 * double(n);
    fit.samples = 18;
    fit.converged = true;
    fit.starts = 4;
    fit.starts_agreeing = 3;
    fit.termination = "by hand";
    return fit;
}

Formula Scaled(const Model& model, double scale, const std::string& name) {
    Formula formula = AtInitialValues(model, name);
    for (double& value : formula.values) value *= scale;
    return formula;
}

ScoreRow MakeRow(const std::string& name, double rms) {
    const Score one{
        .rms = rms, .max_abs = 3 * rms, .samples = 9, .poles = 0, .out_of_range = 0};
    const Score two{
        .rms = 1.1 * rms, .max_abs = 2.6 * rms, .samples = 8, .poles = 1, .out_of_range = 2};
    const Score all{
        .rms = rms, .max_abs = 3 * rms, .samples = 17, .poles = 1, .out_of_range = 2};
    return {.formula = name, .maps = {one, two}, .pooled = all};
}

FormulaRecord MakeRecord(const Formula& formula, bool fitted, double rms) {
    FormulaRecord record;
    record.name = formula.name;
    record.formula = formula;
    record.fitted = fitted;
    record.in_sample = MakeRow(formula.name, rms);
    if (fitted) record.held_out = MakeRow(formula.name, 1.25 * rms);
    record.facet_rms = {1.5 * rms, 1.75 * rms};
    return record;
}

CurveFit MakeCurve(const Model& model, const std::string& title, int bounce, bool published) {
    CurveFit curve;
    curve.title = title;
    curve.bounce = bounce;
    curve.fit = MakeFit(model, 1.1);
    curve.fitted = Scaled(model, 1.1, title);
    if (published) {
        curve.published = AtInitialValues(model, "published");
        curve.published_score = Score{.rms = 0.0625, .max_abs = 0.1, .samples = 18};
    }
    return curve;
}

}  // namespace

FitReport MakeFitReport() {
    FitReport report;
    report.provenance.tool_version = "1.2.3";
    report.provenance.command = "plumb fit x.png y.png --seed 7";
    report.provenance.maps = {MakeSource(kHostileName), MakeSource("plain")};
    report.provenance.sampling = {"slices", 32, 7, 1.5, 8};
    report.provenance.bounces = 3;
    report.provenance.bins = 4;
    report.provenance.albedos = {0, 0.5, 1};
    report.provenance.weighting = "population";
    report.maps = {MakeSurface(kHostileName, 0), MakeSurface("plain", 1)};
    SurfaceFigures& figures = report.maps[0].figures;
    figures.facets = 64;
    figures.mean_alpha = 0.7;
    figures.mean_V = 0.1 + 0.2;  // 0.30000000000000004: seventeen digits.
    figures.max_furnace_error = 1e-6;
    figures.aperture = Measured{.value = 1.0005, .standard_error = 0.0002};

    report.curves = {
        MakeCurve(ModelOf<DirectFactorModel>(), "F0", 0, true),
        MakeCurve(ModelOf<FirstBounceModel>(), "F1", 1, true),
        MakeCurve(ModelOf<FreeFirstBounceModel>(), "F1, free exponents", 1, false)};
    for (int k = 1; k <= 3; ++k)
        report.bounce_family.push_back(
            MakeCurve(ModelOf<BounceCurveModel>(), "E_" + std::to_string(k), k, false));

    const Model& escape = ModelOf<EscapeOfV>();
    BootstrapResult bootstrap;
    bootstrap.parameters = {{"a", 0.1, 0.8, 1.2}, {"b", 0.05, 0.3, 0.6}};
    bootstrap.replicates = 100;
    report.totals = {
        {.formula = "escape of V", .fit = MakeFit(escape, 1), .bootstrap = bootstrap}};
    report.formulas = {
        MakeRecord(AtInitialValues(escape, "escape of V"), true, 0.008),
        MakeRecord(AtInitialValues(ModelOf<MayauxTotalModel<PoleGuard::kNone>>(), "Mayaux18"),
                   false, 0.04),
        MakeRecord(AtInitialValues(ModelOf<UniformCavityModel>(), "cavity"), false, 0.016)};
    report.floors = {{0.03, 0.006, 0.005}, {0.031, 0.0062, 0.0051}};
    report.faults = {
        {.name = "published",
         .poles = {{Albedo(0.5), {UniformVisibility(0.970264)}}},
         .above_one =
             {{.low = 0.949253, .high = 1, .worst_alpha = 0.983, .worst_excess = 0.006}},
         .above_bound = {},
         .below_bound = {}}};
    report.recommended = "escape of V";
    report.recommended_text = "g = clamp(a V^b, 0, 1)";
    report.published = "Mayaux18";

    AmplitudePoint point;
    point.amplitude_m = 0.1;
    point.amplitude_of_width = 0.1;
    point.figures = figures;
    point.over_alpha = report.maps[0].over_alpha;
    AmplitudePoint deeper = point;
    deeper.amplitude_m = 0.3;
    deeper.amplitude_of_width = 0.32;
    report.amplitudes = AmplitudeSweep{.map = kHostileName, .points = {point, deeper}};
    report.convergence =
        Convergence{.map = "plain",
                    .reference = "slices, 2048 a facet",
                    .facets = 64,
                    .threads = 2,
                    .points = {{"rays", 256, {.value = 1}, 0.02, 0.017, 0.1},
                               {"rays", 1024, {.value = 4}, 0.01, 0.009, 0.05},
                               {"slices", 8, {.value = 0.25}, 0.02, 0.018, 0.12},
                               {"slices", 32, {.value = 1}, 0.005, 0.004, 0.03}}};
    return report;
}

SimulateReport MakeSimulateReport() {
    const FitReport fit = MakeFitReport();
    SimulateReport report{.provenance = fit.provenance,
                          .surface = fit.maps[0],
                          .amplitudes = fit.amplitudes,
                          .timings = {}};
    report.provenance.maps.resize(1);
    return report;
}

}  // namespace plumb::made
