// What depth buffers keep of z and of normals: figures 3 and 4 of [McGuire12] made again.
#pragma once

#include "core/monitor.h"
#include "core/scene.h"
#include "reports/document.h"
#include "screen_space/raster/z_precision.h"

namespace plumb {

struct ZPrecisionSettings {
    ZStudySettings curves;
    int width_px = 1920, height_px = 1080;  ///< Of the scene's pictures.
    double near_m = 0.1, far_m = 200;       ///< Of the scene's depth buffers.
};

/// The paper's claims, to stand beside the worst cases.
inline constexpr double kPaperWorstZM = 0.002, kPaperWorstNormalDeg = 0.2;

/// Figure 3 for all 112 ways (tables z_error, z_greatest); figure 4 for every camera of the scene,
/// each depth format, an infinite and a finite far plane, vertices in float (what a GPU does) and
/// in double (what the buffer alone loses): table drawn.
doc::Section StudyZPrecision(const Scene& scene, const ZPrecisionSettings& settings,
                             Monitor& monitor = SilentMonitor());

}  // namespace plumb
