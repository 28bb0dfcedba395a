// What every subcommand needs: its registration, the common options and the way to the user.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "core/monitor.h"
#include "jobs/light/simulate_surface.h"

namespace plumb::app {

/// Options that every subcommand has.
struct Common {
    std::filesystem::path out = "out";
    int threads = 0;
    std::uint64_t seed = 1;
    bool quiet = false;
    bool json = false;
};

/// Declares --out, --threads, --seed, --quiet and --json.
void AddCommon(CLI::App& command, Common& common);

/// A progress line with the time that is left, on a terminal only; learns of Ctrl-C. Sets the
/// number of threads. Throws Error or MachineError if --out is empty or cannot be written to.
std::unique_ptr<Monitor> MakeMonitor(const Common& common);

/// Seconds of the steady clock.
double NowS();

/// The command line as the user gave it, for provenance: "plumb fit a.png --slices 64". --out,
/// --threads, --cache, --no-cache, --resume, --quiet and --json are left out: they change no
/// number.
std::string CommandLine();
void RememberCommandLine(int argc, char** argv);

void AddFit(CLI::App& program);
void AddSimulate(CLI::App& program);
void AddTruth(CLI::App& program);
void AddRender(CLI::App& program);
void AddReport(CLI::App& program);
void AddTechniques(CLI::App& program);
void AddBench(CLI::App& program);
void AddBenchRaster(CLI::App& bench);
void AddBenchTruth(CLI::App& bench);
void AddBenchAo(CLI::App& bench);

}  // namespace plumb::app
