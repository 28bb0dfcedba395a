// The whole fit report as JSON, and the check that its parts belong together.
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/error.h"
#include "reports/fit_caveats.h"
#include "reports/fit_report.h"
#include "reports/json_text.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

Json FormulaJson(const Formula& formula) {
    Json constants = Json::object();
    for (std::size_t j = 0; j < formula.values.size(); ++j)
        constants[std::string(formula.model.parameters[j].name)] = formula.values[j];
    Json inputs = Json::array();
    if (formula.model.inputs.alpha) inputs.push_back("uniform_visibility");
    if (formula.model.inputs.V) inputs.push_back("cosine_visibility");
    if (formula.model.inputs.rho) inputs.push_back("albedo");
    return {{"model", formula.model.name}, {"inputs", inputs}, {"constants", constants}};
}

Json ScoreJson(const Score& score) {
    return {{"rms", score.rms},
            {"max_abs", score.max_abs},
            {"samples", score.samples},
            {"poles", score.poles},
            {"out_of_range", score.out_of_range}};
}

Json RowJson(const ScoreRow& row) {
    Json maps = Json::array();
    for (const Score& score : row.maps) maps.push_back(ScoreJson(score));
    return {{"all", ScoreJson(row.pooled)}, {"maps", maps}};
}

Json FitJson(const LeastSquaresFit& fit) {
    Json parameters = Json::array();
    for (const FittedParameter& parameter : fit.parameters)
        parameters.push_back(
            {{"name", parameter.name},
             {"value", parameter.value},
             {"standard_error",
              parameter.standard_error ? Json(*parameter.standard_error) : Json(nullptr)},
             {"at_bound", parameter.at_bound}});
    Json correlation = Json::array();
    for (Eigen::Index i = 0; i < fit.correlation.rows(); ++i) {
        Json row = Json::array();
        for (Eigen::Index j = 0; j < fit.correlation.cols(); ++j)
            row.push_back(fit.correlation(i, j));
        correlation.push_back(std::move(row));
    }
    return {{"parameters", parameters},
            {"correlation", correlation},
            {"condition", fit.condition},
            {"condition_unscaled", fit.condition_unscaled},
            {"rms", fit.rmse},
            {"max_abs", fit.max_abs},
            {"chi2_per_dof", fit.chi2_per_dof},
            {"samples", fit.samples},
            {"converged", fit.converged},
            {"iterations", fit.iterations},
            {"starts", fit.starts},
            {"starts_agreeing", fit.starts_agreeing},
            {"termination", fit.termination}};
}

Json CurvesJson(const std::vector<CurveFit>& curves) {
    Json list = Json::array();
    for (const CurveFit& curve : curves) {
        Json json{{"title", curve.title},
                  {"bounce", curve.bounce},
                  {"formula", FormulaJson(curve.fitted)},
                  {"fit", FitJson(curve.fit)}};
        if (curve.published) json["published"] = FormulaJson(*curve.published);
        if (curve.published_score) json["published_score"] = ScoreJson(*curve.published_score);
        list.push_back(std::move(json));
    }
    return list;
}

Json TotalsJson(const std::vector<TotalFit>& totals) {
    Json list = Json::array();
    for (const TotalFit& total : totals) {
        Json json{{"formula", total.formula}, {"fit", FitJson(total.fit)}};
        if (total.bootstrap) {
            Json intervals = Json::array();
            for (const BootstrapInterval& interval : total.bootstrap->parameters)
                intervals.push_back({{"name", interval.name},
                                     {"standard_error", interval.standard_error},
                                     {"low", interval.low},
                                     {"high", interval.high}});
            json["bootstrap_over_maps"] = {{"replicates", total.bootstrap->replicates},
                                           {"failed", total.bootstrap->failed},
                                           {"parameters", intervals}};
        }
        list.push_back(std::move(json));
    }
    return list;
}

Json RecordsJson(const FitReport& report) {
    Json list = Json::array();
    for (const FormulaRecord& record : report.formulas) {
        Json json{{"name", record.name},
                  {"formula", FormulaJson(record.formula)},
                  {"fitted", record.fitted},
                  {"in_sample", RowJson(record.in_sample)},
                  {"held_out", record.held_out ? RowJson(*record.held_out) : Json(nullptr)},
                  {"facet_rms", record.facet_rms},
                  {"caveats", CaveatsOf(report, record)}};
        list.push_back(std::move(json));
    }
    return list;
}

