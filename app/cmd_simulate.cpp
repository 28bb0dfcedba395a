// plumb simulate: the light on one height map, as maps, histograms and a page.
//
// Options -> struct -> call -> print.
#include <memory>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/simulate_options.h"
#include "jobs/light/simulate.h"

namespace plumb::app {
namespace {

struct Options {
    std::string map, albedo_map;
    std::vector<double> albedo;
    SimulateOptions simulate;
    bool sweep = false, no_maps = false;
    Common common;
};

void Run(const CLI::App& command, const Options& o) {
    const auto monitor = MakeMonitor(o.common);
    const Surface surface = LoadSurface(o.map, SurfaceOptionsOf(command, o.simulate));
    SimulateJob job;
    job.settings = SettingsOf(o.simulate, o.common);
    job.albedo = o.albedo;
    job.albedo_map = o.albedo_map;
    job.sweep_amplitude = o.sweep;
    job.write_maps = !o.no_maps;
    const SimulateReport report = Simulate(surface, job, ContextOf(o.common, *monitor));
    Publish(DocumentOf(report), o.common);
    RequireFurnace(report.surface);
}

void Add(CLI::App& program) {
    auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand(
        "simulate",
        "Simulate the light on one height map under a white sky: form factors and bounces.\n"
        "Writes light.exr (alpha, V, E_k, E(rho)), histograms, report.html, report.json and "
        "report.csv\n"
        "(docs/light.md).");
    command
        ->add_option("map", o->map,
                     "Height map: an image (docs/height_maps.md) or make:KIND[:SIZE[:SEED]]")
        ->required();
    AddSimulateOptions(*command, o->simulate);
    command
        ->add_option(
            "--albedo", o->albedo,
            "Also the total light for this albedo: one number, or three for R G B, each "
            "in [0, 1]")
        ->expected(1, 3);
    command
        ->add_option("--albedo-map", o->albedo_map,
                     "Also the total light for a picture of albedos, one pixel a texel (8-bit "
                     "pictures are taken as sRGB)")
        ->check(CLI::ExistingFile);
    command->add_flag("--amplitude-sweep", o->sweep,
                      "Also the effect of the amplitude, 0.1 % to 1000 % of the width");
    command->add_flag("--no-maps", o->no_maps, "Do not write light.exr");
    o->common.out = "out/simulate";  // Other commands have folders of their own.
    AddCommon(*command, o->common);
    command->callback([o, command] { Run(*command, *o); });
}

const Listed kListed("", 20, Add);

}  // namespace
}  // namespace plumb::app
