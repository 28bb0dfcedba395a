// plumb render: one technique on one view, its passes as images.
//
// Options -> struct -> call -> print.
#include <iomanip>
#include <iostream>
#include <memory>
#include <string>

#include "app/command.h"
#include "app/view_options.h"
#include "core/parallel.h"
#include "jobs/screen_space/render_scene.h"

namespace plumb::app {
namespace {

struct Options {
    std::string scene;
    RenderJob job;
    ViewOptions view;
    TechniqueOptions technique;
    Common common;
};

void Run(Options o) {
    SetThreadCount(o.common.threads);
    const auto monitor = MakeMonitor(o.common);
    o.job.values = ValuesFor(o.technique, o.job.technique);
    o.job.camera = o.view.camera;
    o.job.width_px = o.view.width_px;
    o.job.height_px = o.view.height_px;
    o.job.guard_px = o.view.guard_px;
    const RenderResult result =
        RenderScene(LoadScene(o.scene), o.job, ContextOf(o.common, *monitor));
    if (o.common.quiet) return;
    for (const auto& [pass, seconds] : result.seconds) {
        std::cout << std::left << std::setw(12) << pass << std::right << std::setw(9)
                  << std::fixed << std::setprecision(2) << seconds * 1e3 << " ms\n";
    }
    std::cout << "mean A of what is seen: " << std::setprecision(4) << result.mean
              << "\nImages: " << result.exr.string() << "\n";
}

void Add(CLI::App& program) {
    auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand(
        "render",
        "Run one screen-space technique on one view: G-buffer, then pass by pass.\n"
        "Writes render.exr and a PNG of every pass to the folder --out.");
    command
        ->add_option("scene", o->scene,
                     "A scene.json, or a generated scene such as atrium (docs/scenes.md)")
        ->required();
    std::string names;
    for (const std::string& name : TechniqueNames())
        names += (names.empty() ? "" : ", ") + name;
    command->add_option("--technique", o->job.technique, "One of: " + names)
        ->capture_default_str();
    AddTechniqueOptions(*command, o->technique);
    AddViewOptions(*command, o->view);
    AddCommon(*command, o->common);
    command->callback([o] { Run(*o); });
}

const Listed kListed("", 40, Add);

}  // namespace
}  // namespace plumb::app
