// What a kernel calls a field of its options, the user gave as a flag.
//
//     GtaoOptions::radius_m = -1, must be in (0, infinity)
//     --radius = -1, must be in (0, infinity)
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace plumb::app {

/// The message of an error with the names of fields ("Struct::radius_m") made flags of the
/// subcommand that was called ("--radius"). A field without such a flag loses its struct.
std::string InFlags(const std::string& message, const CLI::App& program);

}  // namespace plumb::app
