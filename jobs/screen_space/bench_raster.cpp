#include "jobs/screen_space/bench_raster.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/parallel.h"
#include "core/time_in_turns.h"
#include "jobs/bench_facts.h"
#include "jobs/memory_copy.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/near_plane.h"

namespace plumb {

Mesh TrianglesOfSize(double legs_px, std::int64_t count, const Camera& camera) {
    Mesh mesh;
    const std::int64_t a_row = std::int64_t((camera.width_px - 4) / legs_px);
    const double tan = std::tan(camera.fov_rad / 2) / (0.5 * camera.height_px);
    for (std::int64_t k = 0; k < count; ++k) {
        const double t = 1.5 - 0.5 * double(k) / double(count);
        // Off the pixels' grid, so that sizes are not whole by accident.
        const double x = 1.3 + legs_px * double(k % a_row);
        const double y = 1.7 + legs_px * double(k / a_row % a_row);
        const std::uint32_t first = std::uint32_t(mesh.vertices_m.size());
        for (const auto& [dx, dy] : {std::pair{0.0, 0.0}, {legs_px, 0.0}, {0.0, legs_px}}) {
            mesh.vertices_m.push_back(Vec3(t * tan * (x + dx - 0.5 * camera.width_px), t,
                                           t * tan * (0.5 * camera.height_px - y - dy))
                                          .cast<float>());
        }
        mesh.quads.push_back({first, first + 1, first + 2, first + 2});
    }
    return mesh;
}

namespace {

constexpr int kSheetPx = 1000;  // Picture of the triangles of one size.

std::vector<doc::Cell> TriangleRow(double legs_px, const RasterBenchSettings& settings,
                                   const RunContext& run) {
    const Camera camera{.position_m = {0, 0, 0},
                        .target_m = {0, 1, 0},
                        .width_px = kSheetPx,
                        .height_px = kSheetPx};
    const double pixels_each = 0.5 * legs_px * legs_px;
    const auto triangles = std::int64_t(std::clamp(1e8 / pixels_each, 1000.0, 200000.0));
    const Mesh mesh = TrianglesOfSize(legs_px, triangles, camera);
    const double pixels = pixels_each * double(triangles);
    Rasterizer rasterizer;
    MemoryCopy copy(kLargeCopyBytes);
    const TurnTimes times = TimeInTurns(
        {{.run = [&] { rasterizer.Draw(mesh, camera, {}, false); }}, {.run = std::ref(copy)}},
        settings.rounds, run.clock, run.monitor);
    // 4 bytes read and 4 written a pixel.
    const double copies = 8 * pixels / copy.Bytes();
    return {legs_px, triangles, 1e-6 * times.Rate(0, double(triangles)),
            1e-6 * times.Rate(0, pixels), (1 / copies) * times.Ratio(0, 1)};
}

doc::Section TrianglesSection(const RasterBenchSettings& settings, const RunContext& run) {
    using doc::Better;
    doc::Table table{
        .key = "triangles",
        .columns = {{.key = "legs_px", .title = "Legs", .unit = "px", .role = doc::Role::kName},
                    {.key = "triangles", .title = "Triangles"},
                    TimeColumn("mtriangles_per_s", "Triangles", "M/s", Better::kMore),
                    TimeColumn("mpixels_per_s", "Pixels", "M/s", Better::kMore),
                    TimeColumn("of_copy", "Over copying 4 bytes a pixel", "")}};
    for (const double legs_px : settings.legs_px) {
        table.Add(TriangleRow(legs_px, settings, run));
    }
    return {.id = "triangles",
            .title = "Right triangles, depth alone, one thread",
            .tables = {std::move(table)}};
}

std::vector<doc::Cell> ViewRow(const Scene& scene, Camera camera,
                               const RasterBenchSettings& settings, const RunContext& run) {
    camera.width_px = settings.width_px;
    camera.height_px = settings.height_px;
    Rasterizer both, depth, whole;
    GBuffer g;
    const std::size_t pixels = std::size_t(camera.width_px) * std::size_t(camera.height_px);
    MemoryCopy copy(16 * pixels);  // Depth and triangle number, read and written.
    const TurnTimes times = TimeInTurns(
        {{.run = [&] { both.Draw(scene.mesh, camera, {}); }},
         {.run = [&] { depth.Draw(scene.mesh, camera, {}, false); }},
         {.run = [&] { DrawGBuffer(whole, scene, camera, SuitedTo(scene, camera), g); }},
         {.run = std::ref(copy)}},
        settings.rounds, run.clock, run.monitor);
    const std::vector<std::uint32_t>& seen = g.triangle.Pixels();
    const auto sky = std::count(seen.begin(), seen.end(), GBuffer::kSky);
    return {camera.name,
            1e3 * times.Seconds(0),
            1e3 * times.Seconds(1),
            1e3 * times.Seconds(2),
            times.Ratio(0, 3),
            1 - double(sky) / double(pixels)};
}

doc::Section ViewsSection(const Scene& scene, const RasterBenchSettings& settings,
                          const RunContext& run) {
    doc::Table table{
        .key = "views",
        .columns = {{.key = "view", .title = "View", .role = doc::Role::kName},
                    TimeColumn("visibility_ms", "Depth and triangle", "ms"),
                    TimeColumn("depth_ms", "Depth", "ms"),
                    TimeColumn("gbuffer_ms", "G-buffer", "ms"),
                    TimeColumn("of_copy", "Over copying depth and triangle", "",
                               doc::Better::kLess, "Of the time for depth and triangle."),
                    {.key = "covered",
                     .title = "Covered",
                     .meaning = "Share of the pixels that show a surface."}}};
    for (const Camera& camera : scene.cameras) {
        table.Add(ViewRow(scene, camera, settings, run));
    }
    return {.id = "views",
            .title = "Views of " + std::to_string(settings.width_px) + " x " +
                     std::to_string(settings.height_px) + " pixels, all threads",
            .tables = {std::move(table)}};
}

doc::Fact CopyFact(const std::string& key, const std::string& title, int rounds,
                   const RunContext& run) {
    MemoryCopy copy(kLargeCopyBytes);
    const TurnTimes times =
        TimeInTurns({{.run = std::ref(copy)}}, rounds, run.clock, run.monitor);
    return {TimeColumn(key, title, "GB/s", doc::Better::kMore),
            1e-9 * times.Rate(0, copy.Bytes())};
}

}  // namespace

doc::Document BenchRaster(const Scene& scene, const RasterBenchSettings& settings,
                          const RunContext& run) {
    std::int64_t triangles = 0;
    for (const auto& quad : scene.mesh.quads) triangles += quad[2] == quad[3] ? 1 : 2;
    doc::Document document{.kind = "bench_raster",
                           .title = "Speed of the rasterizer: " + scene.name,
                           .subtitle = std::to_string(triangles) + " triangles, " +
                                       std::to_string(scene.mesh.vertices_m.size()) +
                                       " vertices",
                           .provenance = doc::ProvenanceOf(run)};
    const int threads = ThreadCount();
    doc::Section views = ViewsSection(scene, settings, run);
    views.facts = BenchFacts(threads, settings.rounds);
    views.facts.push_back(
        CopyFact("copy_gb_per_s", "Copying memory, all threads", settings.rounds, run));
    SetThreadCount(1);
    doc::Section sizes = TrianglesSection(settings, run);
    sizes.facts.push_back(CopyFact("copy_one_thread_gb_per_s", "Copying memory, one thread",
                                   settings.rounds, run));
    SetThreadCount(threads);
    document.sections = {std::move(views), std::move(sizes)};
    return document;
}

}  // namespace plumb
