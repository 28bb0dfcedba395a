#include "jobs/screen_space/ao_sweep.h"

#include <utility>

#include "core/error.h"
#include "jobs/pictures.h"
#include "jobs/screen_space/find_closest.h"
#include "jobs/screen_space/score_technique.h"
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
    if (!name.starts_with("sao-")) return settings;
    const SaoOptions shipped = SaoWith(name.substr(4), chosen.settings);
    SaoOptions options = shipped;
    options.sampling.taps.coarsest_level = 0;
    settings.push_back({"no pyramid", SaoTechnique(name, options)});
    options = shipped;
    options.pack_rgb8 = false;
    settings.push_back({"no packing", SaoTechnique(name, options)});
    options = shipped;
    options.quad_filter = !shipped.quad_filter;
    settings.push_back(
        {shipped.quad_filter ? "no quads" : "with quads", SaoTechnique(name, options)});
    return settings;
}

// A of the full size.
Image<float> Whole(Image<float> A, const Setting& setting, const Mask& seen) {
    return setting.half ? Doubled(A, seen.Width(), seen.Height()) : A;
}

}  // namespace

Sweep SweepTechniques(const TechniqueInput& in, const ViewTruth& truth,
                      std::span<const ChosenTechnique> techniques, int rounds, double tolerance,
                      const Clock& clock, Monitor& monitor) {
    const Mask seen = RegionsOf(truth).seen;
    const TruthImage& near = truth.near.at(Falloff::kHard);
    Camera half_camera = in.camera;
    half_camera.width_px = (half_camera.width_px + 1) / 2;
    half_camera.height_px = (half_camera.height_px + 1) / 2;
    const GBuffer half =
        DrawGBuffer(in.scene, half_camera,
                    SuitedTo(in.scene, half_camera, (in.gbuffer.view.guard_px + 1) / 2));
    const TechniqueInput in_half{half, in.scene, half_camera, in.caster};

    Sweep sweep;
    std::vector<Setting> all;
    std::vector<TimedError> timed;
    for (std::size_t t = 0; t < techniques.size(); ++t) {
        const std::vector<Setting> settings = SettingsOf(techniques[t]);
        std::vector<TechniqueTurn> turns;
        for (const Setting& setting : settings) {
            turns.push_back({&setting.technique, setting.half ? &in_half : &in});
        }
        std::vector<TimedTechnique> results = TimeTechniques(turns, rounds, clock, monitor);
        for (std::size_t k = 0; k < settings.size(); ++k) {
            const ScoreAgainst score =
                ScoreOver(Whole(std::move(results[k].A), settings[k], seen), near, kTruthNear,
                          "whole", seen);
            sweep.points.push_back({.technique = techniques[t].name,
                                    .setting = settings[k].text,
                                    .seconds = results[k].seconds,
                                    .rmse = score.error.rmse,
                                    .recalibrated_rmse = score.recalibrated_rmse});
            timed.push_back({techniques[t].name + ", " + settings[k].text,
                             results[k].seconds.value, score.error.rmse.value});
            all.push_back(settings[k]);
        }
        monitor.Progress("error against time", double(t + 1) / double(techniques.size()));
    }
    // Only the front is compared pair by pair: its pictures are made again, those of all settings
    // would be gigabytes.
    const std::size_t cheapest = CheapestWithin(timed, tolerance);
    std::vector<Contestant> front;
    std::size_t winner = 0;
    for (const std::size_t k : ParetoFront(timed)) {
        sweep.points[k].on_front = true;
        if (k == cheapest) winner = front.size();
        const TechniqueInput& input = all[k].half ? in_half : in;
        const std::vector<Pass> passes = all[k].technique.run(input, clock);
        Image<float> A = Shown(passes.back().A, input.gbuffer.view);
        front.push_back({timed[k].name, {Whole(std::move(A), all[k], seen)}});
    }
    const ComparedView view{&near, &seen};
    sweep.cheapest = {timed[cheapest].name, TiesOf(winner, front, {&view, 1})};
    return sweep;
}

}  // namespace plumb
