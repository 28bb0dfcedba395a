// What a job gets from whoever runs it, in one value.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/clock.h"
#include "core/monitor.h"

namespace plumb {

struct RunContext {
    std::string version = {};  ///< Of the program.
    std::string command = {};  ///< The command line that makes the result again.
    std::uint64_t seed = 1;
    Clock clock = [] { return 0.0; };
    Monitor& monitor = SilentMonitor();  ///< Progress, and whether to stop.
    std::filesystem::path folder = {};   ///< Where results go.
};

}  // namespace plumb
