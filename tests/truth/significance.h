// One risk of a false alarm for the whole test program, shared among its statistical tests.
#pragma once

#include "core/distributions.h"
#include "core/intervals.h"

namespace plumb {

/// The chance that an honest program fails any statistical test of truth_test is 1e-3, shared
/// among at most 1000 comparisons. All seeds are fixed: what passes once passes always.
inline const double kLevel = SidakLevel(1e-3, 1000);

/// Standard errors that a mean with a normal error may be off.
inline const double kSigmas = NormalQuantile(1 - kLevel / 2);

/// The same for a mean whose error was estimated from `replicates` values: Student's t.
inline double Sigmas(int replicates) {
    return StudentQuantile(1 - kLevel / 2, replicates - 1);
}

}  // namespace plumb
