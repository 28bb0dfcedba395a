#include "jobs/screen_space/bench_ao.h"

#include <algorithm>
#include <functional>

#include "core/error.h"
#include "core/parallel.h"
#include "jobs/screen_space/sao_traffic.h"
#include "screen_space/raster/draw_gbuffer.h"

namespace plumb {
namespace {

Spread3 SpreadOf(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return {values[values.size() / 2], values.front(), values.back()};
}

std::vector<double> Ratios(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> ratios;
    for (std::size_t k = 0; k < a.size(); ++k) ratios.push_back(a[k] / b[k]);
    return ratios;
}

// seconds[k][round] of every work, one after the other in every round; the first round warms up.
std::vector<std::vector<double>> InTurns(const std::vector<std::function<void()>>& works,
                                         int rounds, const PassClock& clock) {
    std::vector<std::vector<double>> seconds(works.size());
    for (int round = 0; round <= rounds; ++round) {
        for (std::size_t k = 0; k < works.size(); ++k) {
            const double begin_s = clock();
            works[k]();
            if (round > 0) seconds[k].push_back(clock() - begin_s);
        }
    }
    return seconds;
}

AoSizeBench BenchSize(const Scene& scene, Camera camera, const TimedSize& size,
                      const AoBenchSettings& settings, double copy_bytes_per_second,
                      const PassClock& clock) {
    camera.width_px = size.width_px;
    camera.height_px = size.height_px;
    const GBuffer gbuffer = DrawGBuffer(scene, camera, {.guard_px = size.guard_px});
    const SaoOptions sao = SaoWith("supplement2012", {.radius_m = settings.radius_m});
    const SaoOptions alchemy = SaoWith("alchemy", {.radius_m = settings.radius_m});
    const SaoOptions near = SaoWith("supplement2012", {.radius_m = 0.1, .samples = 9});
    const SaoOptions far =
        SaoWith("supplement2012", {.radius_m = settings.radius_m, .samples = 9});
    SaoOptions full = far;
    full.sampling.taps.coarsest_level = 0;
    const ZPyramid pyramid = BuildZPyramid(gbuffer, far), none = BuildZPyramid(gbuffer, full),
                   for_alchemy = BuildZPyramid(gbuffer, alchemy);
    SaoScratch sao_memory, alchemy_memory;  // As an engine keeps its targets.
    const auto s = InTurns(
        {[&] { RunSao(gbuffer, sao, sao_memory); },
         [&] { RunSao(gbuffer, alchemy, alchemy_memory); },
         [&] { SamplePass(gbuffer, pyramid, near); },
         [&] { SamplePass(gbuffer, pyramid, far); }, [&] { SamplePass(gbuffer, none, full); },
         [&] { SamplePass(gbuffer, for_alchemy, alchemy); }},
        settings.rounds, clock);
    AoSizeBench bench;
    bench.width_px = size.width_px;
    bench.height_px = size.height_px;
    bench.guard_px = size.guard_px;
    bench.sao_s = SpreadOf(s[0]);
    bench.alchemy_s = SpreadOf(s[1]);
    bench.sample_near_s = SpreadOf(s[2]);
    bench.sample_far_s = SpreadOf(s[3]);
    bench.sample_far_full_s = SpreadOf(s[4]);
    bench.alchemy_sample_s = SpreadOf(s[5]);
    bench.radius_ratio = SpreadOf(Ratios(s[3], s[2]));
    bench.pyramid_ratio = SpreadOf(Ratios(s[4], s[3]));
    bench.alchemy_ratio = SpreadOf(Ratios(s[1], s[0]));
    bench.bytes_per_pixel =
        TotalBytes(SaoTraffic(gbuffer, sao)) / double(gbuffer.z_m.Pixels().size());
    bench.copies = bench.sao_s.median * copy_bytes_per_second /
                   (bench.bytes_per_pixel * double(gbuffer.z_m.Pixels().size()));
    return bench;
}

}  // namespace

AoBench BenchAo(const Scene& scene, const Camera& camera, const AoBenchSettings& settings,
                const PassClock& clock, Monitor& monitor) {
    if (settings.rounds < 1 || settings.rounds > 1000) {
        throw Error(MustBe("AoBenchSettings::rounds", settings.rounds, "in [1, 1000]"));
    }
    AoBench bench;
    bench.scene = scene.name;
    bench.camera = camera.name;
    bench.threads = ThreadCount();
    bench.rounds = settings.rounds;
    bench.copy_bytes_per_second = CopyRate(settings.rounds, clock).value;
    for (const TimedSize& size : settings.sizes) {
        if (monitor.Cancelled()) throw Interrupted();
        bench.sizes.push_back(
            BenchSize(scene, camera, size, settings, bench.copy_bytes_per_second, clock));
        monitor.Progress("sizes", double(bench.sizes.size()) / double(settings.sizes.size()));
    }
    return bench;
}

}  // namespace plumb
