// The whole report of two views with its studies, at a small size: its figures against the same
// computed by plain loops, those of the page and of the tables against the JSON.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "jobs/screen_space/report_scene.h"
#include "jobs/screen_space/score_technique.h"
#include "rays/embree/embree_caster.h"
#include "reports/text.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "tests/jobs/made_scenes.h"
#include "tests/jobs/plain_scores.h"

namespace plumb {
namespace {

using Json = nlohmann::json;

Scene TwoViews() {
    Scene scene = FloorAndWall(96, 72);
    Camera side = scene.cameras.front();
    side.name = "side";
    side.position_m = {-3, -1.5, 1};
    scene.cameras.push_back(side);
    return scene;
}

const std::vector<std::string> kNames{"sao-supplement2012", "hbao", "rays-8"};

SceneReportJob Job() {
    SceneReportJob job;
    job.guard_px = 8;
    job.radius_m = 1;
    job.techniques = kNames;
    job.spp = 64;
    job.rounds = 2;
    job.sizes = {{64, 36, 16}, {80, 50, 8}};
    job.radii_size = {48, 27, 8};
    job.budget_stride_px = 12;
    job.flicker = {.frames = 2, .width_px = 48, .height_px = 27, .guard_px = 8, .spp = 16};
    job.precision = {
        .curves = {.distances = 2, .poses = 1, .points = 1}, .width_px = 32, .height_px = 18};
    return job;
}

const SceneReport& Report() {
    static const SceneReport report =
        ReportScene({TwoViews(), {}, "digest"}, Job(),
                    {.version = "test", .command = "plumb report", .clock = Ticking()});
    return report;
}

const Json& ReportJson() {
    static const Json json = Json::parse(ToJsonText(Report()));
    return json;
}

const Json& ScoreOf(const Json& scores, const std::string& truth, const std::string& region) {
    for (const Json& score : scores) {
        if (score["truth"] == truth && score["region"] == region) return score;
    }
    throw std::runtime_error(truth + " " + region);
}

// Expected: bias, MAE and MSE of every technique in every view against all three truths, whole and at
// the border, of pictures and truths made here; all views: their means.
TEST(ReportWithStudies, HasTheErrorsOfPlainLoops) {
    const Scene scene = TwoViews();
    const EmbreeCaster caster(scene);
    const std::vector<Falloff> falloffs{Falloff::kHard, Falloff::kSao, Falloff::kQuadratic};
    ASSERT_EQ(ReportJson()["views"].size(), 2u);
    double mean_mse[3] = {}, mean_bias[3] = {};
    for (std::size_t v = 0; v < 2; ++v) {
        const Camera& camera = scene.cameras[v];
        const ViewTruth truth = MeasureViewTruth(caster, scene, camera, falloffs,
                                                 {.radius_m = 1, .spp = v == 0 ? 64 : 16});
        const Json& view = ReportJson()["views"][v];
        EXPECT_EQ(view["camera"], camera.name);
        EXPECT_EQ(view["truth"]["spp"], v == 0 ? 64 : 16);
        const Image<int> seen = SeenPixels(truth), border = SeenAtBorder(truth);
        const GBuffer gbuffer = DrawGBuffer(scene, camera, {.guard_px = 8});
        for (std::size_t t = 0; t < kNames.size(); ++t) {
            const Technique technique = TechniqueNamed(kNames[t], {.radius_m = 1});
            const Image<float> A =
                Shown(technique.run({gbuffer, scene, camera, caster}, Ticking()).back().A,
                      gbuffer.view);
            const Json& scores = ReportJson()["techniques"][t]["views"][v]["scores"];
            const auto expect = [&](const std::string& name, const TruthImage& image,
                                    const std::string& region, const Image<int>& pixels) {
                const PlainErrors plain = PlainScore(A, image, pixels);
                const Json& score = ScoreOf(scores, name, region);
                EXPECT_EQ(score["pixels"].get<double>(), plain.pixels) << name << region;
                EXPECT_NEAR(score["bias"]["value"].get<double>(), plain.bias, 1e-9);
                EXPECT_NEAR(score["mae"]["value"].get<double>(), plain.mae, 1e-9);
                EXPECT_NEAR(score["mse"]["value"].get<double>(), plain.mse, 1e-9) << kNames[t];
            };
            expect("V", truth.V, "whole", seen);
            expect("V within r", truth.near.at(Falloff::kHard), "whole", seen);
            expect("V within r", truth.near.at(Falloff::kHard), "border", border);
            expect("V within r, weighted", truth.near.at(technique.falloff), "whole", seen);
            const PlainErrors near = PlainScore(A, truth.near.at(Falloff::kHard), seen);
            mean_mse[t] += near.mse / 2;
            mean_bias[t] += near.bias / 2;
        }
    }
    for (std::size_t t = 0; t < kNames.size(); ++t) {
        const Json& all =
            ScoreOf(ReportJson()["techniques"][t]["scores"], "V within r", "whole");
        EXPECT_NEAR(all["mse"]["value"].get<double>(), mean_mse[t], 1e-9);
        EXPECT_NEAR(all["rmse"]["value"].get<double>(), std::sqrt(mean_mse[t]), 1e-9);
        EXPECT_NEAR(all["psnr_db"]["value"].get<double>(), -10 * std::log10(mean_mse[t]), 1e-9);
        EXPECT_NEAR(all["bias"]["value"].get<double>(), mean_bias[t], 1e-9);
    }
    EXPECT_EQ(ReportJson()["closest"]["name"],
              kNames[std::size_t(std::ranges::min_element(mean_mse) - mean_mse)]);
}

// Expected, by a clock that ticks a millisecond a look: a pass takes one, so that a technique takes as
// many as it has passes; per pixel shown, and over a copy of 2^28 bytes in one.
TEST(ReportWithStudies, HasTheTimesOfTheClock) {
    const Json& json = ReportJson();
    EXPECT_EQ(json["rounds"], 2);
    for (const Json& technique : json["techniques"]) {
        const double passes = double(technique["passes"].size());
        EXPECT_NEAR(technique["seconds"].get<double>(), 0.001 * passes, 1e-9);
        EXPECT_NEAR(technique["seconds_least"].get<double>(), 0.001 * passes, 1e-9);
        EXPECT_NEAR(technique["seconds_greatest"].get<double>(), 0.001 * passes, 1e-9);
    }
    EXPECT_NEAR(json["machine"]["copy_bytes_per_second"].get<double>(), 0x1p28 / 0.001, 1e6);
    EXPECT_NEAR(json["machine"]["raster_s"].get<double>(), 0.001, 1e-9);
    EXPECT_NEAR(json["machine"]["embree_occlusion_rays_per_second"].get<double>(),
                0x1p20 / 0.001, 1e3);
    ASSERT_EQ(json["times"].size(), 4u);
    for (std::size_t k = 0; k < 4; ++k) {
        const Json& t = json["times"][k];
        EXPECT_EQ(t["technique"], k % 2 == 0 ? "supplement2012" : "alchemy");
        const double shown = k < 2 ? 64 * 36 : 80 * 50, seconds = t["seconds"];
        EXPECT_NEAR(seconds, 0.001 * double(t["passes"].size()), 1e-9);
        EXPECT_NEAR(t["ns_per_visible_pixel"].get<double>(), seconds * 1e9 / shown, 1e-3);
        double bytes = 0;
        for (std::size_t p = 0; p < t["traffic"].size(); ++p) {
            EXPECT_EQ(t["traffic"][p]["pass"], t["passes"][p]["pass"]);
            bytes += t["traffic"][p]["bytes_read"].get<double>() +
                     t["traffic"][p]["bytes_written"].get<double>();
        }
        EXPECT_NEAR(t["bytes_per_pixel"].get<double>(), bytes / shown, 1e-9);
        EXPECT_NEAR(t["times_of_a_copy"].get<double>(), seconds / (0.001 * bytes / 0x1p28),
                    1e-6 * seconds / (0.001 * bytes / 0x1p28));
    }
    ASSERT_EQ(json["radii"].size(), 9u);
    for (const Json& t : json["radii"]) {
        EXPECT_EQ(t["width_px"], 48);
        for (const char* key : {"with_pyramid_s", "without_pyramid_s", "alchemy_s"}) {
            EXPECT_NEAR(t[key].get<double>(), 0.001, 1e-9);
        }
    }
}

// Expected: sweep and budget speak of the same view and technique as the scores.
TEST(ReportWithStudies, AgreesWithItself) {
    const Json& json = ReportJson();
    for (std::size_t t = 0; t < kNames.size(); ++t) {
        const Json& own =
            ScoreOf(json["techniques"][t]["views"][0]["scores"], "V within r", "whole");
        bool found = false;
        for (const Json& p : json["sweep"]) {
            if (p["technique"] != kNames[t] || p["setting"] != "as shipped") continue;
            found = true;
            EXPECT_EQ(p["rmse"], own["rmse"]);
            EXPECT_EQ(p["recalibrated_rmse"], own["recalibrated_rmse"]);
        }
        EXPECT_TRUE(found);
    }
    EXPECT_EQ(json["budget"]["technique"], "sao-supplement2012");
    EXPECT_EQ(json["budget"]["taps"], 4096);
    EXPECT_EQ(json["budget"]["steps"].size(), 11u);
    EXPECT_EQ(json["budget"]["no_border"]["step"], "no border");
    EXPECT_EQ(json["pyramids"].size(), 7u);
    EXPECT_EQ(json["guard_bands"].size(), 6u);
    EXPECT_EQ(json["flicker"]["frames"], 2);
    EXPECT_EQ(json["flicker"]["techniques"].size(), kNames.size());
    EXPECT_EQ(json["depth"]["drawn"].size(), 2 * 16u);
}

// The text of each cell of each row of the table below `heading`, tags taken off.
std::vector<std::vector<std::string>> TableBelow(const std::string& html,
                                                 const std::string& heading) {
    const std::size_t at = html.find(heading);
    const std::size_t begin = html.find("<tbody>", at), end = html.find("</tbody>", at);
    EXPECT_NE(at, std::string::npos) << heading;
    std::vector<std::vector<std::string>> rows;
    for (std::size_t tr = html.find("<tr>", begin); tr < end; tr = html.find("<tr>", tr + 1)) {
        rows.emplace_back();
        const std::size_t row_end = html.find("</tr>", tr);
        for (std::size_t td = html.find("<td", tr); td < row_end;
             td = html.find("<td", td + 1)) {
            const std::size_t from = html.find('>', td) + 1;
            std::string text, cell = html.substr(from, html.find("</td>", td) - from);
            bool in_tag = false;
            for (const char c : cell) {
                if (c == '<') in_tag = true;
                if (!in_tag) text += c;
                if (c == '>') in_tag = false;
            }
            for (std::size_t q; (q = text.find("&#39;")) != std::string::npos;) {
                text.replace(q, 5, "'");
            }
            rows.back().push_back(text);
        }
    }
    return rows;
}

std::string With95(const Json& f, int digits = 3) {
    return Digits(f["value"], digits) + " (" + Digits(f["low"], digits) + " to " +
           Digits(f["high"], digits) + ")";
}

std::string WithSe(const Json& f, double scale = 1) {
    return WithError(scale * f["value"].get<double>(),
                     scale * f["standard_error"].get<double>());
}

std::string MsOf(const Json& json, const std::string& key) {
    return Digits(json[key].get<double>() * 1e3) + " (" +
           Digits(json[key + "_least"].get<double>() * 1e3) + "–" +
           Digits(json[key + "_greatest"].get<double>() * 1e3) + ")";
}

// Expected of the page: every cell of every table, from the JSON.
TEST(ReportWithStudies, PageHasTheFiguresOfTheJson) {
    const Json& json = ReportJson();
    const std::string html = ToHtml(Report());
    const auto scores = TableBelow(html, "Against V within r, over all pixels");
    const auto views = TableBelow(html, "RMSE by camera");
    const auto truths = TableBelow(html, "RMSE by truth and by region");
    ASSERT_EQ(scores.size(), kNames.size());
    for (std::size_t t = 0; t < kNames.size(); ++t) {
        const Json& technique = json["techniques"][t];
        const Json& all = ScoreOf(technique["scores"], "V within r", "whole");
        EXPECT_EQ(scores[t],
                  (std::vector<std::string>{
                      kNames[t], std::to_string(technique["samples"].get<int>()),
                      MsOf(technique, "seconds"), WithSe(all["bias"]), WithSe(all["mae"]),
                      With95(all["rmse"]), With95(all["psnr_db"], 4), With95(all["ssim"]),
                      With95(all["recalibrated_rmse"])}));
        std::vector<std::string> row{kNames[t]};
        for (const Json& view : technique["views"]) {
            row.push_back(With95(ScoreOf(view["scores"], "V within r", "whole")["rmse"]));
        }
        EXPECT_EQ(views[t], row);
        row = {kNames[t], technique["falloff"]};
        for (const char* truth : {"V", "V within r", "V within r, weighted"}) {
            row.push_back(With95(ScoreOf(technique["scores"], truth, "whole")["rmse"]));
        }
        for (const char* region : {"edges", "interiors", "border"}) {
            row.push_back(With95(ScoreOf(technique["scores"], "V within r", region)["rmse"]));
        }
        EXPECT_EQ(truths[t], row);
    }
    const auto budget = TableBelow(html, "id=\"budget\"");
    ASSERT_EQ(budget.size(), 11u);
    for (std::size_t k = 0; k < budget.size(); ++k) {
        const Json& step = json["budget"]["steps"][k];
        EXPECT_EQ(budget[k], (std::vector<std::string>{
                                 step["step"], step["what"], WithSe(step["score"]["bias"]),
                                 With95(step["score"]["rmse"]),
                                 Digits(step["score"]["psnr_db"]["value"], 4),
                                 With95(step["score"]["recalibrated_rmse"]),
                                 With95(step["weighted"]["rmse"]), Digits(step["rms_change"]),
                                 step.contains("seconds") ? MsOf(step, "seconds") : "–"}));
    }
    EXPECT_NE(html.find("all else as shipped: RMSE " +
                        With95(json["budget"]["no_border"]["score"]["rmse"])),
              std::string::npos);
    const auto pyramids = TableBelow(html, "How the z pyramid is made");
    const auto guards = TableBelow(html, "The guard band");
    for (std::size_t k = 0; k < 7; ++k) {
        const Json& row = json["pyramids"][k];
        EXPECT_EQ(pyramids[k],
                  (std::vector<std::string>{
                      row["filter"], WithSe(row["bias_to_none"]), With95(row["rms_to_none"]),
                      WithSe(row["score"]["bias"]), With95(row["score"]["rmse"]),
                      With95(row["score"]["recalibrated_rmse"])}));
    }
    for (std::size_t k = 0; k < 6; ++k) {
        const Json& row = json["guard_bands"][k];
        EXPECT_EQ(guards[k],
                  (std::vector<std::string>{
                      Digits(100 * row["share_of_height"].get<double>(), 2) + " %",
                      std::to_string(row["guard_px"].get<int>()), With95(row["rms_to_widest"]),
                      WithSe(row["border"]["bias"]), With95(row["border"]["rmse"]),
                      MsOf(row, "draw_s"), MsOf(row, "sao_s")}));
    }
    std::vector<std::vector<std::string>> front;
    for (const Json& p : json["sweep"]) {
        if (!p["pareto"].get<bool>()) continue;
        front.push_back({p["technique"], p["setting"], MsOf(p, "seconds"), With95(p["rmse"]),
                         With95(p["recalibrated_rmse"])});
    }
    auto shown = TableBelow(html, "The Pareto front</h3>");
    std::ranges::sort(front);
    std::ranges::sort(shown);
    EXPECT_EQ(shown, front);
    const auto times = TableBelow(html, "id=\"times\"");
    ASSERT_EQ(times.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k) {
        const Json& t = json["times"][k];
        EXPECT_EQ(times[k][0], t["technique"]);
        EXPECT_EQ(times[k][1], k < 2 ? "64 × 36 + 16" : "80 × 50 + 8");
        EXPECT_EQ(times[k][2], MsOf(t, "seconds"));
        EXPECT_EQ(times[k][4], Digits(t["bytes_per_pixel"]));
        EXPECT_EQ(times[k][5], Digits(t["ns_per_visible_pixel"]));
        EXPECT_EQ(times[k][6], Digits(t["times_of_a_copy"]));
    }
    const auto flicker = TableBelow(html, "id=\"flicker\"");
    for (std::size_t t = 0; t < kNames.size(); ++t) {
        const Json& row = json["flicker"]["techniques"][t];
        EXPECT_EQ(flicker[t],
                  (std::vector<std::string>{kNames[t], WithSe(row["candidate_variance"], 1e6),
                                            WithSe(row["truth_variance"], 1e6),
                                            WithSe(row["flicker_variance"], 1e6)}));
    }
    EXPECT_NE(html.find("cameras front and side"), std::string::npos);
    EXPECT_NE(html.find("95 % between views"), std::string::npos);
}

std::vector<std::string> Fields(const std::string& line) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (const char c : line) {
        if (c == '"') {
            quoted = !quoted;
        } else if (c == ',' && !quoted) {
            fields.emplace_back();
        } else {
            fields.back() += c;
        }
    }
    return fields;
}

// Expected of the tables for spreadsheets: every field, from the JSON, by the names of the columns.
TEST(ReportWithStudies, TablesHaveTheFiguresOfTheJson) {
    const Json& json = ReportJson();
    std::istringstream lines(ScoresCsv(Report()));
    std::string line;
    std::getline(lines, line);
    const std::vector<std::string> heads = Fields(line);
    int count = 0;
    while (std::getline(lines, line)) {
        ++count;
        const std::vector<std::string> fields = Fields(line);
        ASSERT_EQ(fields.size(), heads.size());
        const auto of = [&](const std::string& head) {
            return fields[std::size_t(std::ranges::find(heads, head) - heads.begin())];
        };
        const Json& technique = *std::ranges::find_if(
            json["techniques"], [&](const Json& t) { return t["name"] == of("technique"); });
        const Json* scores = &technique["scores"];
        for (const Json& view : technique["views"]) {
            if (view["camera"] == of("view")) scores = &view["scores"];
        }
        if (scores == &technique["scores"]) {
            EXPECT_EQ(of("view"), "all views");
        }
        const Json& score = ScoreOf(*scores, of("truth"), of("region"));
        EXPECT_EQ(of("samples"), std::to_string(technique["samples"].get<int>()));
        EXPECT_EQ(of("seconds"), Exact(technique["seconds"]));
        EXPECT_EQ(of("seconds_least"), Exact(technique["seconds_least"]));
        EXPECT_EQ(of("seconds_greatest"), Exact(technique["seconds_greatest"]));
        EXPECT_EQ(of("pixels"), std::to_string(score["pixels"].get<int>()));
        for (const char* figure :
             {"bias", "mae", "rmse", "psnr_db", "psnr_paper_db", "ssim", "recalibrated_rmse"}) {
            const auto expect = [&](const std::string& head, const Json& value) {
                EXPECT_EQ(of(head), value.is_number() ? Exact(value) : "") << head;
            };
            expect(figure, score[figure]["value"]);
            expect(std::string(figure) + "_low", score[figure]["low"]);
            expect(std::string(figure) + "_high", score[figure]["high"]);
        }
    }
    EXPECT_EQ(count, 3 * 3 * 12);
    std::istringstream sweep(SweepCsv(Report()));
    std::getline(sweep, line);
    EXPECT_EQ(Fields(line),
              (std::vector<std::string>{"technique", "setting", "seconds", "seconds_least",
                                        "seconds_greatest", "rmse", "rmse_low", "rmse_high",
                                        "recalibrated_rmse", "recalibrated_rmse_low",
                                        "recalibrated_rmse_high", "pareto"}));
    for (const Json& p : json["sweep"]) {
        ASSERT_TRUE(std::getline(sweep, line));
        EXPECT_EQ(
            Fields(line),
            (std::vector<std::string>{
                p["technique"], p["setting"], Exact(p["seconds"]), Exact(p["seconds_least"]),
                Exact(p["seconds_greatest"]), Exact(p["rmse"]["value"]),
                Exact(p["rmse"]["low"]), Exact(p["rmse"]["high"]),
                Exact(p["recalibrated_rmse"]["value"]), Exact(p["recalibrated_rmse"]["low"]),
                Exact(p["recalibrated_rmse"]["high"]),
                p["pareto"].get<bool>() ? "yes" : "no"}));
    }
}

}  // namespace
}  // namespace plumb
