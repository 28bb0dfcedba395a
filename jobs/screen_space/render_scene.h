// One technique on one view, every pass as a picture.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/run_context.h"
#include "jobs/screen_space/technique.h"
#include "jobs/truth/load_scene.h"

namespace plumb {

struct RenderJob {
    std::string technique = "sao-supplement2012";
    KnobValues values;                ///< Not given: the scene file's, else as published.
    std::string camera;               ///< Empty = the scene's first.
    int width_px = 0, height_px = 0;  ///< 0 = the camera's own. [0, 16384]
    int guard_px = -1;                ///< -1 = 128 px at 720 rows and in proportion. [-1, 4096]
};

struct RenderResult {
    std::vector<std::pair<std::string, double>> seconds;  ///< Pass by pass, the G-buffer first.
    double mean = 0;                                      ///< A over what is seen.
    std::filesystem::path exr;
    std::vector<std::filesystem::path> pictures;
};

/// 128 px at 720 rows and in proportion [McGuire12 table 3], if `guard_px` is -1.
int GuardPx(int guard_px, int height_px);

/// Writes render.exr (depth_m, normal.xyz, albedo.RGB, triangle_bits and A after every pass) and a
/// PNG of every pass into `folder`.
RenderResult RenderScene(const LoadedScene& loaded, const RenderJob& job,
                         const RunContext& run);

}  // namespace plumb
