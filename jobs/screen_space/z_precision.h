// What depth buffers keep of z and of normals, measured and written down: figures 3 and 4 of
// [McGuire12] made again.
#pragma once

#include <filesystem>

#include "core/monitor.h"
#include "core/scene.h"
#include "reports/z_precision_report.h"
#include "screen_space/raster/z_precision.h"

namespace plumb {

struct ZPrecisionSettings {
    ZStudySettings curves;
    int width_px = 1920, height_px = 1080;  ///< Of the scene's pictures.
    double near_m = 0.1, far_m = 200;       ///< Of the scene's depth buffers.
};

/// Figure 3 for all 112 ways; figure 4 for every camera of the scene, each depth format, an
/// infinite and a finite far plane, vertices in float (what a GPU does) and in double (what the
/// buffer alone loses).
ZPrecisionReport StudyZPrecision(const Scene& scene, const ZPrecisionSettings& settings,
                                 Monitor& monitor = SilentMonitor());

/// z_precision.json, z_error.csv and normal_error.csv.
void WriteZPrecision(const std::filesystem::path& folder, const ZPrecisionReport& report);

}  // namespace plumb
