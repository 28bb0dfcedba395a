// plumb: holds the approximations of real-time rendering against a path-traced truth.
//
// Exit status: 0 done, 1 a check failed, 2 bad input or usage, 3 the machine failed us, 130
// interrupted. Nothing below main() decides about it.
#include <CLI/CLI.hpp>
#include <iostream>
#include <new>

#include "app/command.h"
#include "core/error.h"

int main(int argc, char** argv) {
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
    plumb::app::RememberCommandLine(argc, argv);
    plumb::app::AddFit(program);
    plumb::app::AddSimulate(program);
    plumb::app::AddTruth(program);
    plumb::app::AddRender(program);
    plumb::app::AddReport(program);
    plumb::app::AddBench(program);
    try {
        program.parse(argc, argv);
        return 0;
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : 2;
    } catch (const plumb::Error& error) {
        std::cerr << "plumb: " << error.what() << "\n";
        return 2;
    } catch (const plumb::MachineError& error) {
        std::cerr << "plumb: " << error.what() << "\n";
        return 3;
    } catch (const std::bad_alloc&) {
        std::cerr << "plumb: out of memory\n";
        return 3;
    } catch (const plumb::Interrupted&) {
        std::cerr << "plumb: interrupted\n";
        return 130;
    }
}
