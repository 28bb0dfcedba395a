// plumb report: a scene's techniques against its truth, step by step.
//
// Options -> struct -> call -> print.
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/view_options.h"
#include "core/parallel.h"
#include "jobs/screen_space/report_folders.h"
#include "jobs/screen_space/report_scene.h"

namespace plumb::app {
namespace {

struct Options {
    std::vector<std::string> scenes;
    SceneReportJob job;
    ViewOptions view;
    std::vector<std::string> set;
    Common common;
    CLI::Option* out = nullptr;
};

void RunOne(const Options& o, const LoadedScene& loaded, const std::filesystem::path& folder,
            Monitor& monitor) {
    SceneReportJob job = o.job;
    job.set = ValuesOfSet(o.set);
    job.width_px = o.view.width_px;
    job.height_px = o.view.height_px;
    job.guard_px = o.view.guard_px;
    job.seed = o.common.seed;
    job.pictures = folder / "pictures";
    const doc::Document report = ReportScene(loaded, job, ContextOf(o.common, monitor));
    const std::filesystem::path page = WriteSceneReport(folder, report);
    if (o.common.json) {
        std::cout << doc::ToJsonText(report);
    } else if (!o.common.quiet) {
        std::cout << doc::ToTerminal(InBrief(report)) << "\nReport: " << page.string() << "\n";
    }
}

void Run(const Options& o) {
    const auto monitor = MakeMonitor(o.common);
    std::optional<std::filesystem::path> out;
    if (o.out->count() > 0) out = o.common.out;
    const std::vector<std::filesystem::path> folders = ReportFolders(o.scenes, out);
    Validate(o.job);
    // All of them before the first report: a name that is wrong is told at once.
    std::vector<LoadedScene> loaded;
    for (const std::string& scene : o.scenes) loaded.push_back(LoadScene(scene));
    for (std::size_t k = 0; k < folders.size(); ++k) {
        RunOne(o, loaded[k], folders[k], *monitor);
    }
}

void Add(CLI::App& program) {
    auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand(
        "report",
        "Score screen-space techniques against the path-traced truth of every camera of a\n"
        "scene: errors with their uncertainties, and of the first camera an error budget,\n"
        "error against run time, times pass by pass.\n"
        "Writes report.html, report.json, report.csv, scores.csv, sweep.csv and pictures.");
    command
        ->add_option("scenes", o->scenes,
                     "scene.json files, or generated scenes such as atrium (docs/scenes.md)")
        ->required();
    std::string names;
    for (const std::string& name : TechniqueNames())
        names += (names.empty() ? "" : ", ") + name;
    command->add_option("--technique", o->job.techniques, "Only these, of: " + names);
    command->add_option("--camera", o->job.cameras,
                        "Only these cameras; all if not given. The first has the studies");
    command->add_option(
        "--radius", o->job.radius_m,
        "Radius of the truth and of every technique [m]; not given: the truth's is "
        "1.5, a technique's that of the scene's file, else 1.5");
    command
        ->add_option(
            "--budget", o->job.budget,
            "Preset of SAO whose error is split: paper, supplement2012, g3d10 or alchemy")
        ->capture_default_str();
    command
        ->add_option("--spp", o->job.spp,
                     "Rays a pixel of the first camera's truth: a power of two, at least 16")
        ->capture_default_str();
    command->add_option("--other-spp", o->job.other_spp,
                        "The same of the other cameras; not given: a quarter, at least 16");
    command->add_option("--rounds", o->job.rounds, "Runs of every timing; medians count")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_flag("!--no-studies", o->job.studies,
                      "Leave out budget, sweep, times and flicker");
    AddSetOption(*command, o->set);
    AddPictureOptions(*command, o->view);
    AddCommon(*command, o->common);
    o->out = command->get_option("--out");
    o->out->default_str("out/report-SCENE");
    command->callback([o] { Run(*o); });
}

const Listed kListed("", 50, Add);

}  // namespace
}  // namespace plumb::app
