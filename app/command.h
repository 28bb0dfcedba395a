// What every subcommand needs: its registration, the common options and the way to the user.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "core/run_context.h"
#include "jobs/write_document.h"

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

/// Declares --rounds: of every timing, at least as many as a median needs.
void AddRounds(CLI::App& command, int& rounds);

/// Of an option: a finite number > 0.
CLI::Validator AboveZero();

/// A progress line with the time that is left, on a terminal only; learns of Ctrl-C. Sets the
/// number of threads. Throws Error or MachineError if --out is empty or cannot be written to.
std::unique_ptr<Monitor> MakeMonitor(const Common& common);

/// The command line as the user gave it, for provenance: "plumb fit a.png --slices 64". --out,
/// --threads, --cache, --no-cache, --resume, --quiet and --json are left out: they change no
/// number.
std::string CommandLine();
void RememberCommandLine(int argc, char** argv);

/// What a job is run with; `monitor` must outlive it.
RunContext ContextOf(const Common& common, Monitor& monitor);

/// As JSON, for a terminal with the path of the page that holds it, or not at all.
void Print(const doc::Document& document, const std::filesystem::path& page,
           const Common& common);

/// Writes the document into --out, and prints it.
void Publish(const doc::Document& document, const Common& common);

/// A subcommand that lists itself: one such object in its own file, which nobody else names.
struct Listed {
    /// `group`: the subcommand that it belongs to, "" for plumb itself; help lists a group by
    /// `place`.
    Listed(std::string group, int place, void (*add)(CLI::App& parent));
};

/// Adds all that list themselves in that group.
void AddListed(CLI::App& parent, const std::string& group);

}  // namespace plumb::app
