// How fast the reference rasterizer is, as ratios that travel between machines.
//
// Every time is the median of the rounds of one run. Beside it stands the time that copying the
// same bytes takes, measured in turns with it, so that a machine that slows down slows both.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <string>
#include <vector>

namespace plumb {

/// One view of the scene, all threads.
struct ViewBench {
    std::string camera;
    double visibility_s = 0;  ///< Depth and triangle number.
    double depth_s = 0;       ///< Depth alone.
    double gbuffer_s = 0;     ///< All of a G-buffer.
    double copy_s = 0;        ///< Copying depth and triangle number of the picture.
    double covered = 0;       ///< Share of the pixels that show a surface.
};

/// Right triangles of one size that share no vertex, each nearer than the ones before, to depth
/// alone, one thread.
struct SizeBench {
    double legs_px = 0;
    std::int64_t triangles = 0;
    double triangles_per_second = 0, pixels_per_second = 0;
    double copy_ratio = 0;  ///< Time over that of copying 4 bytes a drawn pixel.
};

struct RasterBench {
    std::string scene;
    std::int64_t triangles = 0, vertices = 0;
    int width_px = 0, height_px = 0, threads = 0, rounds = 0;
    std::vector<ViewBench> views;
    std::vector<SizeBench> sizes;
    double copy_bytes_per_second = 0;             ///< Read + written, all threads.
    double copy_one_thread_bytes_per_second = 0;  ///< The same, one thread.
};

nlohmann::ordered_json ToJson(const RasterBench& bench);

/// The same as the text of a file; see reports/json_text.h.
std::string ToJsonText(const RasterBench& bench);
void WriteTable(std::ostream& out, const RasterBench& bench);

}  // namespace plumb
