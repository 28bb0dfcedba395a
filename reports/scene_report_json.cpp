// Every number of a scene's report as JSON.
#include <nlohmann/json.hpp>

#include "reports/json_text.h"
#include "reports/scene_report.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

Json ToJson(const Measured& f) {
    return {{"value", f.value},
            {"standard_error", f.standard_error},
            {"low", f.interval.low},
            {"high", f.interval.high},
            {"noise_error", f.noise_error}};
}

Json ToJson(const ScoreAgainst& s) {
    const ErrorScore& e = s.error;
    return {{"truth", s.truth},
            {"region", s.region},
            {"pixels", e.pixels},
            {"bias", ToJson(e.bias)},
            {"mae", ToJson(e.mae)},
            {"mae_noise_bias", e.mae_noise_bias},
            {"mse", ToJson(e.mse)},
            {"rmse", ToJson(e.rmse)},
            {"psnr_db", ToJson(e.psnr_db)},
            {"psnr_paper_db", ToJson(e.psnr_paper_db)},
            {"max", e.max},
            {"max_at_least", e.max_at_least},
            {"ssim", ToJson(s.ssim)},
            {"recalibrated_rmse", ToJson(s.recalibrated_rmse)}};
}

// A median, with the least and the greatest of its rounds.
void Put(Json& json, const std::string& key, const Measured& time) {
    json[key] = time.value;
    json[key + "_least"] = time.interval.low;
    json[key + "_greatest"] = time.interval.high;
}

Json ToJson(const std::vector<PassSeconds>& passes) {
    Json json = Json::array();
    for (const PassSeconds& pass : passes) {
        Json one{{"pass", pass.name}};
        Put(one, "seconds", pass.seconds);
        json.push_back(std::move(one));
    }
    return json;
}

template <class T, class Make>
Json List(const std::vector<T>& items, const Make& make) {
    Json json = Json::array();
    for (const T& item : items) json.push_back(make(item));
    return json;
}

Json ToJson(const std::vector<ScoreAgainst>& scores) {
    return List(scores, [](const ScoreAgainst& s) { return ToJson(s); });
}

Json ToJson(const Closest& closest) {
    return {{"name", closest.name}, {"not_told_apart", closest.ties}};
}

Json ToJson(const SceneView& v) {
    return {{"camera", v.camera},
            {"width_px", v.width_px},
            {"height_px", v.height_px},
            {"guard_px", v.guard_px},
            {"pixels_seen", v.seen},
            {"truth",
             {{"spp", v.truth.spp},
              {"nets", v.truth.nets},
              {"seconds", v.truth.seconds},
              {"rms_standard_error_V", v.truth.rms_error_V},
              {"rms_standard_error_near", v.truth.rms_error_near},
              {"lost_rays", v.truth.lost}}}};
}

Json ToJson(const BudgetRow& row) {
    Json json{{"step", row.step},
              {"what", row.what},
              {"rms_change", row.rms_change},
              {"score", ToJson(row.score)},
              {"weighted", ToJson(row.weighted)}};
    if (row.seconds) Put(json, "seconds", *row.seconds);
    return json;
}

}  // namespace

