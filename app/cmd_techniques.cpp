// plumb techniques: all that can be judged, with knobs, switches and papers.
//
// Options -> call -> print.
#include <iostream>
#include <memory>
#include <string>

#include "app/command.h"
#include "jobs/screen_space/list_techniques.h"

namespace plumb::app {
namespace {

struct Options {
    std::string name;
    bool json = false, markdown = false;
};

void Run(const Options& o) {
    std::cout << TechniquesText(o.name, o.json       ? TechniquesForm::kJson
                                        : o.markdown ? TechniquesForm::kMarkdown
                                                     : TechniquesForm::kText);
}

void Add(CLI::App& program) {
    auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand(
        "techniques",
        "List what can be judged; of one technique its knobs and switches, each with domain,\n"
        "published value and meaning. They are set with --set NAME.KNOB=VALUE.");
    command->add_option("name", o->name, "One technique; all if not given");
    CLI::Option* json = command->add_flag("--json", o->json, "As JSON");
    command->add_flag("--markdown", o->markdown, "As the page docs/techniques.md")
        ->excludes(json);
    command->callback([o] { Run(*o); });
}

const Listed kListed("", 60, Add);

}  // namespace
}  // namespace plumb::app
