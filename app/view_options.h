// The options of every subcommand that looks at a scene through a camera.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "jobs/screen_space/technique.h"

namespace plumb::app {

struct ViewOptions {
    std::string camera;
    int width_px = 0, height_px = 0, guard_px = -1;
};

/// Declares --camera, --width, --height and --guard.
void AddViewOptions(CLI::App& command, ViewOptions& view);

/// The same but for --camera: for whoever looks through several.
void AddPictureOptions(CLI::App& command, ViewOptions& view);

/// How techniques are turned on the command line. What is given there wins over the scene's file.
struct TechniqueOptions {
    std::optional<double> radius_m;
    std::optional<int> samples;
    std::vector<std::string> set;
};

/// Declares --set.
void AddSetOption(CLI::App& command, std::vector<std::string>& set);

/// Declares --radius, --samples and --set.
void AddTechniqueOptions(CLI::App& command, TechniqueOptions& options);

/// What they say of the one technique that runs; --set wins over --radius and --samples. Throws
/// Error, naming flag, value and rule.
KnobValues ValuesFor(const TechniqueOptions& options, const std::string& technique);

}  // namespace plumb::app
