#include "app/simulate_options.h"

#include <cmath>

#include "app/process.h"
#include "core/error.h"

namespace plumb::app {

void AddSimulateOptions(CLI::App& command, SimulateOptions& o) {
    command
        .add_option(
            "--method", o.method,
            "How facets are linked: slices (exact in elevation) or rays (the paper's way)")
        ->check(CLI::IsMember({"slices", "rays"}))
        ->capture_default_str();
    command.add_option("--slices", o.settings.slices.slices, "Slices a facet, in [4, 65536]")
        ->capture_default_str();
    command
        .add_option("--cut-texels", o.settings.cut.extent_texels,
                    "Steep facets are cut into at most 8 strips, this high where fewer do, on "
                    "which light is constant; 0 = none is cut")
        ->capture_default_str();
    command
        .add_option("--rays", o.rays,
                    "Rays a facet, in [1, 1048576]; powers of two spread best")
        ->capture_default_str();
    command
        .add_option("--ray-distribution", o.rays_distribution,
                    "Directions of the rays: uniform (the paper's) or cosine")
        ->check(CLI::IsMember({"uniform", "cosine"}))
        ->capture_default_str();
    command
        .add_option("--bounces", o.settings.bounces,
                    "Bounces whose irradiance is kept, in [0, 1000]; totals have them all")
        ->capture_default_str();
    command
        .add_option("--bins", o.settings.bins, "Bins of the histograms over alpha and over V")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command.add_option(
        "--spacing-m", o.spacing_m,
        "Metres from texel to texel, > 0 [default: the file's word, or 1 m wide]");
    command.add_option("--amplitude-m", o.amplitude_m,
                       "Metres between the heights 0 and 1, >= 0 [default: the file's word]");
    command.add_option(
        "--amplitude-of-width", o.amplitude_of_width,
        "The same as a share of the width, >= 0 [default: 0.1 if nothing is said]");
    command
        .add_option("--boundary", o.boundary,
                    "Beyond the border: wrap, mirror or open [default: the file's word]")
        ->check(CLI::IsMember({"wrap", "mirror", "open"}));
    command
        .add_option(
            "--smooth-px", o.surface.smooth_px,
            "Radius of a bilateral filter over the heights in texels, for 8-bit maps; 0 = none")
        ->check(CLI::Range(0, 64))
        ->capture_default_str();
}

SimulateSettings SettingsOf(const SimulateOptions& o, const Common& common) {
    SimulateSettings settings = o.settings;
    settings.method = o.method == "rays" ? LinkMethod::kRays : LinkMethod::kSlices;
    settings.rays.rays = o.rays;
    settings.rays.distribution =
        o.rays_distribution == "cosine" ? RayDistribution::kCosine : RayDistribution::kUniform;
    settings.slices.seed = settings.rays.seed = common.seed;
    Validate(settings.cut);
    Validate(settings.slices);
    Validate(settings.rays);
    Validate(SeriesOptions{.bounces = settings.bounces, .albedos = settings.albedos});
    return settings;
}

void RequireFurnace(const SurfaceReport& map) {
    const std::string fault = FurnaceFault(map.name, map.figures.max_furnace_error);
    if (!fault.empty()) throw CheckFailed(fault);
}

SurfaceOptions SurfaceOptionsOf(const CLI::App& command, const SimulateOptions& o) {
    SurfaceOptions surface = o.surface;
    if (command.count("--spacing-m")) {
        // Also if it is not a number.
        if (!(o.spacing_m > 0 && std::isfinite(o.spacing_m))) {
            throw Error(MustBe("--spacing-m", o.spacing_m, "> 0"));
        }
        surface.spacing_m = o.spacing_m;
    }
    if (command.count("--amplitude-m")) surface.amplitude_m = o.amplitude_m;
    if (command.count("--amplitude-of-width")) {
        if (!(o.amplitude_of_width >= 0 && std::isfinite(o.amplitude_of_width))) {
            throw Error(MustBe("--amplitude-of-width", o.amplitude_of_width, ">= 0"));
        }
        surface.amplitude_of_width = o.amplitude_of_width;
    }
    if (command.count("--boundary")) surface.boundary = BoundaryNamed(o.boundary);
    return surface;
}

}  // namespace plumb::app
