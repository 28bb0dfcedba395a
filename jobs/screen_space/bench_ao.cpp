#include "jobs/screen_space/bench_ao.h"

#include <functional>

#include "core/error.h"
#include "core/parallel.h"
#include "core/time_in_turns.h"
#include "jobs/bench_facts.h"
#include "jobs/memory_copy.h"
#include "jobs/screen_space/sao_traffic.h"
#include "reports/text.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/near_plane.h"

namespace plumb {
namespace {

constexpr double kNearRadiusM = 0.1;

// One thing that takes its turn: the order of the times of a size.
enum Thing : std::size_t { kSao, kAlchemy, kNear, kFar, kFarNoPyramid, kAlchemySample, kCopy };

struct SizeTimes {
    std::string name;
    TurnTimes times;
    double bytes_per_pixel = 0;
};

SizeTimes TimeSize(const Scene& scene, const Camera& camera_as_given, const TimedSize& size,
                   const AoBenchSettings& settings, const RunContext& run) {
    const Camera camera = SizedAs(camera_as_given, size);
    const GBuffer gbuffer = DrawGBuffer(scene, camera, SuitedTo(scene, camera, size.guard_px));
    const SaoOptions sao = SaoWith("supplement2012", {.radius_m = settings.radius_m});
    const SaoOptions alchemy = SaoWith("alchemy", {.radius_m = settings.radius_m});
    const SaoOptions near = SaoWith("supplement2012", {.radius_m = kNearRadiusM, .samples = 9});
    const SaoOptions far =
        SaoWith("supplement2012", {.radius_m = settings.radius_m, .samples = 9});
    SaoOptions full = far;
    full.sampling.taps.coarsest_level = 0;
    const ZPyramid pyramid = BuildZPyramid(gbuffer, far), none = BuildZPyramid(gbuffer, full),
                   for_alchemy = BuildZPyramid(gbuffer, alchemy);
    const double bytes = TotalBytes(SaoTraffic(gbuffer, sao));
    MemoryCopy copy{std::size_t(bytes)};
    SaoScratch sao_memory, alchemy_memory;  // As an engine keeps its targets.
    return {.name = TextOf(size),
            .times = TimeInTurns({{.run = [&] { RunSao(gbuffer, sao, sao_memory); }},
                                  {.run = [&] { RunSao(gbuffer, alchemy, alchemy_memory); }},
                                  {.run = [&] { SamplePass(gbuffer, pyramid, near); }},
                                  {.run = [&] { SamplePass(gbuffer, pyramid, far); }},
                                  {.run = [&] { SamplePass(gbuffer, none, full); }},
                                  {.run = [&] { SamplePass(gbuffer, for_alchemy, alchemy); }},
                                  {.run = std::ref(copy)}},
                                 settings.rounds, run.clock, run.monitor),
            .bytes_per_pixel = bytes / double(gbuffer.z_m.Pixels().size())};
}

const doc::Column kSize{
    .key = "size_px", .title = "Picture + border", .unit = "px", .role = doc::Role::kName};

doc::Section WholeSection(const std::vector<SizeTimes>& sizes) {
    doc::Table table{
        .key = "passes",
        .columns = {
            kSize,
            TimeColumn("sao_ms", "SAO, 11 taps", "ms"),
            TimeColumn("alchemy_ms", "AlchemyAO, 12 taps", "ms"),
            TimeColumn("alchemy_over_sao", "AlchemyAO / SAO", ""),
            {.key = "bytes_per_pixel",
             .title = "SAO moves",
             .unit = "B/px",
             .meaning = "What its passes read and write, a drawn pixel; taps from the cache."},
            TimeColumn("of_copy", "SAO / copying that", "")}};
    for (const SizeTimes& s : sizes) {
        table.Add({s.name, 1e3 * s.times.Seconds(kSao), 1e3 * s.times.Seconds(kAlchemy),
                   s.times.Ratio(kAlchemy, kSao), s.bytes_per_pixel,
                   s.times.Ratio(kSao, kCopy)});
    }
    return {.id = "passes",
            .title = "All passes",
            .sentences = {"The paper's AlchemyAO takes 7.1 times as long as its SAO at 1080p "
                          "(16.10 ms, 2.26 ms)."},
            .tables = {std::move(table)}};
}

doc::Section SamplingSection(const std::vector<SizeTimes>& sizes, double radius_m) {
    const std::string near = Digits(kNearRadiusM) + " m", far = Digits(radius_m) + " m";
    doc::Table seconds{.key = "sampling",
                       .columns = {kSize, TimeColumn("near_ms", "Radius " + near, "ms"),
                                   TimeColumn("far_ms", "Radius " + far, "ms"),
                                   TimeColumn("far_no_pyramid_ms", far + ", no pyramid", "ms"),
                                   TimeColumn("alchemy_ms", "AlchemyAO, " + far, "ms")}};
    doc::Table ratios{.key = "ratios",
                      .columns = {kSize, TimeColumn("far_over_near", far + " / " + near, ""),
                                  TimeColumn("no_pyramid_over_pyramid",
                                             "Without / with pyramid, " + far, "")}};
    for (const SizeTimes& s : sizes) {
        seconds.Add({s.name, 1e3 * s.times.Seconds(kNear), 1e3 * s.times.Seconds(kFar),
                     1e3 * s.times.Seconds(kFarNoPyramid),
                     1e3 * s.times.Seconds(kAlchemySample)});
        ratios.Add({s.name, s.times.Ratio(kFar, kNear), s.times.Ratio(kFarNoPyramid, kFar)});
    }
    return {.id = "sampling",
            .title = "The sampling pass alone, 9 taps",
            .tables = {std::move(seconds), std::move(ratios)}};
}

}  // namespace

void Validate(const AoBenchSettings& settings) {
    for (const char* preset : {"sao-supplement2012", "alchemy"}) {
        RequireRadius(preset, settings.radius_m);
    }
    if (settings.rounds < 1 || settings.rounds > 1000) {
        throw Error(MustBe("AoBenchSettings::rounds", settings.rounds, "in [1, 1000]"));
    }
}

doc::Document BenchAo(const Scene& scene, const Camera& camera, const AoBenchSettings& settings,
                      const RunContext& run) {
    Validate(settings);
    std::vector<SizeTimes> sizes;
    for (const TimedSize& size : settings.sizes) {
        sizes.push_back(TimeSize(scene, camera, size, settings, run));
        run.monitor.Progress("sizes", double(sizes.size()) / double(settings.sizes.size()));
    }
    doc::Document document{
        .kind = "bench_ao",
        .title = "Speed of SAO: " + scene.name,
        .subtitle = "camera " + camera.name,
        .provenance = doc::ProvenanceOf(run),
        .sections = {WholeSection(sizes), SamplingSection(sizes, settings.radius_m)}};
    document.sections[0].facts = BenchFacts(ThreadCount(), settings.rounds);
    document.sections[0].facts.push_back(
        {{.key = "radius_m", .title = "Radius", .unit = "m"}, settings.radius_m});
    return document;
}

}  // namespace plumb
