// plumb report: a scene's techniques against its truth, step by step.
//
// Options -> struct -> call -> print.
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/view_options.h"
#include "core/parallel.h"
#include "jobs/screen_space/report_scene.h"

namespace plumb::app {
namespace {

struct Options {
    std::vector<std::string> scenes;
    SceneReportJob job;
    ViewOptions view;
    Common common;
};

void RunOne(const Options& o, const std::string& name, const std::filesystem::path& folder) {
    const auto monitor = MakeMonitor(o.common);
    SceneReportJob job = o.job;
    job.camera = o.view.camera;
    job.width_px = o.view.width_px;
    job.height_px = o.view.height_px;
    job.guard_px = o.view.guard_px;
    job.seed = o.common.seed;
    job.pictures = folder / "pictures";
    const SceneReport report =
        ReportScene(LoadScene(name), job, PLUMB_VERSION, CommandLine(), NowS, *monitor);
    const std::filesystem::path page = WriteSceneReport(folder, report);
    if (o.common.json) {
        std::cout << ToJsonText(report);
    } else if (!o.common.quiet) {
        WriteTable(std::cout, report);
        std::cout << "\nReport: " << page.string() << "\n";
    }
}

void Run(const Options& o) {
    SetThreadCount(o.common.threads);
    for (const std::string& scene : o.scenes) {
        RunOne(o, scene,
               o.scenes.size() == 1 ? o.common.out
                                    : o.common.out / std::filesystem::path(scene).stem());
    }
}

}  // namespace

void AddReport(CLI::App& program) {
    auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand(
        "report",
        "Score screen-space techniques against the path-traced truth of a view: errors with\n"
        "their uncertainties, an error budget, error against run time, times pass by pass.\n"
        "Writes report.html, report.json, scores.csv, sweep.csv and pictures.");
    command
        ->add_option("scenes", o->scenes,
                     "scene.json files, or generated scenes such as atrium (docs/scenes.md)")
        ->required();
    std::string names;
    for (const std::string& name : TechniqueNames())
        names += (names.empty() ? "" : ", ") + name;
    command->add_option("--technique", o->job.techniques, "Only these, of: " + names);
    command->add_option("--radius", o->job.radius_m, "Radius of every technique [m]")
        ->capture_default_str();
    command
        ->add_option("--budget", o->job.budget,
                     "Preset of SAO whose error is split: paper, supplement2012 or g3d10")
        ->capture_default_str();
    command
        ->add_option("--spp", o->job.spp,
                     "Rays a pixel of the truth: a power of two, at least 16")
        ->capture_default_str();
    command->add_option("--rounds", o->job.rounds, "Runs of every timing; medians count")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_flag("!--no-studies", o->job.studies,
                      "Leave out budget, sweep, times and flicker");
    AddViewOptions(*command, o->view);
    AddCommon(*command, o->common);
    command->callback([o] { Run(*o); });
}

}  // namespace plumb::app
