// How long scoring takes, a megapixel.
#pragma once

#include "core/run_context.h"
#include "core/time_in_turns.h"
#include "reports/document.h"

namespace plumb {

struct ScoreBenchSettings {
    int width_px = 1024, height_px = 1024;
    int rounds = kTimedRounds;
};

/// Each metric on two made colour pictures of that size, all threads; table "metrics".
doc::Document BenchScore(const ScoreBenchSettings& settings, const RunContext& run);

}  // namespace plumb
