#include "jobs/screen_space/render_scene.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/error.h"
#include "io/image_io.h"
#include "rays/embree/embree_caster.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/near_plane.h"

namespace plumb {
namespace {

constexpr double kGuardShare = 128.0 / 720;

template <class T, class Value>
NamedChannel Channel(const std::string& name, const Image<T>& drawn, const View& view,
                     const Value& value) {
    const Image<T> shown = Shown(drawn, view);
    NamedChannel channel{name, Image<float>(shown.Width(), shown.Height())};
    for (std::size_t p = 0; p < shown.Pixels().size(); ++p) {
        channel.pixels.Pixels()[p] = value(shown.Pixels()[p]);
    }
    return channel;
}

std::vector<NamedChannel> Geometry(const GBuffer& g) {
    std::vector<NamedChannel> channels{
        Channel("depth_m", g.z_m, g.view, [](float z) { return -z; })};
    for (int c = 0; c < 3; ++c) {
        channels.push_back(Channel("normal." + std::string(1, "xyz"[c]), g.shading_normal,
                                   g.view, [c](const Vec3f& n) { return n[c]; }));
        channels.push_back(Channel("albedo." + std::string(1, "RGB"[c]), g.albedo, g.view,
                                   [c](const Rgb& rho) { return rho[std::size_t(c)]; }));
    }
    // As bits: a float holds whole numbers up to 2^24 only.
    channels.push_back(Channel("triangle_bits", g.triangle, g.view,
                               [](std::uint32_t t) { return std::bit_cast<float>(t); }));
    return channels;
}

// "blur x" as part of a file's or a channel's name.
std::string Plain(std::string name) {
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

}  // namespace

int GuardPx(int guard_px, int height_px) {
    if (guard_px < -1 || guard_px > 4096) {
        throw Error(MustBe("guard", guard_px, "in [0, 4096], or -1 for the paper's share"));
    }
    return guard_px >= 0 ? guard_px : int(std::lround(kGuardShare * height_px));
}

RenderResult RenderScene(const LoadedScene& loaded, const RenderJob& job,
                         const RunContext& run) {
    const TechniqueSettings settings =
        Over(SettingsOf(loaded, job.technique, {}), job.technique, job.values);
    const Technique technique = TechniqueNamed(job.technique, settings);
    const Scene& scene = loaded.scene;
    Camera camera = CameraNamed(scene, job.camera);
    if (job.width_px != 0) camera.width_px = job.width_px;
    if (job.height_px != 0) camera.height_px = job.height_px;
    Validate(camera, scene.name + ": camera " + camera.name);
    const int guard_px = GuardPx(job.guard_px, camera.height_px);

    RenderResult result;
    const double begin_s = run.clock();
    const GBuffer gbuffer = DrawGBuffer(scene, camera, SuitedTo(scene, camera, guard_px));
    result.seconds.push_back({"G-buffer", run.clock() - begin_s});
    const EmbreeCaster caster(scene);
    run.monitor.Progress("passes", 0.5);
    const std::vector<Pass> passes = technique.run({gbuffer, scene, camera, caster}, run.clock);
    if (run.monitor.Cancelled()) throw Interrupted();

    std::vector<NamedChannel> channels = Geometry(gbuffer);
    for (const Pass& pass : passes) {
        result.seconds.push_back({pass.name, pass.seconds});
        if (pass.A.Empty()) continue;
        channels.push_back({"A." + Plain(pass.name), Shown(pass.A, gbuffer.view)});
        result.pictures.push_back(run.folder / (Plain(pass.name) + ".png"));
        WritePreview(result.pictures.back(), channels.back().pixels);
    }
    const Image<std::uint32_t> seen = Shown(gbuffer.triangle, gbuffer.view);
    const Image<float>& A = channels.back().pixels;
    double sum = 0, n = 0;
    for (std::size_t p = 0; p < seen.Pixels().size(); ++p) {
        if (seen.Pixels()[p] == GBuffer::kSky) continue;
        sum += A.Pixels()[p];
        ++n;
    }
    result.mean = n > 0 ? sum / n : 1;
    result.exr = run.folder / "render.exr";
    WriteExr(result.exr, channels,
             {{"plumb:version", run.version},
              {"plumb:command", run.command},
              {"plumb:scene", scene.name},
              {"plumb:scene_sha256", loaded.digest},
              {"plumb:camera", camera.name},
              {"plumb:near_plane_m", std::to_string(gbuffer.range.near_m)},
              {"plumb:technique", technique.name}});
    return result;
}

}  // namespace plumb
