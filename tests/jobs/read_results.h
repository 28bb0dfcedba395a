// The one place that knows how a study hands its figures over: each as a table, by the keys of its
// columns. When a layout changes, this file does, and the tests do not.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "jobs/screen_space/ao_sweep.h"
#include "jobs/screen_space/ao_times.h"
#include "jobs/screen_space/error_budget.h"
#include "jobs/screen_space/guard_study.h"
#include "jobs/screen_space/report_scene.h"
#include "jobs/screen_space/temporal_study.h"
#include "jobs/screen_space/z_precision.h"
#include "reports/document.h"
#include "reports/render.h"
#include "reports/text.h"

namespace plumb {

/// A study's table by its key.
using ResultTable = doc::Table;

namespace read_results {

inline ResultTable TableWith(std::vector<std::string> keys) {
    ResultTable table;
    for (std::string& key : keys) table.columns.push_back({.key = key, .title = key});
    return table;
}

inline doc::Cell TimeMs(const std::optional<Measured>& seconds) {
    return seconds ? doc::Cell(1e3 * *seconds) : doc::Cell();
}

}  // namespace read_results

inline const Measured& MeasuredAt(const ResultTable& table, std::size_t row,
                                  const std::string& key) {
    return std::get<Measured>(table.At(row, key));
}
inline double NumberAt(const ResultTable& table, std::size_t row, const std::string& key) {
    return doc::NumberOf(table.At(row, key));
}
inline const std::string& TextAt(const ResultTable& table, std::size_t row,
                                 const std::string& key) {
    return std::get<std::string>(table.At(row, key));
}

/// step, ms, rms_change, bias, mse, own_mse; the last row is that without a border.
inline ResultTable BudgetTable(const SaoOptions& shipped, const Scene& scene,
                               const Camera& camera, const RayCaster& caster,
                               const ViewTruth& truth, const BudgetOptions& options,
                               const Clock& clock) {
    const ErrorBudget budget =
        MakeErrorBudget(shipped, scene, camera, caster, truth, options, clock);
    ResultTable table =
        read_results::TableWith({"step", "ms", "rms_change", "bias", "mse", "own_mse"});
    std::vector<BudgetRow> rows = budget.rows;
    rows.push_back(budget.no_border);
    for (const BudgetRow& row : rows) {
        table.Add({row.step, read_results::TimeMs(row.seconds), row.rms_change,
                   row.score.error.bias, row.score.error.mse, row.weighted.error.mse});
    }
    return table;
}

/// guard_px, draw_ms, sao_ms.
inline ResultTable GuardTable(const Scene& scene, const Camera& camera, const ViewTruth& truth,
                              const SaoOptions& options, int rounds, const Clock& clock) {
    ResultTable table = read_results::TableWith({"guard_px", "draw_ms", "sao_ms"});
    for (const GuardRow& row : StudyGuardBand(scene, camera, truth, options, rounds, clock)) {
        table.Add({std::int64_t(row.guard_px), 1e3 * row.draw_s, 1e3 * row.sao_s});
    }
    return table;
}

/// radius_m, with_pyramid_ms, without_pyramid_ms, alchemy_ms.
inline ResultTable RadiiTable(const Scene& scene, const Camera& camera, const TimedSize& size,
                              int rounds, const Clock& clock) {
    ResultTable table = read_results::TableWith(
        {"radius_m", "with_pyramid_ms", "without_pyramid_ms", "alchemy_ms"});
    for (const RadiusTime& row : TimeRadii(scene, camera, size, rounds, clock)) {
        table.Add({row.radius_m, 1e3 * row.with_pyramid_s, 1e3 * row.without_pyramid_s,
                   1e3 * row.alchemy_s});
    }
    return table;
}

struct SweepResults {
    ResultTable points;  ///< technique, setting, ms, rmse, pareto (yes or no)
    Closest cheapest;
};

inline SweepResults SweepTable(const TechniqueInput& in, const ViewTruth& truth,
                               std::span<const ChosenTechnique> techniques, int rounds,
                               double tolerance, const Clock& clock) {
    const Sweep sweep = SweepTechniques(in, truth, techniques, rounds, tolerance, clock);
    SweepResults results{
        read_results::TableWith({"technique", "setting", "ms", "rmse", "pareto"}),
        sweep.cheapest};
    for (const SweepPoint& p : sweep.points) {
        results.points.Add(
            {p.technique, p.setting, 1e3 * p.seconds, p.rmse, p.on_front ? "yes" : "no"});
    }
    return results;
}

/// technique, candidate, truth, flicker, in 10^-6.
inline ResultTable FlickerTable(const Scene& scene, const Camera& camera,
                                const RayCaster& caster,
                                std::span<const ChosenTechnique> techniques,
                                const TemporalOptions& options, const Clock& clock) {
    ResultTable table = read_results::TableWith({"technique", "candidate", "truth", "flicker"});
    for (const TemporalRow& row :
         StudyFlicker(scene, camera, caster, techniques, options, clock)) {
        table.Add({row.technique, 1e6 * row.score.candidate, 1e6 * row.score.truth,
                   1e6 * row.score.flicker});
    }
    return table;
}

/// camera, vertices, format, far, z_rms_mm, z_worst_mm, normal_rms_deg, normal_99_deg,
/// normal_999_deg, normal_worst_deg, within_paper_share, pixels, judged: of JSON and CSV, which
/// must agree.
inline ResultTable DrawnTable(const Scene& scene, const ZPrecisionSettings& settings) {
    const ZPrecisionReport report = StudyZPrecision(scene, settings);
    ResultTable table = read_results::TableWith(
        {"camera", "vertices", "format", "far", "z_rms_mm", "z_worst_mm", "normal_rms_deg",
         "normal_99_deg", "normal_999_deg", "normal_worst_deg", "within_paper_share", "pixels",
         "judged"});
    const auto json = nlohmann::json::parse(ToJsonText(report));
    std::istringstream csv(DrawnCsv(report));
    std::string line;
    std::getline(csv, line);
    for (const auto& d : json["drawn"]) {
        const auto text = [&](const char* key) { return d[key].get<std::string>(); };
        const auto number = [&](const char* key) { return d[key].get<double>(); };
        std::string expected =
            text("camera") + "," + text("vertices") + "," + text("format") + "," + text("far");
        for (const char* key :
             {"z_rms_m", "z_worst_m", "normal_rms_deg", "normal_99_deg", "normal_999_deg",
              "normal_worst_deg", "within_paper_share", "pixels", "judged"}) {
            expected += "," + d[key].dump();
        }
        std::getline(csv, line);
        EXPECT_EQ(line, expected);
        table.Add({text("camera"), text("vertices"), text("format"), text("far"),
                   1e3 * number("z_rms_m"), 1e3 * number("z_worst_m"), number("normal_rms_deg"),
                   number("normal_99_deg"), number("normal_999_deg"),
                   number("normal_worst_deg"), number("within_paper_share"), number("pixels"),
                   number("judged")});
    }
    return table;
}

/// host, product, order, clip, format, far, distance_m, rms_mm, worst_mm, mean_mm: of the CSV.
inline ResultTable ZErrorTable(const Scene& scene, const ZPrecisionSettings& settings) {
    ResultTable table =
        read_results::TableWith({"host", "product", "order", "clip", "format", "far",
                                 "distance_m", "rms_mm", "worst_mm", "mean_mm"});
    std::istringstream csv(CurvesCsv(StudyZPrecision(scene, settings)));
    std::string line;
    std::getline(csv, line);
    EXPECT_EQ(line, "host,matrices,order,clip,format,far,distance_m,rms_m,worst_m,mean_m");
    while (std::getline(csv, line)) {
        std::istringstream fields(line);
        std::vector<std::string> texts;
        for (std::string field; std::getline(fields, field, ',');) texts.push_back(field);
        const auto number = [&](std::size_t k) { return std::stod(texts.at(k)); };
        table.Add({texts[0], texts[1] == "three" ? std::string("step by step") : texts[1],
                   texts[2], texts[3], texts[4], texts[5], number(6), 1e3 * number(7),
                   1e3 * number(8), 1e3 * number(9)});
    }
    return table;
}

/// The whole report of a scene.
struct ReportResults {
    ResultTable views;  ///< camera, rms_standard_error_v, rms_standard_error_near
    /// technique, view ("all views"), truth, region, ms, mse, rmse, ssim, recalibrated_rmse
    ResultTable scores;
    ResultTable traffic;  ///< technique, size_px, pass, bytes_read, bytes_written
    ResultTable flicker;  ///< As FlickerTable.
    std::string closest, closest_recalibrated;
    std::string page, terminal;  ///< As people read them; the page with its tags.
    std::vector<std::pair<std::string, Measured>> times;  ///< Each that is told, with its name.
};

inline ReportResults ResultsOf(const SceneReport& r) {
    using read_results::TableWith;
    ReportResults results{
        TableWith({"camera", "rms_standard_error_v", "rms_standard_error_near"}),
        TableWith({"technique", "view", "truth", "region", "ms", "mse", "rmse", "ssim",
                   "recalibrated_rmse"}),
        TableWith({"technique", "size_px", "pass", "bytes_read", "bytes_written"}),
        TableWith({"technique", "candidate", "truth", "flicker"}),
        r.closest.name,
        r.closest_recalibrated.name,
        ToHtml(r),
        {},
        {}};
    std::ostringstream terminal;
    WriteTable(terminal, r);
    results.terminal = terminal.str();
    const auto json = nlohmann::json::parse(ToJsonText(r));
    for (const auto& view : json["views"]) {
        results.views.Add({view["camera"].get<std::string>(),
                           view["truth"]["rms_standard_error_V"].get<double>(),
                           view["truth"]["rms_standard_error_near"].get<double>()});
    }
    const auto time = [&](std::string name, const Measured& seconds) {
        results.times.push_back({std::move(name), seconds});
    };
    for (const TechniqueScore& t : r.techniques) {
        time(t.name, t.seconds);
        for (const PassSeconds& pass : t.passes) time(t.name + " " + pass.name, pass.seconds);
        const auto add = [&](const std::string& view, const std::vector<ScoreAgainst>& scores) {
            for (const ScoreAgainst& s : scores) {
                results.scores.Add({t.name, view, s.truth, s.region, 1e3 * t.seconds,
                                    s.error.mse, s.error.rmse, s.ssim, s.recalibrated_rmse});
            }
        };
        add("all views", t.scores);
        for (const ViewScores& view : t.views) add(view.camera, view.scores);
    }
    for (const PassTimes& t : r.times) {
        const std::string size = std::to_string(t.width_px) + " x " +
                                 std::to_string(t.height_px) + " + " +
                                 std::to_string(t.guard_px);
        time(t.technique + " at " + size, t.seconds);
        for (const PassBytes& pass : t.traffic) {
            results.traffic.Add({t.technique, size, pass.name, pass.read, pass.written});
        }
    }
    for (const TemporalRow& row : r.temporal) {
        results.flicker.Add({row.technique, 1e6 * row.score.candidate, 1e6 * row.score.truth,
                             1e6 * row.score.flicker});
    }
    for (const RadiusTime& t : r.radii) time("radius " + Digits(t.radius_m), t.with_pyramid_s);
    for (const GuardRow& g : r.guards) time("guard " + std::to_string(g.guard_px), g.sao_s);
    for (const BudgetRow& b : r.budget) {
        if (b.seconds) time("budget " + b.step, *b.seconds);
    }
    for (const SweepPoint& p : r.sweep) time(p.technique + ", " + p.setting, p.seconds);
    time("G-buffer", r.raster_s);
    time("copy", r.copy_bytes_per_second);
    time("rays", r.embree_rays_per_second);
    return results;
}

}  // namespace plumb
