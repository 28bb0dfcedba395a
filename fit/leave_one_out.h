// The score of a formula on a map that it has not seen, each map in its turn.
//
// Every method learns from all maps but one and is scored on that one: the error to expect
// on a surface of one's own, as far as the maps at hand stand for it.
//
// Beware   Maps that are variants of one surface tell of each other: leave the whole family out
//          by handing it over as one map, or the error is too small.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/bounce_histogram.h"
#include "core/monitor.h"
#include "fit/fitting_method.h"
#include "fit/scores.h"

namespace plumb {

struct HeldOut {
    ScoreRow scores;                ///< Element m: scored on map m.
    std::vector<Formula> formulas;  ///< Element m: learnt from all maps but m.
};

/// One row a method, in their order. Throws Error if there are fewer than two maps.
std::vector<HeldOut> LeaveOneMapOut(std::span<const BounceHistogram> maps,
                                    std::span<const FittingMethod> methods,
                                    Monitor& monitor = SilentMonitor());

}  // namespace plumb
