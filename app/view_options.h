// The options of every subcommand that looks at a scene through a camera.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace plumb::app {

struct ViewOptions {
    std::string camera;
    int width_px = 0, height_px = 0, guard_px = -1;
};

/// Declares --camera, --width, --height and --guard.
void AddViewOptions(CLI::App& command, ViewOptions& view);

/// The same but for --camera: for whoever looks through several.
void AddPictureOptions(CLI::App& command, ViewOptions& view);

}  // namespace plumb::app
