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
#include "reports/render.h"
#include "reports/text.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "tests/io/temp_folder.h"
#include "tests/jobs/made_scenes.h"
#include "tests/jobs/plain_scores.h"
#include "tests/reports/json_schema.h"
#include "tests/reports/page_reader.h"

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

const doc::Document& Report() {
    static const doc::Document report =
        ReportScene({TwoViews(), {}, std::string(64, 'd')}, Job(),
                    {.version = "test", .command = "plumb report", .clock = Ticking()});
    return report;
}

const Json& ReportJson() {
    static const Json json = Json::parse(doc::ToJsonText(Report()));
    return json;
}

const Json* FindTable(const Json& sections, const std::string& key) {
    for (const Json& section : sections) {
        for (const Json& table : section["tables"]) {
            if (table["key"] == key) return &table;
        }
        if (const Json* within = FindTable(section["sections"], key)) return within;
    }
    return nullptr;
}

// The rows of a table, each with its cells by the keys of their columns.
Json RowsOf(const std::string& key) {
    const Json* table = FindTable(ReportJson()["sections"], key);
    if (table == nullptr) throw std::runtime_error("no table " + key);
    if (table->contains("rows")) return (*table)["rows"];
    Json rows = Json::array();
    for (const auto& [column, values] : (*table)["values"].items()) {
        for (std::size_t r = 0; r < values.size(); ++r) rows[r][column] = values[r];
    }
    return rows;
}

// The only row whose cells are these.
Json RowWith(const std::string& key, const Json& cells) {
    Json found;
    int count = 0;
    for (const Json& row : RowsOf(key)) {
        bool same = true;
        for (const auto& [column, value] : cells.items()) same &= row[column] == value;
        if (!same) continue;
        found = row;
        ++count;
    }
    if (count != 1) throw std::runtime_error(key + ": " + std::to_string(count) + " rows");
    return found;
}

Json ScoreOf(const std::string& technique, const std::string& view, const std::string& truth,
             const std::string& region) {
    return RowWith(
        "scores",
        {{"technique", technique}, {"view", view}, {"truth", truth}, {"region", region}});
}

const std::string& Page() {
    static const std::string page = doc::ToHtml(Report());
    return page;
}

double Fact(const std::string& key) {
    return doc::NumberOf(doc::FactOf(Report(), key));
}

TEST(ReportWithStudies, IsADocumentByItsSchema) {
    EXPECT_EQ(SchemaErrors(PublishedSchema("document-1.json"), ReportJson()),
              std::vector<std::string>{});
}

