// The speed of the reference rasterizer against this machine's own memory, in one run: every view
// of a scene on all threads, beside copying its depth and triangle numbers; and right triangles of
// one size that share no vertex, each nearer than the ones before, to depth alone on one thread,
// beside copying 4 bytes a drawn pixel.
#pragma once

#include <cstdint>
#include <vector>

#include "core/camera.h"
#include "core/mesh.h"
#include "core/run_context.h"
#include "core/scene.h"
#include "reports/document.h"

namespace plumb {

struct RasterBenchSettings {
    int width_px = 1920, height_px = 1080;
    int rounds = 7;  ///< After one that warms up. [1, ...)
    std::vector<double> legs_px = {1, 10, 25, 50, 100, 200, 500};
};

/// All cameras of the scene, then triangles of each size.
doc::Document BenchRaster(const Scene& scene, const RasterBenchSettings& settings,
                          const RunContext& run);

/// What is timed: `count` right triangles with legs of that length on the screen, side by side,
/// sheet upon sheet, each a little nearer to the camera, which is at the origin and looks along +y.
Mesh TrianglesOfSize(double legs_px, std::int64_t count, const Camera& camera);

}  // namespace plumb
