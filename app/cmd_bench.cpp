// plumb bench: speed as ratios to this machine's own limits.
#include "app/command.h"

namespace plumb::app {
namespace {

void Add(CLI::App& program) {
    CLI::App* bench =
        program.add_subcommand("bench", "Speed against this machine's own limits, in one run");
    bench->require_subcommand(1);
    AddListed(*bench, "bench");
}

const Listed kListed("", 90, Add);

}  // namespace
}  // namespace plumb::app
