// The parts that pages share, as JSON: words for names, units in them, keys in reading order.
#include <functional>
#include <nlohmann/json.hpp>

#include "reports/amplitude_sweep.h"
#include "reports/convergence.h"
#include "reports/json_text.h"
#include "reports/provenance.h"
#include "reports/surface_report.h"
#include "reports/timings.h"

namespace plumb {

using Json = nlohmann::ordered_json;

namespace {

/// One list a quantity, over the bins that are not empty: easy to plot, and a fifth of the
/// bytes of one object a bin. Whole histograms are written by io/.
Json HistogramJson(const BounceHistogram& histogram) {
    using Get = std::function<Json(const BounceBin&)>;
    const auto list = [&](const Get& get) {
        Json values = Json::array();
        for (const BounceBin& bin : histogram.bins)
            if (bin.count > 0) values.push_back(get(bin));
        return values;
    };
    const auto spreads = [&](auto of, std::size_t size) {
        Json all = Json::array();
        for (std::size_t i = 0; i < size; ++i) {
            const auto member = [&](double Spread::*value) {
                return list([&](const BounceBin& bin) { return of(bin)[i].*value; });
            };
            all.push_back({{"mean", member(&Spread::mean)},
                           {"variance", member(&Spread::variance)},
                           {"p05", member(&Spread::p05)},
                           {"p50", member(&Spread::p50)},
                           {"p95", member(&Spread::p95)}});
        }
        return all;
    };
    return {{"binned_by", histogram.binned_by == BinnedBy::kUniformVisibility
                              ? "uniform visibility"
                              : "cosine visibility"},
            {"albedos", histogram.albedos},
            {"low", list([](const BounceBin& bin) { return bin.low; })},
            {"high", list([](const BounceBin& bin) { return bin.high; })},
            {"count", list([](const BounceBin& bin) { return bin.count; })},
            {"mean_uniform_visibility", list([](const BounceBin& bin) { return bin.alpha; })},
            {"mean_cosine_visibility", list([](const BounceBin& bin) { return bin.V; })},
            {"bounces", spreads([](const BounceBin& bin) { return bin.bounce; },
                                std::size_t(histogram.Bounces()) + 1)},
            {"totals", spreads([](const BounceBin& bin) { return bin.total; },
                               histogram.albedos.size())}};
}

}  // namespace

std::string JsonText(const Json& json) {
    return json.dump(1, ' ', false, Json::error_handler_t::replace).append("\n");
}

Json ToJson(const MapSource& map) {
    return {{"name", map.name},
            {"file", map.file},
            {"sha256", map.sha256},
            {"width_texels", map.width_texels},
            {"height_texels", map.height_texels},
            {"spacing_x_m", map.spacing_x_m},
            {"spacing_y_m", map.spacing_y_m},
            {"amplitude_m", map.amplitude_m},
            {"boundary", map.boundary},
            {"preparation", map.preparation},
            {"source", map.source},
            {"licence", map.licence}};
}

Json ToJson(const Provenance& provenance) {
    Json maps = Json::array();
    for (const MapSource& map : provenance.maps) maps.push_back(ToJson(map));
    return {{"tool_version", provenance.tool_version},
            {"command", provenance.command},
            {"maps", maps},
            {"sampling",
             {{"method", provenance.sampling.method},
              {"per_facet", provenance.sampling.per_facet},
              {"seed", provenance.sampling.seed}}},
            {"bounces", provenance.bounces},
            {"bins", provenance.bins},
            {"albedos", provenance.albedos},
            {"weighting", provenance.weighting}};
}

Json ToJson(const SurfaceFigures& figures) {
    Json json{{"facets", figures.facets},
              {"mean_uniform_visibility", figures.mean_alpha},
              {"mean_cosine_visibility", figures.mean_V},
              {"mean_first_bounce", figures.mean_first_bounce},
              {"mean_slope_deg", figures.mean_slope_deg},
              {"links_per_facet", figures.links_per_facet},
              {"cut_short", figures.cut_short},
              {"max_furnace_error", figures.max_furnace_error},
              {"light_under_way", figures.light_under_way},
              {"bounces_run", figures.bounces_run},
              {"aperture", nullptr}};
    if (figures.aperture)
        json["aperture"] = {{"mean", figures.aperture->value},
                            {"standard_error", figures.aperture->standard_error},
                            {"samples", figures.facets}};
    return json;
}

Json ToJson(const SurfaceReport& report) {
    return {{"name", report.name},
            {"figures", ToJson(report.figures)},
            {"over_uniform_visibility", HistogramJson(report.over_alpha)},
            {"over_cosine_visibility", HistogramJson(report.over_V)}};
}

Json ToJson(const AmplitudeSweep& sweep) {
    Json points = Json::array();
    for (const AmplitudePoint& point : sweep.points)
        points.push_back({{"amplitude_m", point.amplitude_m},
                          {"amplitude_of_width", point.amplitude_of_width},
                          {"figures", ToJson(point.figures)},
                          {"recommended_rms", point.recommended_rms},
                          {"published_rms", point.published_rms},
                          {"over_uniform_visibility", HistogramJson(point.over_alpha)}});
    return {{"map", sweep.map}, {"points", points}};
}

Json ToJson(const Timings& timings) {
    Json stages = Json::array();
    for (const StageTiming& stage : timings.stages)
        stages.push_back(
            {{"map", stage.map}, {"stage", stage.stage}, {"seconds", stage.seconds}});
    return {{"stages", stages},
            {"peak_memory_bytes", timings.peak_memory_bytes},
            {"machine_rays_per_second", timings.machine_rays_per_second},
            {"threads", timings.threads}};
}

Json ToJson(const Convergence& convergence) {
    Json points = Json::array();
    for (const ConvergencePoint& point : convergence.points)
        points.push_back({{"method", point.method},
                          {"per_facet", point.per_facet},
                          {"seconds", point.seconds.value},
                          {"seconds_low", point.seconds.interval.low},
                          {"seconds_high", point.seconds.interval.high},
                          {"rms_cosine_visibility", point.rms_V},
                          {"max_abs_cosine_visibility", point.max_abs_V},
                          {"rms_total_half_albedo", point.rms_E_half}});
    return {{"map", convergence.map},
            {"reference", convergence.reference},
            {"facets", convergence.facets},
            {"threads", convergence.threads},
            {"machine_rays_per_second", convergence.machine_rays_per_second},
            {"points", points}};
}

}  // namespace plumb
