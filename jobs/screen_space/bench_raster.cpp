#include "jobs/screen_space/bench_raster.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

#include "core/error.h"
#include "core/parallel.h"
#include "screen_space/raster/draw_gbuffer.h"

namespace plumb {
namespace {

constexpr std::int64_t kCopyChunk = 1 << 20;
constexpr std::size_t kCopyBytes = std::size_t{1} << 27;  // Larger than any cache.
constexpr int kSheetPx = 1000;  // Picture of the triangles of one size.

double Median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

// Median times of several things done in turns.
std::vector<double> InTurns(const std::vector<std::function<void()>>& things, int rounds,
                            const Clock& clock, Monitor& monitor) {
    std::vector<std::vector<double>> seconds(things.size());
    for (int round = 0; round <= rounds; ++round) {
        for (std::size_t k = 0; k < things.size(); ++k) {
            if (monitor.Cancelled()) throw Interrupted();
            const double begin_s = clock();
            things[k]();
            if (round > 0) seconds[k].push_back(clock() - begin_s);
        }
    }
    std::vector<double> medians;
    for (std::vector<double>& s : seconds) medians.push_back(Median(std::move(s)));
    return medians;
}

class Copy {
  public:
    explicit Copy(std::size_t bytes) : from_(bytes, 1), to_(bytes) {}

    void operator()() {
        ParallelFor(
            std::int64_t(from_.size()), kCopyChunk, [&](std::int64_t begin, std::int64_t end) {
                std::memcpy(to_.data() + begin, from_.data() + begin, std::size_t(end - begin));
            });
    }
    double Bytes() const { return 2 * double(from_.size()); }

  private:
    std::vector<char> from_, to_;
};

// Right triangles side by side, sheet upon sheet, each a little nearer to the camera.
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

SizeBench BenchSize(double legs_px, const RasterBenchSettings& settings, const Clock& clock,
                    Monitor& monitor) {
    const Camera camera{.position_m = {0, 0, 0},
                        .target_m = {0, 1, 0},
                        .width_px = kSheetPx,
                        .height_px = kSheetPx};
    const double pixels_each = 0.5 * legs_px * legs_px;
    SizeBench bench;
    bench.legs_px = legs_px;
    bench.triangles = std::int64_t(std::clamp(1e8 / pixels_each, 1000.0, 200000.0));
    const Mesh mesh = TrianglesOfSize(legs_px, bench.triangles, camera);
    const double pixels = pixels_each * double(bench.triangles);
    Rasterizer rasterizer;
    Copy copy(kCopyBytes);
    const std::vector<double> seconds =
        InTurns({[&] { rasterizer.Draw(mesh, camera, {}, false); }, std::ref(copy)},
                settings.rounds, clock, monitor);
    bench.triangles_per_second = double(bench.triangles) / seconds[0];
    bench.pixels_per_second = pixels / seconds[0];
    bench.copy_ratio = seconds[0] / (seconds[1] * 8 * pixels / copy.Bytes());
    return bench;
}

ViewBench BenchView(const Scene& scene, Camera camera, const RasterBenchSettings& settings,
                    const Clock& clock, Monitor& monitor) {
    camera.width_px = settings.width_px;
    camera.height_px = settings.height_px;
    Rasterizer both, depth, whole;
    GBuffer g;
    const std::size_t pixels = std::size_t(camera.width_px) * std::size_t(camera.height_px);
    Copy copy(8 * pixels);
    const std::vector<double> seconds =
        InTurns({[&] { both.Draw(scene.mesh, camera, {}); },
                 [&] { depth.Draw(scene.mesh, camera, {}, false); },
                 [&] { DrawGBuffer(whole, scene, camera, {}, g); }, std::ref(copy)},
                settings.rounds, clock, monitor);
    const std::vector<std::uint32_t>& seen = g.triangle.Pixels();
    return {.camera = camera.name,
            .visibility_s = seconds[0],
            .depth_s = seconds[1],
            .gbuffer_s = seconds[2],
            .copy_s = seconds[3],
            .covered = 1 - double(std::count(seen.begin(), seen.end(), GBuffer::kSky)) /
                               double(pixels)};
}

}  // namespace

RasterBench BenchRaster(const Scene& scene, const RasterBenchSettings& settings,
                        const Clock& clock, Monitor& monitor) {
    RasterBench bench;
    bench.scene = scene.name;
    for (const auto& quad : scene.mesh.quads) bench.triangles += quad[2] == quad[3] ? 1 : 2;
    bench.vertices = std::int64_t(scene.mesh.vertices_m.size());
    bench.width_px = settings.width_px;
    bench.height_px = settings.height_px;
    bench.threads = ThreadCount();
    bench.rounds = settings.rounds;
    for (const Camera& camera : scene.cameras) {
        bench.views.push_back(BenchView(scene, camera, settings, clock, monitor));
    }
    Copy copy(kCopyBytes);
    bench.copy_bytes_per_second =
        copy.Bytes() / InTurns({std::ref(copy)}, settings.rounds, clock, monitor)[0];
    SetThreadCount(1);
    for (const double legs_px : settings.legs_px) {
        bench.sizes.push_back(BenchSize(legs_px, settings, clock, monitor));
    }
    bench.copy_one_thread_bytes_per_second =
        copy.Bytes() / InTurns({std::ref(copy)}, settings.rounds, clock, monitor)[0];
    SetThreadCount(bench.threads);
    return bench;
}

}  // namespace plumb
