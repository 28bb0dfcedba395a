// A scene's report: every technique against the truth, and every step of one against the last.
//
//       scene -> of every camera: truth, G-buffer, techniques, scores -> figures over the views
//             -> of the first: error budget, error against time, times a pass, time against radius,
//                flicker
//
// Source   what is compared: [McGuire12] tables 2 and 3, figure 5; the budget: ours.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/run_context.h"
#include "core/time_in_turns.h"
#include "jobs/screen_space/ao_times.h"
#include "jobs/screen_space/technique.h"
#include "jobs/screen_space/temporal_study.h"
#include "jobs/screen_space/z_precision.h"
#include "jobs/truth/load_scene.h"
#include "reports/document.h"

namespace plumb {

struct SceneReportJob {
    std::vector<std::string> cameras;  ///< Empty = all of the scene; the first has the studies.
    int width_px = 0, height_px = 0;   ///< 0 = the camera's own. [0, 16384]
    int guard_px = -1;               ///< -1 = 128 px at 720 rows and in proportion. [-1, 4096]
    std::optional<double> radius_m;  ///< r of the truth and of every technique. (0, infinity)
    ValuesByTechnique set;  ///< What the command line turns; wins over radius_m and the file.
    std::vector<std::string> techniques;    ///< Empty = all of TechniqueNames().
    std::string budget = "supplement2012";  ///< The preset whose error is split.
    int spp = 256;  ///< Rays a pixel of the first view's truth: a power of two. [16, 2^20]
    std::optional<int> other_spp;  ///< Of the other views'; not given: a quarter, at least 16.
    std::uint64_t seed = 1;
    int rounds = kTimedRounds;  ///< Of every timing; medians count. [1, 1000]
    bool studies = true;        ///< Budget, sweep, times, radii and flicker too.
    std::vector<TimedSize> sizes{std::begin(kPaperSizes),
                                 std::end(kPaperSizes)};  ///< Of times.
    TimedSize radii_size = kFigure5Size;                  ///< Of times against the radius.
    int budget_stride_px = 8;                             ///< Of the budget's pixels. [1, 4096]
    TemporalOptions flicker;  ///< Its radius and seed are the report's.
    ZPrecisionSettings precision;
    std::filesystem::path
        pictures;  ///< Folder for PNG pictures, in the page too; empty = none.
};

/// Radius of the truth, if the command line names none; that of a technique is then its own.
inline constexpr double kReportRadiusM = 1.5;

/// Throws Error, naming field, value and rule.
void Validate(const SceneReportJob& job);

doc::Document ReportScene(const LoadedScene& loaded, const SceneReportJob& job,
                          const RunContext& run);

/// What a terminal shows of it: the findings and the table of techniques. The rest is long.
doc::Document InBrief(doc::Document report);

/// report.html, report.json, report.csv, scores.csv and, with studies, sweep.csv. Returns the page's
/// path.
std::filesystem::path WriteSceneReport(const std::filesystem::path& folder,
                                       const doc::Document& report);

}  // namespace plumb
