#include "jobs/screen_space/technique.h"

#include <cmath>

#include "core/error.h"
#include "core/names.h"
#include "jobs/screen_space/ray_techniques.h"
#include "screen_space/sao/sao_presets.h"

namespace plumb {
namespace {

const std::vector<PictureTechnique>& Everything() {
    static const std::vector<PictureTechnique> everything = [] {
        std::vector<PictureTechnique> all = AllTechniques();
        for (PictureTechnique& one : RayTechniques()) all.push_back(std::move(one));
        return all;
    }();
    return everything;
}

std::string NameOfTechnique(const PictureTechnique& one) {
    return one.description.name;
}

// The passes with their pictures, each with the time since the last was kept.
template <class Run>
std::vector<Pass> Timed(const Run& run, const PassClock& clock) {
    std::vector<Pass> passes;
    double last_s = clock();
    run([&](std::string_view name, const Image<float>& A) {
        const double seconds = clock() - last_s;
        passes.push_back({std::string(name), A, seconds});
        last_s = clock();
    });
    return passes;
}

KnobValues ValuesOf(const TechniqueSettings& settings) {
    KnobValues values{{"radius_m", settings.radius_m}};
    if (settings.samples > 0) values["samples"] = settings.samples;
    if (!settings.filter) values["filter"] = 0;
    return values;
}

}  // namespace

void Validate(const TechniqueSettings& s) {
    if (!(s.radius_m > 0 && std::isfinite(s.radius_m))) {
        throw Error(MustBe("radius_m", s.radius_m, "in (0, infinity)"));
    }
    if (s.samples < 0 || s.samples > 4096) {
        throw Error(MustBe("samples", s.samples, "in [0, 4096]"));
    }
}

std::vector<std::string> TechniqueNames() {
    std::vector<std::string> names;
    for (const PictureTechnique& one : Everything()) names.push_back(NameOfTechnique(one));
    return names;
}

const PictureTechnique& DescribedTechnique(const std::string& name, const std::string& where) {
    return FindNamed(Everything(), NameOfTechnique, name, where + " = " + name);
}

Technique TechniqueNamed(const std::string& name, const TechniqueSettings& settings) {
    Validate(settings);
    const TurnedTechnique turned = DescribedTechnique(name).with(ValuesOf(settings));
    return {name, turned.falloff, turned.samples,
            [run = turned.run](const TechniqueInput& in, const PassClock& clock) {
                return Timed([&](const PassObserver& observer) { run(in, observer); }, clock);
            }};
}

SaoOptions SaoWith(const std::string& preset, const TechniqueSettings& settings) {
    SaoOptions options = SaoPresetNamed(preset);
    options.sampling.sao.radius_m = settings.radius_m;
    if (settings.samples > 0) {
        options.sampling.taps.samples = settings.samples;
        options.sampling.taps.turns = 0;
    }
    if (!settings.filter) options.blur_x = options.blur_y = false;
    return options;
}

Technique SaoTechnique(std::string name, const SaoOptions& options) {
    return {std::move(name), FalloffOf(options.sampling.sao.falloff),
            options.sampling.taps.samples,
            [options](const TechniqueInput& in, const PassClock& clock) {
                SaoScratch scratch;
                return Timed(
                    [&](const PassObserver& observer) {
                        RunSao(in.gbuffer, options, scratch, observer);
                    },
                    clock);
            }};
}

TechniqueSettings SettingsOf(const LoadedScene& loaded, const std::string& name,
                             TechniqueSettings otherwise) {
    for (const TechniqueEntry& entry : loaded.techniques) {
        try {
            DescribedTechnique(entry.name);
        } catch (const Error& error) {
            throw Error(entry.asked_by + ": " + error.what());
        }
        if (entry.name != name) continue;
        otherwise.radius_m = entry.radius_m.value_or(otherwise.radius_m);
        otherwise.samples = entry.samples.value_or(otherwise.samples);
        otherwise.filter = entry.filter.value_or(otherwise.filter);
    }
    return otherwise;
}

double TotalSeconds(const std::vector<Pass>& passes) {
    double seconds = 0;
    for (const Pass& pass : passes) seconds += pass.seconds;
    return seconds;
}

}  // namespace plumb
