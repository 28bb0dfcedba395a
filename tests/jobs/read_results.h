// The one place that knows how a study hands its figures over: each as a table, by the keys of its
// columns. When a layout changes, this file does, and the tests do not.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
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

namespace read_results {

/// All tables of sections, each before those of the sections within.
inline void ForEachTable(const std::vector<doc::Section>& sections, const auto& see) {
    for (const doc::Section& section : sections) {
        for (const doc::Table& table : section.tables) see(table);
        ForEachTable(section.sections, see);
    }
}

inline ResultTable TableIn(doc::Section section, const std::string& key) {
    return doc::TableOf({.kind = "study", .title = {}, .sections = {std::move(section)}}, key);
}

inline RunContext At(const Clock& clock) {
    return {.clock = clock};
}

}  // namespace read_results

/// step, ms, rms_change, bias, mse, own_mse; the last row is that without a border.
inline ResultTable BudgetTable(const SaoOptions& shipped, const Scene& scene,
                               const Camera& camera, const RayCaster& caster,
                               const ViewTruth& truth, const BudgetOptions& options,
                               const Clock& clock) {
    const doc::Section budget = MakeErrorBudget("sao", shipped, scene, camera, caster, truth,
                                                options, read_results::At(clock));
    ResultTable table = read_results::TableIn(budget, "budget");
    table.Add(read_results::TableIn(budget, "no_border").rows.at(0));
    return table;
}

/// guard_px, draw_ms, sao_ms.
inline ResultTable GuardTable(const Scene& scene, const Camera& camera, const ViewTruth& truth,
                              const SaoOptions& options, int rounds, const Clock& clock) {
    return read_results::TableIn(
        StudyGuardBand(scene, camera, truth, options, rounds, read_results::At(clock)),
        "guard_bands");
}

/// radius_m, with_pyramid_ms, without_pyramid_ms, alchemy_ms.
inline ResultTable RadiiTable(const Scene& scene, const Camera& camera, const TimedSize& size,
                              int rounds, const Clock& clock) {
    return read_results::TableIn(
        TimeRadii(scene, camera, size, rounds, read_results::At(clock)), "radii");
}

struct SweepResults {
    ResultTable points;  ///< technique, setting, ms, rmse, pareto (yes or no)
    Closest cheapest;
};

inline SweepResults SweepTable(const TechniqueInput& in, const ViewTruth& truth,
                               std::span<const ChosenTechnique> techniques, int rounds,
                               double tolerance, const Clock& clock) {
    Sweep sweep =
        SweepTechniques(in, truth, techniques, rounds, tolerance, read_results::At(clock));
    return {read_results::TableIn(std::move(sweep.section), "sweep"), sweep.cheapest};
}

/// technique, candidate, truth, flicker, in 10^-6.
inline ResultTable FlickerTable(const Scene& scene, const Camera& camera,
                                const RayCaster& caster,
                                std::span<const ChosenTechnique> techniques,
                                const TemporalOptions& options, const Clock& clock) {
    return read_results::TableIn(
        StudyFlicker(scene, camera, caster, techniques, options, read_results::At(clock)),
        "flicker");
}

/// camera, vertices, format, far, z_rms_mm, z_worst_mm, normal_rms_deg, normal_99_deg,
/// normal_999_deg, normal_worst_deg, within_paper_share, pixels, judged; JSON and CSV must agree
/// with it.
inline ResultTable DrawnTable(const Scene& scene, const ZPrecisionSettings& settings) {
    const doc::Document document{
        .kind = "z", .title = {}, .sections = {StudyZPrecision(scene, settings)}};
    const ResultTable table = doc::TableOf(document, "drawn");
    const auto json = nlohmann::json::parse(doc::ToJsonText(document));
    nlohmann::json drawn;
    for (const auto& section : json["sections"][0]["sections"]) {
        if (section["tables"][0]["key"] == "drawn") drawn = section["tables"][0]["rows"];
    }
    EXPECT_EQ(drawn.size(), table.rows.size());
    std::istringstream csv(doc::ToCsv(table));
    std::string line, field;
    std::getline(csv, line);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        std::getline(csv, line);
        std::istringstream fields(line);
        for (const doc::Column& column : table.columns) {
            std::getline(fields, field, ',');
            const nlohmann::json& in_json = drawn[row][column.key];
            const doc::Cell& cell = table.At(row, column.key);
            if (const auto* text = std::get_if<std::string>(&cell)) {
                EXPECT_EQ(field, *text);
                EXPECT_EQ(in_json, *text);
            } else {
                EXPECT_EQ(std::stod(field), doc::NumberOf(cell));
                EXPECT_EQ(in_json.get<double>(), doc::NumberOf(cell));
            }
        }
    }
    return table;
}

