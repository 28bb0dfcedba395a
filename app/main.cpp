// plumb: holds the approximations of real-time rendering against a path-traced truth.
//
// Exit status: 0 done, 1 a check failed, 2 bad input or usage, 3 the machine failed us, 130
// interrupted. Nothing below main() decides about it.
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/flag_names.h"
#include "app/process.h"
#include "core/error.h"

namespace plumb::app {
namespace {

// The status of --help and of what the parser refuses.
int Parse(CLI::App& program, int argc, char** argv) {
    try {
        program.parse(argc, argv);
        return 0;
    } catch (const CLI::RequiredError& error) {
        // The parser misses a subcommand before it minds the word that stands in its place.
        const std::vector<std::string> unknown = program.remaining(true);
        if (unknown.empty()) {
            program.exit(error);
            return 2;
        }
        throw Error(unknown.front() + ": no such subcommand or option; --help lists them");
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : 2;
    } catch (const Error& error) {
        throw Error(InFlags(error.what(), program));
    }
}

int Run(int argc, char** argv) {
    CLI::App program{
        "plumb holds the approximations of real-time rendering against a path-traced truth,\n"
        "says how wrong each step is and what it costs, and refits its constants."};
    program.name("plumb");
    program.set_version_flag("--version", "plumb " PLUMB_VERSION);
    program.require_subcommand(1);
    program.footer(
        "Height maps are images (docs/height_maps.md) or make:KIND[:SIZE[:SEED]], such as\n"
        "make:stone_wall:256. Try: plumb fit make:stone_wall make:bricks make:cobbles\n"
        "Exit status: 0 done, 1 a check failed, 2 bad input, 3 disk or memory, 130 "
        "interrupted.");
    RememberCommandLine(argc, argv);
    AddListed(program, "");
    const int status = Parse(program, argc, argv);
    FlushOutput();
    return status;
}

}  // namespace
}  // namespace plumb::app

int main(int argc, char** argv) {
    plumb::app::PrepareProcess();
    try {
        return plumb::app::Run(argc, argv);
    } catch (...) {
        return plumb::app::StatusOfException();
    }
}
