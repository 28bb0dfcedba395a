#include "jobs/screen_space/chosen_technique.h"

namespace plumb {

SaoOptions SaoOptionsOf(const ChosenTechnique& chosen) {
    const std::string& name = chosen.name;
    return SaoWith(name.starts_with("sao-") ? name.substr(4) : name, chosen.settings);
}

ChosenTechnique Chosen(const LoadedScene& loaded, const std::string& name,
                       std::optional<double> radius_m, const ValuesByTechnique& set) {
    ChosenTechnique chosen{name, SettingsOf(loaded, name, {})};
    if (radius_m) chosen.settings.radius_m = *radius_m;
    const auto of_technique = set.find(name);
    if (of_technique != set.end()) {
        chosen.settings = Over(chosen.settings, name, of_technique->second);
    }
    TechniqueNamed(name, chosen.settings);
    return chosen;
}

}  // namespace plumb
