#include "reports/scene_report.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "reports/json_text.h"
#include "reports/text.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

Json ToJson(const Figure& f) {
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

Json ToJson(const std::vector<PassSeconds>& passes) {
    Json json = Json::array();
    for (const PassSeconds& pass : passes) {
        json.push_back({{"pass", pass.name}, {"seconds", pass.seconds}});
    }
    return json;
}

template <class T, class Make>
Json List(const std::vector<T>& items, const Make& make) {
    Json json = Json::array();
    for (const T& item : items) json.push_back(make(item));
    return json;
}

std::string Line(const std::vector<std::string>& fields) {
    std::string line;
    for (const std::string& field : fields) {
        if (!line.empty()) line += ',';
        line += field;
    }
    return line + '\n';
}

}  // namespace

const ScoreAgainst& TechniqueScore::Against(const std::string& truth,
                                            const std::string& region) const {
    for (const ScoreAgainst& score : scores) {
        if (score.truth == truth && score.region == region) return score;
    }
    throw Error("technique " + name + " has no score against \"" + truth + "\", region \"" +
                region + "\"");
}

std::string ToJsonText(const SceneReport& r) {
    Json json{{"tool_version", r.tool_version},
              {"command", r.command},
              {"scene", r.scene},
              {"scene_sha256", r.scene_sha256},
              {"camera", r.camera},
              {"width_px", r.width_px},
              {"height_px", r.height_px},
              {"guard_px", r.guard_px},
              {"threads", r.threads},
              {"seed", r.seed},
              {"radius_m", r.radius_m},
              {"triangles", r.triangles},
              {"pixels", r.pixels},
              {"pixels_seen", r.seen},
              {"notes", r.notes},
              {"truth",
               {{"spp", r.truth.spp},
                {"nets", r.truth.nets},
                {"seconds", r.truth.seconds},
                {"rms_standard_error_V", r.truth.rms_error_V},
                {"rms_standard_error_near", r.truth.rms_error_near},
                {"lost_rays", r.truth.lost}}},
              {"machine",
               {{"embree_occlusion_rays_per_second", r.embree_rays_per_second},
                {"copy_bytes_per_second", r.copy_bytes_per_second},
                {"raster_s", r.raster_s}}}};
    json["techniques"] = List(r.techniques, [](const TechniqueScore& t) {
        return Json{
            {"name", t.name},
            {"falloff", t.falloff},
            {"samples", t.samples},
            {"seconds", t.seconds},
            {"passes", ToJson(t.passes)},
            {"scores", List(t.scores, [](const ScoreAgainst& s) { return ToJson(s); })}};
    });
    json["budget"] = {{"technique", r.budget_technique},
                      {"steps", List(r.budget, [](const BudgetRow& row) {
                           return Json{{"step", row.step},
                                       {"what", row.what},
                                       {"rms_change", row.rms_change},
                                       {"seconds", row.seconds},
                                       {"score", ToJson(row.score)}};
                       })}};
    json["pyramids"] = List(r.pyramids, [](const PyramidRow& row) {
        return Json{{"filter", row.filter},
                    {"bias_to_none", ToJson(row.bias_to_none)},
                    {"rms_to_none", ToJson(row.rms_to_none)},
                    {"score", ToJson(row.against_truth)}};
    });
    json["guard_bands"] = List(r.guards, [](const GuardRow& row) {
        return Json{{"share_of_height", row.share},
                    {"guard_px", row.guard_px},
                    {"rms_to_widest", ToJson(row.rms_to_widest)},
                    {"border", ToJson(row.border)},
                    {"draw_s", row.draw_s},
                    {"sao_s", row.sao_s}};
    });
    json["sweep"] = List(r.sweep, [](const SweepPoint& p) {
        return Json{{"technique", p.technique},
                    {"setting", p.setting},
                    {"seconds", p.seconds},
                    {"rmse", p.rmse},
                    {"recalibrated_rmse", p.recalibrated_rmse},
                    {"pareto", p.on_front}};
    });
    json["cheapest"] = {{"within", r.cheapest_within}, {"name", r.cheapest}};
    json["times"] = List(r.times, [](const PassTimes& t) {
        return Json{{"technique", t.technique},
                    {"width_px", t.width_px},
                    {"height_px", t.height_px},
                    {"guard_px", t.guard_px},
                    {"seconds", t.seconds},
                    {"passes", ToJson(t.passes)},
                    {"bytes_per_pixel", t.bytes_per_pixel},
                    {"ns_per_visible_pixel", t.ns_per_visible},
                    {"times_of_a_copy", t.copies}};
    });
    json["radii"] = List(r.radii, [](const RadiusTime& t) {
        return Json{{"radius_m", t.radius_m},
                    {"with_pyramid_s", t.with_pyramid_s},
                    {"without_pyramid_s", t.without_pyramid_s},
                    {"alchemy_s", t.alchemy_s}};
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

std::string ScoresCsv(const SceneReport& r) {
    std::string csv =
        "technique,samples,seconds,truth,region,pixels,bias,bias_se,mae,mae_se,rmse,rmse_low,"
        "rmse_high,psnr_db,psnr_paper_db,ssim,recalibrated_rmse\n";
    for (const TechniqueScore& t : r.techniques) {
        for (const ScoreAgainst& s : t.scores) {
            const ErrorScore& e = s.error;
            csv += Line({Csv(t.name), std::to_string(t.samples), Exact(t.seconds), Csv(s.truth),
                         Csv(s.region), std::to_string(e.pixels), Exact(e.bias.value),
                         Exact(e.bias.standard_error), Exact(e.mae.value),
                         Exact(e.mae.standard_error), Exact(e.rmse.value),
                         Exact(e.rmse.interval.low), Exact(e.rmse.interval.high),
                         Exact(e.psnr_db.value), Exact(e.psnr_paper_db.value),
                         Exact(s.ssim.value), Exact(s.recalibrated_rmse.value)});
        }
    }
    return csv;
}

std::string SweepCsv(const SceneReport& r) {
    std::string csv = "technique,setting,seconds,rmse,recalibrated_rmse,pareto\n";
    for (const SweepPoint& p : r.sweep) {
        csv += Line({Csv(p.technique), Csv(p.setting), Exact(p.seconds), Exact(p.rmse),
                     Exact(p.recalibrated_rmse), p.on_front ? "yes" : "no"});
    }
    return csv;
}

void WriteTable(std::ostream& out, const SceneReport& r) {
    out << r.scene << ", camera " << r.camera << ", " << r.width_px << " x " << r.height_px
        << ", radius " << Digits(r.radius_m) << " m; truth of " << r.truth.spp
        << " rays a pixel\n\n";
    out << Left("technique", 20) << Right("lookups", 8) << Right("ms", 9) << Right("bias", 18)
        << Right("RMSE", 18) << Right("PSNR", 8) << Right("SSIM", 8) << Right("recal.", 9)
        << "\n";
    for (const TechniqueScore& t : r.techniques) {
        const ScoreAgainst& s = t.Against("V within r");
        out << Left(t.name, 20) << Right(std::to_string(t.samples), 8)
            << Right(Digits(t.seconds * 1e3), 9)
            << Right(WithError(s.error.bias.value, s.error.bias.standard_error), 18)
            << Right(WithError(s.error.rmse.value, s.error.rmse.standard_error), 18)
            << Right(Digits(s.error.psnr_db.value, 4), 8) << Right(Digits(s.ssim.value), 8)
            << Right(Digits(s.recalibrated_rmse.value), 9) << "\n";
    }
    out << "\nagainst V within r; recal.: RMSE after the best monotone change of contrast\n";
    if (!r.cheapest.empty()) {
        out << "cheapest within " << Digits(100 * r.cheapest_within, 2)
            << " % of the least error: " << r.cheapest << "\n";
    }
}

}  // namespace plumb
