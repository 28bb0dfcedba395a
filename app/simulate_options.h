// The options of the light simulation, shared by the subcommands that run it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/command.h"
#include "jobs/light/simulate_surface.h"
#include "jobs/light/surface.h"

namespace plumb::app {

struct SimulateOptions {
    SimulateSettings settings;
    SurfaceOptions surface;
    std::string method = "slices", rays_distribution = "uniform", boundary;
    double spacing_m = 0, amplitude_m = -1, amplitude_of_width = -1;
    int rays = 1024;
};

void AddSimulateOptions(CLI::App& command, SimulateOptions& options);

/// What the options say, checked; the seed is that of the common options.
SimulateSettings SettingsOf(const SimulateOptions& options, const Common& common);
SurfaceOptions SurfaceOptionsOf(const CLI::App& command, const SimulateOptions& options);

/// Throws CheckFailed if a map's furnace is not white.
void RequireFurnace(const SurfaceReport& map);

}  // namespace plumb::app