/// host, product, order, clip, format, far, distance_m, rms_mm, worst_mm, mean_mm: of the CSV.
inline ResultTable ZErrorTable(const Scene& scene, const ZPrecisionSettings& settings) {
    const ResultTable table =
        read_results::TableIn(StudyZPrecision(scene, settings), "z_error");
    ResultTable read = table;
    read.rows.clear();
    std::istringstream csv(doc::ToCsv(table));
    std::string line, field;
    std::getline(csv, line);
    EXPECT_EQ(line, "format,far,host,product,order,clip,distance_m,rms_mm,worst_mm,mean_mm");
    while (std::getline(csv, line)) {
        std::istringstream fields(line);
        std::vector<doc::Cell> row;
        while (std::getline(fields, field, ',')) {
            row.push_back(row.size() < 6 ? doc::Cell(field) : doc::Cell(std::stod(field)));
        }
        read.Add(std::move(row));
    }
    return read;
}

/// The whole report of a scene.
struct ReportResults {
    ResultTable views;  ///< camera, rms_standard_error_v, rms_standard_error_near
    /// technique, view ("all views"), truth, region, ms, mse, rmse, ssim, recalibrated_rmse
    ResultTable scores;
    ResultTable traffic;  ///< technique, size_px, pass, bytes_read, bytes_written
    ResultTable flicker;  ///< As FlickerTable.
    std::string closest, closest_recalibrated;
    /// As people read them: the page with its tags, but those of intervals; of the terminal the
    /// parts of a broken table side by side.
    std::string page, terminal;
    std::vector<std::pair<std::string, Measured>> times;  ///< Each that is told, with its name.
};

namespace read_results {

inline std::string Without(std::string text, const std::string& what) {
    for (std::size_t at; (at = text.find(what)) != std::string::npos;) {
        text.erase(at, what.size());
    }
    return text;
}

/// Lines that begin with the same word as one, where the first of them stands.
inline std::string SideBySide(const std::string& text) {
    std::vector<std::pair<std::string, std::string>> lines;
    std::istringstream all(text);
    for (std::string line, word; std::getline(all, line);) {
        std::istringstream(line) >> word;
        line.erase(0, line.find_first_not_of(' '));
        const auto same =
            std::ranges::find(lines, word, &std::pair<std::string, std::string>::first);
        if (same == lines.end()) {
            lines.emplace_back(word, line);
        } else {
            same->second += " " + line;
        }
    }
    std::string joined;
    for (const auto& [word, line] : lines) joined += line + "\n";
    return joined;
}

}  // namespace read_results

inline ReportResults ResultsOf(const doc::Document& report) {
    const ResultTable& closest = doc::TableOf(report, "closest");
    ReportResults results{doc::TableOf(report, "views"),
                          doc::TableOf(report, "scores"),
                          {},
                          {},
                          TextAt(closest, 0, "technique"),
                          TextAt(closest, 1, "technique"),
                          read_results::Without(doc::ToHtml(report), "<span class=\"spread\">"),
                          read_results::SideBySide(doc::ToTerminal(InBrief(report))),
                          {}};
    results.page = read_results::Without(std::move(results.page), "</span>");
    const auto add = [&](const std::string& name, const doc::Cell& cell) {
        if (const auto* m = std::get_if<Measured>(&cell)) results.times.push_back({name, *m});
    };
    read_results::ForEachTable(report.sections, [&](const doc::Table& table) {
        if (table.key == "time_passes") results.traffic = table;
        if (table.key == "flicker") results.flicker = table;
        for (std::size_t r = 0; r < table.rows.size(); ++r) {
            for (const doc::Column& column : table.columns) {
                if (column.role != doc::Role::kTime) continue;
                add(table.key + " " + std::to_string(r) + " " + column.key,
                    table.At(r, column.key));
            }
        }
    });
    for (const char* key : {"raster_ms", "copy_gb_per_s", "mrays_per_s"}) {
        add(key, doc::FactOf(report, key));
    }
    return results;
}

}  // namespace plumb