std::string ToJsonText(const SceneReport& r) {
    Json machine;
    Put(machine, "embree_occlusion_rays_per_second", r.embree_rays_per_second);
    Put(machine, "copy_bytes_per_second", r.copy_bytes_per_second);
    Put(machine, "raster_s", r.raster_s);
    Json json{{"tool_version", r.tool_version},
              {"command", r.command},
              {"scene", r.scene},
              {"scene_sha256", r.scene_sha256},
              {"threads", r.threads},
              {"rounds", r.rounds},
              {"seed", r.seed},
              {"radius_m", r.radius_m},
              {"triangles", r.triangles},
              {"notes", r.notes},
              {"views", List(r.views, [](const SceneView& v) { return ToJson(v); })},
              {"machine", std::move(machine)},
              {"closest", ToJson(r.closest)},
              {"closest_recalibrated", ToJson(r.closest_recalibrated)}};
    json["techniques"] = List(r.techniques, [](const TechniqueScore& t) {
        Json one{{"name", t.name}, {"falloff", t.falloff}, {"samples", t.samples}};
        Put(one, "seconds", t.seconds);
        one["passes"] = ToJson(t.passes);
        one["scores"] = ToJson(t.scores);
        one["views"] = List(t.views, [](const ViewScores& v) {
            return Json{{"camera", v.camera}, {"scores", ToJson(v.scores)}};
        });
        return one;
    });
    json["budget"] = {{"technique", r.budget_technique},
                      {"taps", r.budget_taps},
                      {"pixels", r.budget_pixels},
                      {"steps", List(r.budget, [](const BudgetRow& b) { return ToJson(b); })}};
    if (r.no_border) json["budget"]["no_border"] = ToJson(*r.no_border);
    json["pyramids"] = List(r.pyramids, [](const PyramidRow& row) {
        return Json{{"filter", row.filter},
                    {"bias_to_none", ToJson(row.bias_to_none)},
                    {"rms_to_none", ToJson(row.rms_to_none)},
                    {"score", ToJson(row.against_truth)}};
    });
    json["guard_bands"] = List(r.guards, [](const GuardRow& row) {
        Json one{{"share_of_height", row.share},
                 {"guard_px", row.guard_px},
                 {"rms_to_widest", ToJson(row.rms_to_widest)},
                 {"border", ToJson(row.border)}};
        Put(one, "draw_s", row.draw_s);
        Put(one, "sao_s", row.sao_s);
        return one;
    });
    json["sweep"] = List(r.sweep, [](const SweepPoint& p) {
        Json one{{"technique", p.technique}, {"setting", p.setting}};
        Put(one, "seconds", p.seconds);
        one["rmse"] = ToJson(p.rmse);
        one["recalibrated_rmse"] = ToJson(p.recalibrated_rmse);
        one["pareto"] = p.on_front;
        return one;
    });
    json["cheapest"] = ToJson(r.cheapest);
    json["cheapest"]["within"] = r.cheapest_within;
    json["times"] = List(r.times, [](const PassTimes& t) {
        Json one{{"technique", t.technique},
                 {"width_px", t.width_px},
                 {"height_px", t.height_px},
                 {"guard_px", t.guard_px}};
        Put(one, "seconds", t.seconds);
        one["passes"] = ToJson(t.passes);
        one["traffic"] = List(t.traffic, [](const PassBytes& b) {
            return Json{{"pass", b.name}, {"bytes_read", b.read}, {"bytes_written", b.written}};
        });
        one["bytes_per_pixel"] = t.bytes_per_pixel;
        one["ns_per_visible_pixel"] = t.ns_per_visible;
        one["times_of_a_copy"] = t.copies;
        return one;
    });
    json["radii"] = List(r.radii, [&](const RadiusTime& t) {
        Json one{{"radius_m", t.radius_m},
                 {"width_px", r.radii_width_px},
                 {"height_px", r.radii_height_px}};
        Put(one, "with_pyramid_s", t.with_pyramid_s);
        Put(one, "without_pyramid_s", t.without_pyramid_s);
        Put(one, "alchemy_s", t.alchemy_s);
        return one;
    });
    json["flicker"] = {{"frames", r.temporal_frames},
                       {"techniques", List(r.temporal, [](const TemporalRow& t) {
                            return Json{{"technique", t.technique},
                                        {"candidate_variance", ToJson(t.score.candidate)},
                                        {"truth_variance", ToJson(t.score.truth)},
                                        {"flicker_variance", ToJson(t.score.flicker)}};
                        })}};
    if (r.precision) json["depth"] = plumb::ToJson(*r.precision);
    return JsonText(json);
}

}  // namespace plumb
