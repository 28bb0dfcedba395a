// A technique as its user wants it: what the command line says, else the scene's file, else the
// default; the same in every table of a report.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jobs/screen_space/technique.h"

namespace plumb {

struct ChosenTechnique {
    std::string name;
    TechniqueSettings settings;

    Technique Made() const { return TechniqueNamed(name, settings); }
};

/// Its options, if it is of SAO's family.
SaoOptions SaoOptionsOf(const ChosenTechnique& chosen);

/// `radius_m` and `set` are the command line's; `set` wins. Throws Error if there is no such
/// technique, or a value that it does not take.
ChosenTechnique Chosen(const LoadedScene& loaded, const std::string& name,
                       std::optional<double> radius_m, const ValuesByTechnique& set = {});

}  // namespace plumb
