#include "jobs/screen_space/ao_times.h"

#include "core/time_in_turns.h"
#include "jobs/bench_facts.h"
#include "jobs/screen_space/sao_traffic.h"
#include "jobs/screen_space/score_columns.h"
#include "reports/text.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/near_plane.h"

namespace plumb {
namespace {

PlotSeries Curve(std::string label, std::string color, const doc::Table& table,
                 const char* key) {
    std::vector<double> x, y;
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
        x.push_back(doc::NumberOf(table.At(k, "radius_m")));
        y.push_back(doc::NumberOf(table.At(k, key)));
    }
    PlotSeries series;
    series.label = std::move(label);
    series.color = std::move(color);
    series.x = std::move(x);
    series.y = std::move(y);
    return series;
}

}  // namespace

Camera SizedAs(Camera camera, const TimedSize& size) {
    camera.width_px = size.width_px;
    camera.height_px = size.height_px;
    return camera;
}

std::string TextOf(const TimedSize& size) {
    return std::to_string(size.width_px) + " x " + std::to_string(size.height_px) + " + " +
           std::to_string(size.guard_px);
}

doc::Section TimePasses(const Scene& scene, const Camera& camera, const RayCaster& caster,
                        std::span<const ChosenTechnique> saos, std::span<const TimedSize> sizes,
                        int rounds, double copy_bytes_per_second, const RunContext& run) {
    const doc::Column technique = doc::Name("technique", "Technique"),
                      size_px = {.key = "size_px",
                                 .title = "Size + border",
                                 .unit = "px",
                                 .role = doc::Role::kName};
    doc::Table table{
        .key = "times",
        .columns = {technique,
                    size_px,
                    TimeColumn("ms", "Time", "ms"),
                    {.key = "bytes_per_pixel",
                     .title = "Traffic",
                     .unit = "B/px",
                     .meaning = "What the passes read and write, counted texel by texel, each "
                                "once a pass, by the pixels shown"},
                    TimeColumn("ns_per_visible_pixel", "By the pixels shown", "ns/px"),
                    TimeColumn("of_copy", "Over a copy", "", doc::Better::kLess,
                               "The time over that of copying as many bytes in the same run")}};
    doc::Table by_pass{
        .key = "time_passes",
        .columns = {technique,
                    size_px,
                    doc::Name("pass", "Pass"),
                    TimeColumn("pass_ms", "Time of a pass", "ms"),
                    {.key = "bytes_read", .title = "Read", .detail = true},
                    {.key = "bytes_written", .title = "Written", .detail = true}},
        .across = "pass"};
    std::vector<Technique> techniques;
    for (const ChosenTechnique& sao : saos) techniques.push_back(sao.Made());
    double done = 0;
    for (const TimedSize& size : sizes) {
        const Camera sized = SizedAs(camera, size);
        const GBuffer gbuffer =
            DrawGBuffer(scene, sized, SuitedTo(scene, sized, size.guard_px));
        const TechniqueInput in{gbuffer, scene, sized, caster};
        std::vector<TechniqueTurn> turns;
        for (const Technique& one : techniques) turns.push_back({&one, &in});
        const std::vector<TimedTechnique> timed =
            TimeTechniques(turns, rounds, run.clock, run.monitor);
        const double shown = double(size.width_px) * size.height_px;
        for (std::size_t k = 0; k < saos.size(); ++k) {
            const std::vector<PassBytes> traffic = SaoTraffic(gbuffer, SaoOptionsOf(saos[k]));
            const double bytes = TotalBytes(traffic);
            const Measured& seconds = timed[k].seconds;
            table.Add({saos[k].name, TextOf(size), 1e3 * seconds, bytes / shown,
                       seconds.value * 1e9 / shown,
                       seconds.value * copy_bytes_per_second / bytes});
            for (std::size_t p = 0; p < traffic.size(); ++p) {
                by_pass.Add({saos[k].name, TextOf(size), traffic[p].name,
                             1e3 * timed[k].passes[p].seconds, traffic[p].read,
                             traffic[p].written});
            }
        }
        run.monitor.Progress("times", done += 1.0 / double(sizes.size()));
    }
    return {.id = "times",
            .title = "Time",
            .sentences = {"The techniques in turns; in brackets the least and the greatest of "
                          "the rounds. Sizes and guard bands are those of the paper's table 3, "
                          "and so is the time by the pixels shown."},
            .tables = {std::move(table), std::move(by_pass)}};
}

doc::Section TimeRadii(const Scene& scene, const Camera& camera, const TimedSize& size,
                       int rounds, const RunContext& run) {
    const Camera sized = SizedAs(camera, size);
    const GBuffer gbuffer = DrawGBuffer(scene, sized, SuitedTo(scene, sized, size.guard_px));
    doc::Table table{
        .key = "radii",
        .columns = {
            {.key = "radius_m", .title = "Radius", .unit = "m", .role = doc::Role::kName},
            TimeColumn("with_pyramid_ms", "With pyramid", "ms"),
            TimeColumn("without_pyramid_ms", "Without", "ms"),
            TimeColumn("alchemy_ms", "AlchemyAO", "ms")}};
    const double radii_m[] = {0.1, 0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75, 2};
    for (const double radius_m : radii_m) {
        const SaoOptions with = SaoWith("supplement2012", {.radius_m = radius_m, .samples = 9});
        SaoOptions without = with;
        SaoKnob("pyramid").set(without, 0);
        const SaoOptions alchemy = SaoWith("alchemy", {.radius_m = radius_m});
        const ZPyramid pyramid = BuildZPyramid(gbuffer, with),
                       full = BuildZPyramid(gbuffer, without);
        const TurnTimes turns = TimeInTurns({{[&] { SamplePass(gbuffer, pyramid, with); }},
                                             {[&] { SamplePass(gbuffer, full, without); }},
                                             {[&] { SamplePass(gbuffer, full, alchemy); }}},
                                            rounds, run.clock, run.monitor);
        table.Add(
            {radius_m, 1e3 * turns.Seconds(0), 1e3 * turns.Seconds(1), 1e3 * turns.Seconds(2)});
        run.monitor.Progress("times by radius",
                             double(table.rows.size()) / double(std::size(radii_m)));
    }
    PlotView view;
    view.series = {Curve("with pyramid", kOursColor, table, "with_pyramid_ms"),
                   Curve("without", kPublishedColor, table, "without_pyramid_ms"),
                   Curve("AlchemyAO", kDataColor, table, "alchemy_ms")};
    view.series.back().mark = Mark::kDashed;
    Plot plot{.id = "radius",
              .title = "Sampling time against radius",
              .caption = TextOf(size) +
                         " px, 9 taps (AlchemyAO: 12). The paper's figure 5: without a pyramid "
                         "taps of a wide disc miss the cache.",
              .x = {.label = "radius [m]", .low = 0, .high = {}},
              .y = {.label = "time [ms]", .low = 0, .high = {}},
              .views = {std::move(view)}};
    return {.id = "radii",
            .title = "Time against radius",
            .tables = {std::move(table)},
            .plots = {{.plots = {std::move(plot)}, .of_times = true}}};
}

}  // namespace plumb
