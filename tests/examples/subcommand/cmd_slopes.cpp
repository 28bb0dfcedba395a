// plumb slopes: how steep a height map is.
//
// Options -> struct -> call -> print.
#include <memory>
#include <string>

#include "app/command.h"
#include "jobs/light/surface.h"
#include "tests/examples/study/slopes.h"

namespace plumb::app {
namespace {

struct Options {
    std::string map;
    Common common;
};

void Run(const Options& o) {
    const auto monitor = MakeMonitor(o.common);
    const RunContext run = ContextOf(o.common, *monitor);
    const Surface surface = LoadSurface(o.map);
    Publish({.kind = "slopes",
             .title = "Slopes of " + surface.source.name,
             .provenance = doc::ProvenanceOf(run),
             .sections = {StudySlopes(surface.field)}},
            o.common);
}

void Add(CLI::App& program) {
    auto o = std::make_shared<Options>();
    CLI::App* slopes = program.add_subcommand("slopes", "How steep a height map is");
    slopes->add_option("map", o->map, "Height map, or make:KIND[:SIZE[:SEED]]")->required();
    AddCommon(*slopes, o->common);
    slopes->callback([o] { Run(*o); });
}

const Listed kListed("", 80, Add);

}  // namespace
}  // namespace plumb::app
