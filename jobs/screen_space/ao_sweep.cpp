#include "jobs/screen_space/ao_sweep.h"

#include <algorithm>

#include "core/error.h"
#include "jobs/pictures.h"
#include "jobs/screen_space/score_technique.h"
#include "score/pareto.h"
#include "screen_space/raster/draw_gbuffer.h"

namespace plumb {
namespace {

constexpr int kSampleCounts[] = {4, 8, 16, 32, 64};

struct Setting {
    std::string text;
    Technique technique;
    bool half = false;  // Drawn at half the resolution.
};

std::vector<Setting> SettingsOf(const std::string& name, double radius_m) {
    std::vector<Setting> settings{{"as shipped", TechniqueNamed(name, {.radius_m = radius_m})}};
    for (const double share : {0.5, 2.0}) {
        settings.push_back({share < 1 ? "half the radius" : "twice the radius",
                            TechniqueNamed(name, {.radius_m = share * radius_m})});
    }
    settings.push_back({"half resolution", TechniqueNamed(name, {.radius_m = radius_m}), true});
    settings.push_back(
        {"no filter", TechniqueNamed(name, {.radius_m = radius_m, .filter = false})});
    if (!name.starts_with("rays-")) {
        for (const int samples : kSampleCounts) {
            Technique technique =
                TechniqueNamed(name, {.radius_m = radius_m, .samples = samples});
            const std::string text = std::to_string(technique.samples) + " lookups";
            settings.push_back({text, std::move(technique)});
        }
    }
    const bool sao = name.starts_with("sao-");
    if (!sao) return settings;
    const SaoOptions shipped = SaoWith(name.substr(4), {.radius_m = radius_m});
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

}  // namespace

std::vector<Pass> Timed(const Technique& technique, const TechniqueInput& in, int rounds,
                        const PassClock& clock) {
    technique.run(in, clock);
    std::vector<Pass> passes;
    std::vector<std::vector<double>> seconds;
    for (int round = 0; round < rounds; ++round) {
        passes = technique.run(in, clock);
        seconds.resize(passes.size());
        for (std::size_t k = 0; k < passes.size(); ++k) {
            seconds[k].push_back(passes[k].seconds);
        }
    }
    for (std::size_t k = 0; k < passes.size(); ++k) {
        std::sort(seconds[k].begin(), seconds[k].end());
        passes[k].seconds = seconds[k][seconds[k].size() / 2];
    }
    return passes;
}

std::vector<SweepPoint> SweepTechniques(const TechniqueInput& in, const ViewTruth& truth,
                                        const std::vector<std::string>& techniques,
                                        const SweepOptions& options, const PassClock& clock,
                                        Monitor& monitor) {
    const Mask seen = RegionsOf(truth).seen;
    const TruthImage& near = truth.near.at(Falloff::kHard);
    Camera half_camera = in.camera;
    half_camera.width_px = (half_camera.width_px + 1) / 2;
    half_camera.height_px = (half_camera.height_px + 1) / 2;
    const GBuffer half =
        DrawGBuffer(in.scene, half_camera, {.guard_px = (in.gbuffer.view.guard_px + 1) / 2});
    const TechniqueInput in_half{half, in.scene, half_camera, in.caster};
    std::vector<SweepPoint> points;
    std::vector<TimedError> timed;
    for (std::size_t t = 0; t < techniques.size(); ++t) {
        for (const Setting& setting : SettingsOf(techniques[t], options.radius_m)) {
            if (monitor.Cancelled()) throw Interrupted();
            const TechniqueInput& input = setting.half ? in_half : in;
            const std::vector<Pass> passes =
                Timed(setting.technique, input, options.rounds, clock);
            Image<float> A = Shown(passes.back().A, input.gbuffer.view);
            if (setting.half) A = Doubled(A, seen.Width(), seen.Height());
            const ScoreAgainst score = ScoreOver(A, near, kTruthNear, "whole", seen);
            points.push_back({.technique = techniques[t],
                              .setting = setting.text,
                              .seconds = TotalSeconds(passes),
                              .rmse = score.error.rmse.value,
                              .recalibrated_rmse = score.recalibrated_rmse.value});
            timed.push_back({techniques[t] + ", " + setting.text, points.back().seconds,
                             points.back().rmse});
        }
        monitor.Progress("error against time", double(t + 1) / double(techniques.size()));
    }
    for (const std::size_t k : ParetoFront(timed)) points[k].on_front = true;
    return points;
}

}  // namespace plumb
