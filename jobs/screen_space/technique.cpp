#include "jobs/screen_space/technique.h"

#include <cmath>

#include "core/error.h"
#include "core/names.h"
#include "screen_space/sao/sao_presets.h"

namespace plumb {
namespace {

KnobValues ValuesOf(const TechniqueSettings& settings) {
    KnobValues values = settings.knobs;
    values["radius_m"] = settings.radius_m;
    if (settings.samples > 0) values["samples"] = settings.samples;
    if (!settings.filter) values["filter"] = 0;
    return values;
}

// "gtao.radius_m=1": what stands before, between and behind.
struct Assignment {
    std::string technique, knob, value;
};

Assignment AssignmentOf(const std::string& text) {
    const std::size_t dot = text.find('.'), equals = text.find('=');
    if (dot == std::string::npos || equals == std::string::npos || equals < dot) {
        throw Error("--set " + text + ", must be NAME.KNOB=VALUE, such as gtao-hard.slices=4");
    }
    return {text.substr(0, dot), text.substr(dot + 1, equals - dot - 1),
            text.substr(equals + 1)};
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

void RequireRadius(const std::string& technique, double radius_m) {
    const Knob& knob = KnobNamed(FindTechnique(technique).description, "radius_m", "radius_m");
    if (!Allows(knob, radius_m)) throw Error(MustBe("radius_m", radius_m, RuleOf(knob)));
}

std::vector<std::string> TechniqueNames() {
    std::vector<std::string> names;
    for (const PictureTechnique& one : AllTechniques()) names.push_back(one.description.name);
    return names;
}

Technique TechniqueNamed(const std::string& name, const TechniqueSettings& settings) {
    Validate(settings);
    const TurnedTechnique turned = FindTechnique(name).with(ValuesOf(settings));
    return {name, turned.falloff, turned.samples,
            [run = turned.run](const TechniqueInput& in, const Clock& clock) {
                std::vector<Pass> passes;
                double last_s = clock();
                run(in, [&](std::string_view pass, const Image<float>& A) {
                    const double seconds = clock() - last_s;
                    passes.push_back({std::string(pass), A, seconds});
                    last_s = clock();  // Since the last was kept.
                });
                return passes;
            }};
}

SaoOptions SaoWith(const std::string& preset, const TechniqueSettings& settings) {
    SaoOptions options = SaoPresetNamed(preset);
    const KnobValues values = ValuesOf(settings);
    for (const BoundKnob<SaoOptions>& bound : SaoKnobs()) {
        const auto given = values.find(bound.knob.name);
        if (given != values.end()) bound.set(options, given->second);
    }
    return options;
}

TechniqueSettings SettingsOf(const LoadedScene& loaded, const std::string& name,
                             TechniqueSettings otherwise) {
    for (const TechniqueEntry& entry : loaded.techniques) {
        const Description& about = FindTechnique(entry.name, entry.where + ".name").description;
        const KnobValues values = ValuesOfTexts(about, entry.values, entry.where);
        if (entry.name == name) otherwise = Over(otherwise, name, values);
    }
    return otherwise;
}

ValuesByTechnique ValuesOfSet(const std::vector<std::string>& set) {
    ValuesByTechnique all;
    for (const std::string& text : set) {
        const Assignment given = AssignmentOf(text);
        const Description& about =
            FindTechnique(given.technique, "--set " + text + ": technique").description;
        const KnobValues one =
            ValuesOfTexts(about, {{given.knob, given.value}}, "--set " + given.technique);
        KnobValues& values = all[given.technique];
        values = Merged(about, values, one);
    }
    return all;
}

void CheckSetIsOf(const ValuesByTechnique& set, const std::vector<std::string>& running) {
    for (const auto& [name, values] : set) {
        PlaceOf(
            name, running,
            "--set " + name + "." + values.begin()->first + ": " + name + " does not run here");
    }
}

TechniqueSettings Over(TechniqueSettings settings, const std::string& technique,
                       const KnobValues& values) {
    const Description& about = FindTechnique(technique).description;
    KnobValues all = Merged(about, ValuesOf(settings), values);
    const auto taken = [&](const char* knob, double otherwise) {
        const auto found = all.find(knob);
        if (found == all.end()) return otherwise;
        const double value = found->second;
        all.erase(found);
        return value;
    };
    TechniqueSettings over;
    over.radius_m = taken("radius_m", settings.radius_m);
    over.samples = int(taken("samples", 0));
    over.filter = taken("filter", 1) != 0;
    over.knobs = std::move(all);
    return over;
}

}  // namespace plumb
