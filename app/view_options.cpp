#include "app/view_options.h"

#include "core/error.h"

namespace plumb::app {

void AddViewOptions(CLI::App& command, ViewOptions& view) {
    command.add_option("--camera", view.camera, "Name of the camera; the first if not given");
    AddPictureOptions(command, view);
}

void AddPictureOptions(CLI::App& command, ViewOptions& view) {
    command.add_option("--width", view.width_px, "Width of the picture [px]")
        ->check(CLI::Range(1, 16384));
    command.add_option("--height", view.height_px, "Height of the picture [px]")
        ->check(CLI::Range(1, 16384));
    command
        .add_option("--guard", view.guard_px,
                    "Border drawn around the picture but not shown [px]; not given: 128 px at "
                    "720 rows and in proportion")
        ->check(CLI::Range(0, 4096));
}

void AddSetOption(CLI::App& command, std::vector<std::string>& set) {
    command
        .add_option("--set", set,
                    "NAME.KNOB=VALUE turns one knob or switch of a technique; plumb techniques "
                    "NAME lists them")
        ->take_all();
}

void AddTechniqueOptions(CLI::App& command, TechniqueOptions& options) {
    command.add_option("--radius", options.radius_m,
                       "Radius [m]; not given: the scene file's, else 1.5");
    command.add_option("--samples", options.samples,
                       "Depth lookups or rays a pixel; not given: the scene file's, else as "
                       "published");
    AddSetOption(command, options.set);
}

KnobValues ValuesFor(const TechniqueOptions& options, const std::string& technique) {
    const Description& about = FindTechnique(technique).description;
    const ValuesByTechnique set = ValuesOfSet(options.set);
    CheckSetIsOf(set, {technique});
    KnobValues values;
    const auto given = [&](const char* flag, const char* name, double value) {
        const Knob& knob = KnobNamed(about, name, flag);
        if (!Allows(knob, value)) throw Error(MustBe(flag, value, RuleOf(knob)));
        values[name] = value;
    };
    if (options.radius_m) given("--radius", "radius_m", *options.radius_m);
    if (options.samples) given("--samples", "samples", *options.samples);
    const auto of_technique = set.find(technique);
    return of_technique == set.end() ? values : Merged(about, values, of_technique->second);
}

}  // namespace plumb::app
