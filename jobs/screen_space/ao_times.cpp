#include "jobs/screen_space/ao_times.h"

#include <algorithm>
#include <functional>

#include "core/parallel.h"
#include "jobs/screen_space/ao_sweep.h"
#include "screen_space/raster/draw_gbuffer.h"

namespace plumb {
namespace {

constexpr std::size_t kCopyBytes = std::size_t{1} << 27;  // Larger than any cache.
constexpr std::int64_t kCopyChunk = 1 << 20;

double Median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

Camera SizedAs(Camera camera, const TimedSize& size) {
    camera.width_px = size.width_px;
    camera.height_px = size.height_px;
    return camera;
}

double SamplingSeconds(const GBuffer& gbuffer, const SaoOptions& options, int rounds,
                       const PassClock& clock) {
    const ZPyramid pyramid = BuildZPyramid(gbuffer, options);
    SamplePass(gbuffer, pyramid, options);
    std::vector<double> seconds;
    for (int round = 0; round < rounds; ++round) {
        const double begin_s = clock();
        SamplePass(gbuffer, pyramid, options);
        seconds.push_back(clock() - begin_s);
    }
    return Median(seconds);
}

}  // namespace

double BytesPerPixel(const SaoOptions& options) {
    constexpr double kFloat = 4, kPyramid = 4 * 4.0 / 3;
    double bytes = kFloat + kPyramid;  // z in, its pyramid out
    bytes += kPyramid + kFloat;        // the pyramid in, A out
    if (options.sampling.normals != NormalSource::kDepth) bytes += 3 * kFloat;
    if (options.quad_filter) bytes += 3 * kFloat;  // A and z in, A out
    bytes += 4 * kFloat;                           // A and z in, A and key out
    for (const bool on : {options.blur_x, options.blur_y}) {
        if (on) bytes += 3 * kFloat;  // A and key in, A out
    }
    return bytes;
}

double CopyBytesPerSecond(int rounds, const PassClock& clock) {
    std::vector<char> from(kCopyBytes, 1), to(kCopyBytes);
    std::vector<double> seconds;
    for (int round = 0; round <= rounds; ++round) {
        const double begin_s = clock();
        ParallelFor(std::int64_t(kCopyBytes), kCopyChunk,
                    [&](std::int64_t begin, std::int64_t end) {
                        std::copy(from.begin() + begin, from.begin() + end, to.begin() + begin);
                    });
        if (round > 0) seconds.push_back(clock() - begin_s);  // The first warms up.
    }
    return 2 * double(kCopyBytes) / Median(seconds);
}

std::vector<PassTimes> TimePasses(const Scene& scene, const Camera& camera,
                                  const RayCaster& caster, double radius_m, int rounds,
                                  double copy_bytes_per_second, const PassClock& clock,
                                  Monitor& monitor) {
    std::vector<PassTimes> all;
    double done = 0;
    for (const TimedSize& size : kPaperSizes) {
        const Camera sized = SizedAs(camera, size);
        const GBuffer gbuffer = DrawGBuffer(scene, sized, {.guard_px = size.guard_px});
        const double seen = double(
            std::count_if(gbuffer.triangle.Pixels().begin(), gbuffer.triangle.Pixels().end(),
                          [](std::uint32_t t) { return t != GBuffer::kSky; }));
        for (const char* preset : {"supplement2012", "alchemy"}) {
            const SaoOptions options = SaoWith(preset, {.radius_m = radius_m});
            PassTimes times{.technique = preset,
                            .width_px = size.width_px,
                            .height_px = size.height_px,
                            .guard_px = size.guard_px,
                            .passes = {}};
            const std::vector<Pass> passes = Timed(
                SaoTechnique(preset, options), {gbuffer, scene, sized, caster}, rounds, clock);
            for (const Pass& pass : passes) times.passes.push_back({pass.name, pass.seconds});
            times.seconds = TotalSeconds(passes);
            times.bytes_per_pixel = BytesPerPixel(options);
            times.ns_per_visible = seen > 0 ? times.seconds * 1e9 / seen : 0;
            times.copies = times.seconds * copy_bytes_per_second /
                           (times.bytes_per_pixel * double(gbuffer.z_m.Pixels().size()));
            all.push_back(std::move(times));
        }
        monitor.Progress("times", done += 1.0 / double(std::size(kPaperSizes)));
    }
    return all;
}

std::vector<RadiusTime> TimeRadii(const Scene& scene, const Camera& camera,
                                  const TimedSize& size, int rounds, const PassClock& clock,
                                  Monitor& monitor) {
    const Camera sized = SizedAs(camera, size);
    const GBuffer gbuffer = DrawGBuffer(scene, sized, {.guard_px = size.guard_px});
    std::vector<RadiusTime> times;
    const double radii_m[] = {0.1, 0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75, 2};
    for (const double radius_m : radii_m) {
        SaoOptions sao = SaoWith("supplement2012", {.radius_m = radius_m, .samples = 9});
        RadiusTime time{.radius_m = radius_m};
        time.with_pyramid_s = SamplingSeconds(gbuffer, sao, rounds, clock);
        sao.sampling.taps.coarsest_level = 0;
        time.without_pyramid_s = SamplingSeconds(gbuffer, sao, rounds, clock);
        time.alchemy_s =
            SamplingSeconds(gbuffer, SaoWith("alchemy", {.radius_m = radius_m}), rounds, clock);
        times.push_back(time);
        monitor.Progress("times by radius", double(times.size()) / double(std::size(radii_m)));
    }
    return times;
}

}  // namespace plumb
