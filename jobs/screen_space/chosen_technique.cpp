#include "jobs/screen_space/chosen_technique.h"

namespace plumb {

ChosenTechnique Chosen(const LoadedScene& loaded, const std::string& name,
                       std::optional<double> radius_m) {
    ChosenTechnique chosen{name, SettingsOf(loaded, name, {})};
    chosen.settings.radius_m = radius_m.value_or(chosen.settings.radius_m);
    TechniqueNamed(name, chosen.settings);
    return chosen;
}

}  // namespace plumb
