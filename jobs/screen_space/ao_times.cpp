#include "jobs/screen_space/ao_times.h"

#include <algorithm>

#include "core/parallel.h"
#include "core/time_in_turns.h"
#include "jobs/screen_space/sao_traffic.h"
#include "jobs/screen_space/time_techniques.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/near_plane.h"

namespace plumb {
namespace {

constexpr std::size_t kCopyBytes = std::size_t{1} << 27;  // Larger than any cache.
constexpr std::int64_t kCopyChunk = 1 << 20;

Camera SizedAs(Camera camera, const TimedSize& size) {
    camera.width_px = size.width_px;
    camera.height_px = size.height_px;
    return camera;
}

}  // namespace

Measured CopyRate(int rounds, const Clock& clock) {
    std::vector<char> from(kCopyBytes, 1), to(kCopyBytes);
    const auto copy = [&] {
        ParallelFor(std::int64_t(kCopyBytes), kCopyChunk,
                    [&](std::int64_t begin, std::int64_t end) {
                        std::copy(from.begin() + begin, from.begin() + end, to.begin() + begin);
                    });
    };
    return TimeInTurns({{copy}}, rounds, clock).Rate(0, 2 * double(kCopyBytes));
}

std::vector<PassTimes> TimePasses(const Scene& scene, const Camera& camera,
                                  const RayCaster& caster, std::span<const NamedSao> saos,
                                  std::span<const TimedSize> sizes, int rounds,
                                  double copy_bytes_per_second, const Clock& clock,
                                  Monitor& monitor) {
    std::vector<Technique> techniques;
    for (const NamedSao& sao : saos) techniques.push_back(SaoTechnique(sao.name, sao.options));
    std::vector<PassTimes> all;
    double done = 0;
    for (const TimedSize& size : sizes) {
        const Camera sized = SizedAs(camera, size);
        const GBuffer gbuffer =
            DrawGBuffer(scene, sized, SuitedTo(scene, sized, size.guard_px));
        const TechniqueInput in{gbuffer, scene, sized, caster};
        std::vector<TechniqueTurn> turns;
        for (const Technique& technique : techniques) turns.push_back({&technique, &in});
        const std::vector<TimedTechnique> timed = TimeTechniques(turns, rounds, clock, monitor);
        const double shown = double(size.width_px) * size.height_px;
        for (std::size_t k = 0; k < saos.size(); ++k) {
            PassTimes times{.technique = saos[k].name,
                            .width_px = size.width_px,
                            .height_px = size.height_px,
                            .guard_px = size.guard_px,
                            .passes = timed[k].passes,
                            .seconds = timed[k].seconds,
                            .traffic = SaoTraffic(gbuffer, saos[k].options)};
            const double bytes = TotalBytes(times.traffic);
            times.bytes_per_pixel = bytes / shown;
            times.ns_per_visible = times.seconds.value * 1e9 / shown;
            times.copies = times.seconds.value * copy_bytes_per_second / bytes;
            all.push_back(std::move(times));
        }
        monitor.Progress("times", done += 1.0 / double(sizes.size()));
    }
    return all;
}

std::vector<RadiusTime> TimeRadii(const Scene& scene, const Camera& camera,
                                  const TimedSize& size, int rounds, const Clock& clock,
                                  Monitor& monitor) {
    const Camera sized = SizedAs(camera, size);
    const GBuffer gbuffer = DrawGBuffer(scene, sized, SuitedTo(scene, sized, size.guard_px));
    std::vector<RadiusTime> times;
    const double radii_m[] = {0.1, 0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75, 2};
    for (const double radius_m : radii_m) {
        const SaoOptions with = SaoWith("supplement2012", {.radius_m = radius_m, .samples = 9});
        SaoOptions without = with;
        without.sampling.taps.coarsest_level = 0;
        const SaoOptions alchemy = SaoWith("alchemy", {.radius_m = radius_m});
        const ZPyramid pyramid = BuildZPyramid(gbuffer, with),
                       full = BuildZPyramid(gbuffer, without);
        const TurnTimes turns = TimeInTurns({{[&] { SamplePass(gbuffer, pyramid, with); }},
                                             {[&] { SamplePass(gbuffer, full, without); }},
                                             {[&] { SamplePass(gbuffer, full, alchemy); }}},
                                            rounds, clock, monitor);
        times.push_back({radius_m, turns.Seconds(0), turns.Seconds(1), turns.Seconds(2)});
        monitor.Progress("times by radius", double(times.size()) / double(std::size(radii_m)));
    }
    return times;
}

}  // namespace plumb
