#include "jobs/screen_space/ao_sweep.h"

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "jobs/bench_facts.h"
#include "jobs/pictures.h"
#include "jobs/screen_space/find_closest.h"
#include "jobs/screen_space/score_columns.h"
#include "jobs/screen_space/time_techniques.h"
#include "score/pareto.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/near_plane.h"

namespace plumb {
namespace {

constexpr int kSampleCounts[] = {4, 8, 16, 32, 64};

struct Setting {
    std::string text;
    Technique technique;
    bool half = false;  // Drawn at half the resolution.
};

std::vector<Setting> SettingsOf(const ChosenTechnique& chosen) {
    const std::string& name = chosen.name;
    const auto changed = [&](const auto& change) {
        TechniqueSettings settings = chosen.settings;
        change(settings);
        return TechniqueNamed(name, settings);
    };
    std::vector<Setting> settings{{"as shipped", chosen.Made()}};
    for (const double share : {0.5, 2.0}) {
        settings.push_back({share < 1 ? "half the radius" : "twice the radius",
                            changed([&](TechniqueSettings& s) { s.radius_m *= share; })});
    }
    settings.push_back({"half resolution", chosen.Made(), true});
    settings.push_back({"no filter", changed([](TechniqueSettings& s) { s.filter = false; })});
    if (!name.starts_with("rays-")) {
        for (const int samples : kSampleCounts) {
            Technique technique = changed([&](TechniqueSettings& s) { s.samples = samples; });
            const std::string text = std::to_string(technique.samples) + " lookups";
            settings.push_back({text, std::move(technique)});
        }
    }
    const Description& about = FindTechnique(name).description;
    const bool has_pyramid = std::ranges::any_of(about.knobs, [](const Knob& knob) {
        return knob.name == "pyramid" && knob.published != 0;
    });
    if (!has_pyramid) return settings;
    const auto turned = [&](std::string text, const std::string& knob, bool on) {
        settings.push_back(
            {std::move(text),
             TechniqueNamed(name, Over(chosen.settings, name, {{knob, on ? 1.0 : 0.0}}))});
    };
    turned("no pyramid", "pyramid", false);
    turned("no packing", "packing", false);
    const bool quads = ValueOf(about, chosen.settings.knobs, "quads") != 0;
    turned(quads ? "no quads" : "with quads", "quads", !quads);
    return settings;
}

// A of the full size.
Image<float> Whole(Image<float> A, const Setting& setting, const Mask& seen) {
    return setting.half ? Doubled(A, seen.Width(), seen.Height()) : A;
}

// One setting of one technique.
struct Point {
    std::string technique, setting;
    Measured seconds, rmse, recalibrated_rmse;  ///< Against V within r.
    bool on_front = false;                      ///< No other is both faster and better.
};

PlotSeries SeriesOf(std::string label, std::span<const Point> points, Measured Point::*error) {
    std::vector<double> x, y;
    for (const Point& p : points) {
        x.push_back(1e3 * p.seconds.value);
        y.push_back((p.*error).value);
    }
    PlotSeries series;
    series.label = std::move(label);
    series.mark = Mark::kDots;
    series.x = std::move(x);
    series.y = std::move(y);
    return series;
}

Plot ErrorAgainstTime(std::span<const Point> points, std::span<const Point> front) {
    double least = 1, most = 0;
    for (const Point& p : points) {
        least = std::min({least, p.rmse.value, p.recalibrated_rmse.value});
        most = std::max({most, p.rmse.value, p.recalibrated_rmse.value});
    }
    Plot plot{
        .id = "error-time",
        .title = "Error against run time",
        .caption =
            "Each dot is one setting of one technique: lookups or rays a pixel, pyramid, "
            "packing and filters on and off. Down and to the left is better; nothing lies "
            "below the front.",
        .x = {.label = "time of one picture [ms]", .low = {}, .high = {}, .logarithmic = true},
        .y = {.label = "RMSE against V within r",
              .low = 0.8 * least,
              .high = 1.2 * most,
              .logarithmic = true},
        .views = {},
        .wide = true};
    for (const auto& [key, error] :
         {std::pair{"as it is", &Point::rmse}, {"recalibrated", &Point::recalibrated_rmse}}) {
        PlotView view{.keys = {{"error", key}}, .series = {}, .x = {}, .y = {}};
        for (std::size_t k = 0; k < points.size();) {
            std::size_t end = k;
            while (end < points.size() && points[end].technique == points[k].technique) ++end;
            PlotSeries one = SeriesOf(points[k].technique, points.subspan(k, end - k), error);
            one.color = CategoryColor(int(view.series.size()));
            one.shape = int(view.series.size()) % 5;
            view.series.push_back(std::move(one));
            k = end;
        }
        plot.views.push_back(std::move(view));
    }
    PlotSeries line = SeriesOf("Pareto front", front, &Point::rmse);
    line.mark = Mark::kDashed;
    line.color = kDataColor;
    plot.views.front().series.push_back(std::move(line));
    return plot;
}

doc::Table TableOf(std::string key, std::span<const Point> points) {
    doc::Table table{.key = std::move(key),
                     .columns = {doc::Name("technique", "Technique"),
                                 doc::Name("setting", "Setting"),
                                 TimeColumn("ms", "Time", "ms"),
                                 RmseColumn(),
                                 RmseColumn("recalibrated_rmse", "Recalibrated RMSE"),
                                 {.key = "pareto",
                                  .title = "On the front",
                                  .role = doc::Role::kTime,
                                  .meaning = "No other is both faster and better"}}};
    for (const Point& p : points) {
        table.Add({p.technique, p.setting, 1e3 * p.seconds, p.rmse, p.recalibrated_rmse,
                   p.on_front ? "yes" : "no"});
    }
    return table;
}

doc::Section SectionOf(std::span<const Point> points) {
    std::vector<Point> front;
    for (const Point& p : points) {
        if (p.on_front) front.push_back(p);
    }
    std::ranges::sort(front, {}, [](const Point& p) { return p.seconds.value; });
    doc::Table table = TableOf("pareto_front", front);
    table.of_times = true;
    table.columns.back().detail = true;
    return {
        .id = "sweep",
        .title = "Error against run time",
        .plots = {{.selectors = {{"error", "error", {"as it is", "recalibrated"}}},
                   .plots = {ErrorAgainstTime(points, front)},
                   .of_times = true}},
        .sections = {
            {.id = "sweep_front", .title = "The Pareto front", .tables = {std::move(table)}},
            {.id = "sweep_all",
             .title = "Every setting",
             .folded = true,
             .tables = {TableOf("sweep", points)}}}};
}

}  // namespace

Sweep SweepTechniques(const TechniqueInput& in, const ViewTruth& truth,
                      std::span<const ChosenTechnique> techniques, int rounds, double tolerance,
                      const RunContext& run) {
    const Mask seen = RegionsOf(truth).seen;
    const TruthImage& near = truth.near.at(Falloff::kHard);
    Camera half_camera = in.camera;
    half_camera.width_px = (half_camera.width_px + 1) / 2;
    half_camera.height_px = (half_camera.height_px + 1) / 2;
    const GBuffer half =
        DrawGBuffer(in.scene, half_camera,
                    SuitedTo(in.scene, half_camera, (in.gbuffer.view.guard_px + 1) / 2));
    const TechniqueInput in_half{half, in.scene, half_camera, in.caster};

    std::vector<Point> points;
    std::vector<Setting> all;
    std::vector<TimedError> timed;
    for (std::size_t t = 0; t < techniques.size(); ++t) {
        const std::vector<Setting> settings = SettingsOf(techniques[t]);
        std::vector<TechniqueTurn> turns;
        for (const Setting& setting : settings) {
            turns.push_back({&setting.technique, setting.half ? &in_half : &in});
        }
        std::vector<TimedTechnique> results =
            TimeTechniques(turns, rounds, run.clock, run.monitor);
        for (std::size_t k = 0; k < settings.size(); ++k) {
            const ScoreAgainst score =
                ScoreOver(Whole(std::move(results[k].A), settings[k], seen), near, kTruthNear,
                          "whole", seen);
            points.push_back({.technique = techniques[t].name,
                              .setting = settings[k].text,
                              .seconds = results[k].seconds,
                              .rmse = score.error.rmse,
                              .recalibrated_rmse = score.recalibrated_rmse});
            timed.push_back({techniques[t].name + ", " + settings[k].text,
                             results[k].seconds.value, score.error.rmse.value});
            all.push_back(settings[k]);
        }
        run.monitor.Progress("error against time", double(t + 1) / double(techniques.size()));
    }
    // Only the front is compared pair by pair: its pictures are made again, those of all settings
    // would be gigabytes.
    const std::size_t cheapest = CheapestWithin(timed, tolerance);
    std::vector<Contestant> front;
    std::size_t winner = 0;
    for (const std::size_t k : ParetoFront(timed)) {
        points[k].on_front = true;
        if (k == cheapest) winner = front.size();
        const TechniqueInput& input = all[k].half ? in_half : in;
        const std::vector<Pass> passes = all[k].technique.run(input, run.clock);
        Image<float> A = Shown(passes.back().A, input.gbuffer.view);
        front.push_back({timed[k].name, {Whole(std::move(A), all[k], seen)}});
    }
    const ComparedView view{&near, &seen};
    return {SectionOf(points), {timed[cheapest].name, TiesOf(winner, front, {&view, 1})}};
}

}  // namespace plumb