// Expected: bias, MAE and MSE of every technique in every view against all three truths, whole and at
// the border, of pictures and truths made here; all views: their means.
TEST(ReportWithStudies, HasTheErrorsOfPlainLoops) {
    const Scene scene = TwoViews();
    const EmbreeCaster caster(scene);
    const std::vector<Falloff> falloffs{Falloff::kHard, Falloff::kSao, Falloff::kQuadratic};
    const Json views = RowsOf("views");
    ASSERT_EQ(views.size(), 2u);
    double mean_mse[3] = {}, mean_bias[3] = {};
    for (std::size_t v = 0; v < 2; ++v) {
        const Camera& camera = scene.cameras[v];
        const ViewTruth truth = MeasureViewTruth(caster, scene, camera, falloffs,
                                                 {.radius_m = 1, .spp = v == 0 ? 64 : 16});
        const Json& view = views[v];
        EXPECT_EQ(view["camera"], camera.name);
        EXPECT_EQ(view["spp"], v == 0 ? 64 : 16);
        const Image<int> seen = SeenPixels(truth), border = SeenAtBorder(truth);
        const GBuffer gbuffer = DrawGBuffer(scene, camera, {.guard_px = 8});
        for (std::size_t t = 0; t < kNames.size(); ++t) {
            const Technique technique = TechniqueNamed(kNames[t], {.radius_m = 1});
            const Image<float> A =
                Shown(technique.run({gbuffer, scene, camera, caster}, Ticking()).back().A,
                      gbuffer.view);
            const auto expect = [&](const std::string& name, const TruthImage& image,
                                    const std::string& region, const Image<int>& pixels) {
                const PlainErrors plain = PlainScore(A, image, pixels);
                const Json score = ScoreOf(kNames[t], camera.name, name, region);
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
        const Json all = ScoreOf(kNames[t], "all views", "V within r", "whole");
        EXPECT_NEAR(all["mse"]["value"].get<double>(), mean_mse[t], 1e-9);
        EXPECT_NEAR(all["rmse"]["value"].get<double>(), std::sqrt(mean_mse[t]), 1e-9);
        EXPECT_NEAR(all["psnr_db"]["value"].get<double>(), -10 * std::log10(mean_mse[t]), 1e-9);
        EXPECT_NEAR(all["bias"]["value"].get<double>(), mean_bias[t], 1e-9);
    }
    EXPECT_EQ(RowsOf("closest")[0]["technique"],
              kNames[std::size_t(std::ranges::min_element(mean_mse) - mean_mse)]);
}

// Expected, by a clock that ticks a millisecond a look: a pass takes one, so that a technique takes as
// many as it has passes; per pixel shown, and over a copy of 2^28 bytes in one.
TEST(ReportWithStudies, HasTheTimesOfTheClock) {
    const auto expect_ms = [](const Json& cell, double ms) {
        for (const char* end : {"value", "low", "high"}) {
            EXPECT_NEAR(cell[end].get<double>(), ms, 1e-6);
        }
    };
    EXPECT_EQ(Fact("rounds"), 2);
    const Json techniques = RowsOf("techniques"), passes = RowsOf("passes");
    const auto passes_of = [](const Json& rows, const Json& of) {
        return double(std::ranges::count_if(rows, [&](const Json& row) {
            return row["technique"] == of["technique"] &&
                   (!of.contains("size_px") || row["size_px"] == of["size_px"]);
        }));
    };
    for (const Json& pass : passes) expect_ms(pass["pass_ms"], 1);
    for (const Json& technique : techniques) {
        EXPECT_GE(passes_of(passes, technique), 4);
        expect_ms(technique["ms"], passes_of(passes, technique));
    }
    EXPECT_NEAR(Fact("copy_gb_per_s"), 1e-9 * 0x1p28 / 0.001, 1e-3);
    EXPECT_NEAR(Fact("raster_ms"), 1, 1e-6);
    EXPECT_NEAR(Fact("mrays_per_s"), 1e-6 * 0x1p20 / 0.001, 1e-3);
    const Json times = RowsOf("times"), traffic = RowsOf("time_passes");
    ASSERT_EQ(times.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k) {
        const Json& t = times[k];
        EXPECT_EQ(t["technique"], k % 2 == 0 ? "sao-supplement2012" : "alchemy");
        EXPECT_EQ(t["size_px"], k < 2 ? "64 x 36 + 16" : "80 x 50 + 8");
        const double shown = k < 2 ? 64 * 36 : 80 * 50, ms = passes_of(traffic, t);
        expect_ms(t["ms"], ms);
        EXPECT_NEAR(t["ns_per_visible_pixel"].get<double>(), ms * 1e6 / shown, 1e-3);
        double bytes = 0;
        for (const Json& pass : traffic) {
            if (pass["technique"] != t["technique"] || pass["size_px"] != t["size_px"])
                continue;
            expect_ms(pass["pass_ms"], 1);
            bytes += pass["bytes_read"].get<double>() + pass["bytes_written"].get<double>();
        }
        EXPECT_NEAR(t["bytes_per_pixel"].get<double>(), bytes / shown, 1e-9);
        const double copies = ms / (bytes / 0x1p28);
        EXPECT_NEAR(t["of_copy"].get<double>(), copies, 1e-6 * copies);
    }
    const Json radii = RowsOf("radii");
    ASSERT_EQ(radii.size(), 9u);
    const std::vector<const char*> kinds{"with_pyramid_ms", "without_pyramid_ms", "alchemy_ms"};
    for (std::size_t s = 0; s < kinds.size(); ++s) {
        const char* label = std::vector{"with pyramid", "without", "AlchemyAO"}[s];
        const auto data = PlotDataOf(Page());
        const std::vector<double> x = SeriesOf(data, "radius", {}, label, "x"),
                                  y = SeriesOf(data, "radius", {}, label, "y");
        for (std::size_t k = 0; k < radii.size(); ++k) {
            expect_ms(radii[k][kinds[s]], 1);
            EXPECT_EQ(x[k], radii[k]["radius_m"].get<double>());
            EXPECT_NEAR(y[k], 1, 1e-5);  // Six digits.
        }
    }
    EXPECT_NE(Page().find("48 x 27 + 8 px"), std::string::npos);
}

// Expected: sweep and budget speak of the same view and technique as the scores; of the fastest
// setting the finding is a row of the sweep.
TEST(ReportWithStudies, AgreesWithItself) {
    for (const std::string& name : kNames) {
        const Json own = ScoreOf(name, "front", "V within r", "whole");
        const Json point = RowWith("sweep", {{"technique", name}, {"setting", "as shipped"}});
        EXPECT_EQ(point["rmse"], own["rmse"]);
        EXPECT_EQ(point["recalibrated_rmse"], own["recalibrated_rmse"]);
        const Json all = ScoreOf(name, "all views", "V within r", "whole");
        const Json shown = RowWith("techniques", {{"technique", name}});
        for (const auto& [key, cell] : shown.items()) EXPECT_EQ(cell, all[key]) << key;
        for (const char* camera : {"front", "side"}) {
            EXPECT_EQ(
                RowWith("rmse_by_camera", {{"technique", name}, {"camera", camera}})["rmse"],
                ScoreOf(name, camera, "V within r", "whole")["rmse"]);
        }
        const auto by_truth = [&](const char* against) {
            return RowWith("rmse_by_truth",
                           {{"technique", name}, {"against", against}})["rmse"];
        };
        EXPECT_EQ(by_truth("V"), ScoreOf(name, "all views", "V", "whole")["rmse"]);
        EXPECT_EQ(by_truth("V within r"), all["rmse"]);
        EXPECT_EQ(by_truth("… weighted by its falloff"),
                  ScoreOf(name, "all views", "V within r, weighted", "whole")["rmse"]);
        for (const char* region : {"edges", "interiors", "border"}) {
            EXPECT_EQ(by_truth(region),
                      ScoreOf(name, "all views", "V within r", region)["rmse"]);
        }
    }
    const std::string cheapest = std::get<std::string>(doc::FactOf(Report(), "cheapest"));
    const std::size_t comma = cheapest.find(", ");
    EXPECT_EQ(RowWith("sweep", {{"technique", cheapest.substr(0, comma)},
                                {"setting", cheapest.substr(comma + 2)}})["pareto"],
              "yes");
    EXPECT_EQ(std::get<std::string>(doc::FactOf(Report(), "budget_technique")),
              "sao-supplement2012");
    EXPECT_EQ(Fact("budget_taps"), 4096);
    EXPECT_EQ(Fact("budget_pixels"), RowsOf("budget")[0]["pixels"].get<double>());
    EXPECT_EQ(RowsOf("budget").size(), 11u);
    EXPECT_EQ(RowsOf("no_border")[0]["step"], "no border");
    EXPECT_EQ(RowsOf("pyramids").size(), 7u);
    EXPECT_EQ(RowsOf("guard_bands").size(), 6u);
    EXPECT_EQ(Fact("frames"), 2);
    EXPECT_EQ(RowsOf("flicker").size(), kNames.size());
    EXPECT_EQ(RowsOf("drawn").size(), 2 * 16u);
}

std::string With95(const Json& f, int digits = 3) {
    if (f["low"].is_null() || f["high"].is_null()) return Digits(f["value"], digits);
    return Digits(f["value"], digits) + " (" + Digits(f["low"], digits) + " to " +
           Digits(f["high"], digits) + ")";
}

std::string WithSe(const Json& f) {
    if (f["standard_error"] == 0) return With95(f);
    return WithError(f["value"], f["standard_error"]);
}

// Expected of the page: every cell of every table, from the JSON.
TEST(ReportWithStudies, PageHasTheFiguresOfTheJson) {
    const Rows scores = TableWithId(Page(), "techniques");
    const Rows views = TableWithId(Page(), "rmse_by_camera_rmse");
    const Rows truths = TableWithId(Page(), "rmse_by_truth_rmse");
    ASSERT_EQ(scores.size(), kNames.size());
    for (std::size_t t = 0; t < kNames.size(); ++t) {
        const Json all = RowWith("techniques", {{"technique", kNames[t]}});
        EXPECT_EQ(scores[t], (std::vector<std::string>{
                                 kNames[t], std::to_string(all["samples"].get<int>()),
                                 With95(all["ms"]), WithSe(all["bias"]), WithSe(all["mae"]),
                                 With95(all["rmse"]), With95(all["psnr_db"], 4),
                                 With95(all["ssim"]), With95(all["recalibrated_rmse"])}));
        const auto rmse = [&](const char* view, const char* truth, const char* region) {
            return With95(ScoreOf(kNames[t], view, truth, region)["rmse"]);
        };
        EXPECT_EQ(views[t],
                  (std::vector<std::string>{kNames[t], rmse("front", "V within r", "whole"),
                                            rmse("side", "V within r", "whole")}));
        EXPECT_EQ(truths[t],
                  (std::vector<std::string>{kNames[t],
                                            t == 0   ? "sao"
                                            : t == 1 ? "quadratic"
                                                     : "hard",
                                            rmse("all views", "V", "whole"),
                                            rmse("all views", "V within r", "whole"),
                                            rmse("all views", "V within r, weighted", "whole"),
                                            rmse("all views", "V within r", "edges"),
                                            rmse("all views", "V within r", "interiors"),
                                            rmse("all views", "V within r", "border")}));
    }
    const auto expect = [](const std::string& key, const auto& cells) {
        const Rows page = TableWithId(Page(), key);
        const Json rows = RowsOf(key);
        ASSERT_EQ(page.size(), rows.size()) << key;
        for (std::size_t k = 0; k < page.size(); ++k) {
            EXPECT_EQ(page[k], std::vector<std::string>(cells(rows[k]))) << key << k;
        }
    };
    using Cells = std::vector<std::string>;
    expect("closest", [](const Json& row) {
        return Cells{row["closest"], row["technique"], With95(row["rmse"]), With95(row["ms"]),
                     row["ties"]};
    });
    const auto step = [](const Json& row) {
        return Cells{row["step"],
                     row["what"],
                     row["ms"].is_null() ? "–" : With95(row["ms"]),
                     Digits(row["rms_change"].get<double>()),
                     WithSe(row["bias"]),
                     With95(row["rmse"]),
                     With95(row["psnr_db"], 4),
                     With95(row["recalibrated_rmse"]),
                     With95(row["own_rmse"])};
    };
    expect("budget", step);
    expect("no_border", step);
    expect("pyramids", [](const Json& row) {
        return Cells{
            row["filter"],       WithSe(row["bias_to_none"]), With95(row["rms_to_none"]),
            WithSe(row["bias"]), With95(row["rmse"]),         With95(row["recalibrated_rmse"])};
    });
    expect("guard_bands", [](const Json& row) {
        return Cells{std::to_string(row["guard_px"].get<int>()),
                     Digits(row["share_of_height"].get<double>(), 2),
                     With95(row["draw_ms"]),
                     With95(row["sao_ms"]),
                     With95(row["rms_to_widest"]),
                     WithSe(row["bias"]),
                     With95(row["rmse"])};
    });
    expect("pareto_front", [](const Json& row) {
        return Cells{row["technique"], row["setting"], With95(row["ms"]), With95(row["rmse"]),
                     With95(row["recalibrated_rmse"])};
    });
    expect("sweep", [](const Json& row) {
        return Cells{row["technique"],
                     row["setting"],
                     With95(row["ms"]),
                     With95(row["rmse"]),
                     With95(row["recalibrated_rmse"]),
                     row["pareto"]};
    });
    expect("times", [](const Json& row) {
        return Cells{row["technique"],
                     row["size_px"],
                     With95(row["ms"]),
                     Digits(row["bytes_per_pixel"].get<double>()),
                     Digits(row["ns_per_visible_pixel"].get<double>()),
                     Digits(row["of_copy"].get<double>())};
    });
    expect("flicker", [](const Json& row) {
        return Cells{row["technique"], WithSe(row["candidate"]), WithSe(row["truth"]),
                     WithSe(row["flicker"])};
    });
    expect("drawn", [](const Json& row) {
        Cells cells{row["camera"], row["vertices"], row["format"], row["far"]};
        for (const char* key : {"z_rms_mm", "z_worst_mm", "normal_rms_deg", "normal_99_deg",
                                "normal_999_deg", "normal_worst_deg"}) {
            cells.push_back(Digits(row[key].get<double>()));
        }
        cells.push_back(Digits(row["within_paper_share"].get<double>(), 4));
        return cells;
    });
    EXPECT_NE(Page().find("cameras front and side"), std::string::npos);
    EXPECT_NE(Page().find("95 % between views"), std::string::npos);
    EXPECT_NE(Page().find("medians of 2 rounds"), std::string::npos);
    EXPECT_NE(Page().find("<figure class=\"waterfall\">"), std::string::npos);
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

// Expected of a file for spreadsheets: every field of a table, from the JSON, by the names of the
// columns.
void ExpectCsvOf(const std::string& file, const std::string& key) {
    const Json rows = RowsOf(key);
    std::istringstream lines(file);
    std::string line;
    std::getline(lines, line);
    const std::vector<std::string> heads = Fields(line);
    for (const Json& row : rows) {
        ASSERT_TRUE(std::getline(lines, line));
        const std::vector<std::string> fields = Fields(line);
        ASSERT_EQ(fields.size(), heads.size());
        const auto expect = [&](const std::string& head, const Json& value) {
            const auto at = std::ranges::find(heads, head);
            ASSERT_NE(at, heads.end()) << head;
            EXPECT_EQ(fields[std::size_t(at - heads.begin())],
                      value.is_string()           ? value.get<std::string>()
                      : value.is_number_integer() ? std::to_string(value.get<long long>())
                      : value.is_number()         ? Exact(value)
                                                  : "")
                << head;
        };
        for (const auto& [column, cell] : row.items()) {
            expect(column, cell.is_object() ? cell["value"] : cell);
            if (!cell.is_object()) continue;
            expect(column + "_se", cell["standard_error"]);
            expect(column + "_low", cell["low"]);
            expect(column + "_high", cell["high"]);
        }
    }
    EXPECT_FALSE(std::getline(lines, line));
}

using WrittenReport = TempFolder;

TEST_F(WrittenReport, HasTheFiguresOfTheJson) {
    EXPECT_EQ(WriteSceneReport(Path(""), Report()), Path("report.html"));
    EXPECT_EQ(Get("report.html"), Page());
    EXPECT_EQ(Json::parse(Get("report.json")), ReportJson());
    EXPECT_EQ(Get("report.csv"), doc::ToCsv(Report()));
    EXPECT_EQ(RowsOf("scores").size(), 3u * 3 * 12);
    ExpectCsvOf(Get("scores.csv"), "scores");
    ExpectCsvOf(Get("sweep.csv"), "sweep");
}

}  // namespace
}  // namespace plumb