Json IntervalsJson(const std::vector<BrokenInterval>& intervals) {
    Json list = Json::array();
    for (const BrokenInterval& interval : intervals)
        list.push_back({{"low", interval.low},
                        {"high", interval.high},
                        {"worst_at", interval.worst_alpha},
                        {"worst_excess", interval.worst_excess}});
    return list;
}

Json FaultsJson(const std::vector<FormulaFaults>& faults) {
    Json list = Json::array();
    for (const FormulaFaults& fault : faults) {
        Json poles = Json::array();
        for (const FormulaFaults::Pole& pole : fault.poles) {
            Json at = Json::array();
            for (const UniformVisibility& alpha : pole.alphas) at.push_back(alpha.value);
            poles.push_back({{"albedo", pole.rho.value}, {"uniform_visibilities", at}});
        }
        list.push_back({{"constants", fault.name},
                        {"poles", poles},
                        {"direct_factor_above_one", IntervalsJson(fault.above_one)},
                        {"direct_factor_above_bound", IntervalsJson(fault.above_bound)},
                        {"direct_factor_below_bound", IntervalsJson(fault.below_bound)}});
    }
    return list;
}

void MustHave(const std::string& field, std::size_t size, std::size_t maps) {
    if (size != maps)
        throw Error("FitReport::" + field + " has " + std::to_string(size) +
                    " entries, must have one for each of " + std::to_string(maps) + " maps");
}

}  // namespace

void Validate(const FitReport& report) {
    for (const CurveFit& curve : report.curves) {
        if (curve.published && curve.published->values.size() != curve.fitted.values.size())
            throw Error("FitReport::curves[" + curve.title +
                        "].published must have a constant for each of fitted");
    }
    // Curves measured elsewhere: no surface of ours, no total.
    if (report.maps.empty() && report.formulas.empty()) return;
    const std::size_t maps = report.maps.size();
    MustHave("provenance.maps", report.provenance.maps.size(), maps);
    if (!report.floors.empty()) MustHave("floors", report.floors.size(), maps);
    std::set<std::string> names;
    for (const FormulaRecord& record : report.formulas) {
        const std::string field = "formulas[" + record.name + "]";
        if (!names.insert(record.name).second)
            throw Error("FitReport::" + field + " stands there twice, must be one record");
        MustHave(field + ".in_sample", record.in_sample.maps.size(), maps);
        if (record.held_out) MustHave(field + ".held_out", record.held_out->maps.size(), maps);
        if (!record.facet_rms.empty())
            MustHave(field + ".facet_rms", record.facet_rms.size(), maps);
    }
    const auto must_be_record = [&](const std::string& field, const std::string& name) {
        if (!names.contains(name))
            throw Error("FitReport::" + field + " = " + name + ", must name one of formulas");
    };
    must_be_record("recommended", report.recommended);
    must_be_record("published", report.published);
    if (!report.printed.empty()) must_be_record("printed", report.printed);
    for (const TotalFit& total : report.totals) must_be_record("totals.formula", total.formula);
}

Json ToJson(const FitReport& report) {
    Validate(report);
    Json maps = Json::array();
    for (const SurfaceReport& map : report.maps) maps.push_back(ToJson(map));
    Json floors = Json::array();
    for (const Floors& floor : report.floors)
        floors.push_back({{"of_uniform_visibility", floor.of_alpha},
                          {"of_cosine_visibility", floor.of_V},
                          {"of_both", floor.of_both}});
    Json json{{"provenance", ToJson(report.provenance)},
              {"recommended", report.recommended},
              {"recommended_text", report.recommended_text},
              {"published", report.published},
              {"printed", report.printed},
              {"formulas", RecordsJson(report)},
              {"floors", floors},
              {"curves", CurvesJson(report.curves)},
              {"bounce_family", CurvesJson(report.bounce_family)},
              {"totals", TotalsJson(report.totals)},
              {"faults", FaultsJson(report.faults)},
              {"maps", maps}};
    if (report.choice) json["choice"] = ToJson(*report.choice);
    if (report.amplitudes) json["amplitudes"] = ToJson(*report.amplitudes);
    if (report.convergence) json["convergence"] = ToJson(*report.convergence);
    if (!report.timings.Empty()) json["timings"] = ToJson(report.timings);
    return json;
}

std::string ToJsonText(const FitReport& report) {
    return JsonText(ToJson(report));
}

}  // namespace plumb
