// A scene's report: every technique against the truth, and every step of one against the last.
//
//       scene -> truth of the view -> G-buffer -> techniques -> scores
//             -> error budget, error against time, times a pass, time against radius, flicker
//
// Source   what is compared: [McGuire12] tables 2 and 3, figure 5; the budget: ours.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/monitor.h"
#include "jobs/screen_space/technique.h"
#include "jobs/truth/load_scene.h"
#include "reports/scene_report.h"

namespace plumb {

struct SceneReportJob {
    std::string camera;               ///< Empty = the scene's first.
    int width_px = 0, height_px = 0;  ///< 0 = the camera's own. [0, 16384]
    int guard_px = -1;                ///< -1 = 128 px at 720 rows and in proportion. [-1, 4096]
    double radius_m = 1.5;            ///< r of every technique. (0, infinity)
    std::vector<std::string> techniques;    ///< Empty = all of TechniqueNames().
    std::string budget = "supplement2012";  ///< The preset whose error is split.
    int spp = 256;                          ///< Rays a pixel of the truth: a power of two.
    std::uint64_t seed = 1;
    int rounds = 5;       ///< Of every timing; medians count. [1, 1000]
    bool studies = true;  ///< Budget, sweep, times, radii and flicker too.
    std::filesystem::path
        pictures;  ///< Folder for PNG pictures, in the page too; empty = none.
};

/// Throws Error, naming field, value and rule.
void Validate(const SceneReportJob& job);

SceneReport ReportScene(const LoadedScene& loaded, const SceneReportJob& job,
                        const std::string& tool_version, const std::string& command,
                        const PassClock& clock, Monitor& monitor = SilentMonitor());

/// report.html, report.json, scores.csv and sweep.csv. Returns the page's path.
std::filesystem::path WriteSceneReport(const std::filesystem::path& folder,
                                       const SceneReport& report);

}  // namespace plumb
