// plumb fit: height maps in; refitted constants, shader headers and a report out.
//
// Options -> struct -> call -> print.
#include <memory>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/simulate_options.h"
#include "core/conventions.h"
#include "jobs/light/fit_constants.h"
#include "jobs/light/fit_measured.h"
#include "jobs/light/fit_surfaces.h"
#include "jobs/write_results.h"

namespace plumb::app {
namespace {

struct Options {
    std::vector<std::string> maps;
    std::string histogram, abscissa = "right", open_ground;
    SimulateOptions simulate;
    FitSettings fit;
    std::string weighting = "population";
    Common common;
};

void FitMeasured(const Options& o) {
    const auto monitor = MakeMonitor(o.common);
    MeasuredOptions options{.abscissa = o.abscissa == "left"     ? BinAbscissa::kLeft
                                        : o.abscissa == "centre" ? BinAbscissa::kCentre
                                                                 : BinAbscissa::kRight};
    if (!o.open_ground.empty())
        options.open_ground = o.open_ground == "pi" ? kOpenIrradiance : 1;
    const FitReport report =
        FitMeasuredCurves(o.histogram, options, ContextOf(o.common, *monitor));
    const doc::Document document = DocumentOf(report);
    WriteFitTables(o.common.out, report, document);
    Publish(document, o.common);
}

void Run(const CLI::App& command, const Options& o) {
    if (!o.histogram.empty()) return FitMeasured(o);
    const auto monitor = MakeMonitor(o.common);
    FitSettings settings = o.fit;
    settings.simulate = SettingsOf(o.simulate, o.common);
    settings.weighting = o.weighting == "population" ? Weighting::kPopulation
                         : o.weighting == "variance" ? Weighting::kPopulationOverVariance
                                                     : Weighting::kUnweighted;
    Validate(settings);
    const std::vector<Surface> surfaces =
        LoadSurfaces(o.maps, SurfaceOptionsOf(command, o.simulate));
    FitConstantsResult result = FitConstants(surfaces, settings, ContextOf(o.common, *monitor));
    for (std::size_t m = 0; m < surfaces.size(); ++m) {
        WritePictures(o.common.out / "maps", surfaces[m].field, result.V[m],
                      result.report.maps[m]);
    }
    const doc::Document document = DocumentOf(result.report);
    WriteFitTables(o.common.out, result.report, document);
    Publish(document, o.common);
    for (const SurfaceReport& map : result.report.maps) RequireFurnace(map);
}

void Add(CLI::App& program) {
    auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand(
        "fit",
        "Refit the constants of ambient occlusion with interreflection to height maps.\n"
        "Writes report.html, report.json, report.csv, scores.csv, constants.csv and shader\n"
        "headers (plumb_light.glsl, .hlsl, .h) to the folder --out.");
    command->add_option("maps", o->maps,
                        "Height maps: images (docs/height_maps.md) or make:KIND[:SIZE[:SEED]]");
    command
        ->add_option(
            "--histogram", o->histogram,
            "Fit curves measured elsewhere instead: a CSV with columns E0, E1, ... and either "
            "bin (the paper's: open ground = pi) or alpha; or a histogram of plumb simulate")
        ->check(CLI::ExistingFile);
    command
        ->add_option(
            "--open-ground", o->open_ground,
            "With --histogram: what open ground receives in the unit of its E, pi or 1 "
            "[default: pi with a column bin, 1 for a histogram of plumb's own; any other "
            "table must say it]")
        ->check(CLI::IsMember({"pi", "1"}));
    command
        ->add_option("--abscissa", o->abscissa,
                     "With --histogram: the point of a bin that stands for it, left, centre or "
                     "right, where the table has no column alpha")
        ->check(CLI::IsMember({"left", "centre", "right"}))
        ->capture_default_str();
    AddSimulateOptions(*command, o->simulate);
    command
        ->add_option(
            "--weighting", o->weighting,
            "Of a bin in a fit: population, variance (population over variance) or none")
        ->check(CLI::IsMember({"population", "variance", "none"}))
        ->capture_default_str();
    command->add_option("--starts", o->fit.starts, "Starts of every fit")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command
        ->add_option("--bootstrap", o->fit.bootstrap_replicates,
                     "Replicates of the bootstrap over maps, at least 10; 0 = none")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    command->add_flag("--forms", o->fit.compare_forms,
                      "Also fit the other forms of the escape probability that were compared "
                      "(docs/models.md)");
    command->add_flag("!--no-studies", o->fit.study_convergence,
                      "Leave out the studies of convergence and amplitude");
    o->common.out = "out/fit";  // Other commands have folders of their own.
    AddCommon(*command, o->common);
    command->callback([o, command] {
        // Both kinds of fit write a constants.csv.
        if (!o->histogram.empty() && command->count("--out") == 0)
            o->common.out = "out/fit-histogram";
        if (o->maps.empty() == o->histogram.empty()) {
            throw CLI::ValidationError("plumb fit",
                                       "give height maps, or --histogram FILE, and not both");
        }
        o->fit.study_amplitude = o->fit.study_convergence;
        Run(*command, *o);
    });
}

const Listed kListed("", 10, Add);

}  // namespace
}  // namespace plumb::app
