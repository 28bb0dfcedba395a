// Techniques run in turns: the picture of each, and how long each of its passes takes.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/measured.h"
#include "core/monitor.h"
#include "jobs/screen_space/technique.h"

namespace plumb {

/// What runs, and on which G-buffer.
struct TechniqueTurn {
    const Technique* technique;
    const TechniqueInput* input;
};

struct PassSeconds {
    std::string name;
    Measured seconds;
};

struct TimedTechnique {
    Image<float> A;  ///< Of the shown size, after the last pass.
    std::vector<PassSeconds> passes;
    Measured seconds;  ///< Of all passes.
};

/// One result a turn. `rounds` count, after one that warms up.
std::vector<TimedTechnique> TimeTechniques(std::span<const TechniqueTurn> turns, int rounds,
                                           const Clock& clock,
                                           Monitor& monitor = SilentMonitor());

}  // namespace plumb
