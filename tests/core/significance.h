// One risk of a false alarm for the whole test program, shared among its statistical tests.
#pragma once

#include <vector>

#include "core/distributions.h"
#include "core/intervals.h"

namespace plumb {

/// The chance that an honest program fails any of the statistical tests of core_test: 1e-3,
/// shared among at most 1000 comparisons (the flip rates of sobol_test.cpp are 496 of them).
/// All seeds are fixed, so what passes once passes always.
inline const double kLevel = SidakLevel(1e-3, 1000);

/// The number of standard errors that one mean may be off, on either side.
inline const double kSigmas = NormalQuantile(1 - kLevel / 2);

/// p-value of counts against what was expected of them; every expectation should be >= 5.
inline double ChiSquarePValue(const std::vector<int>& counts,
                              const std::vector<double>& expected) {
    double chi2 = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double off = counts[i] - expected[i];
        chi2 += off * off / expected[i];
    }
    return ChiSquareSurvival(chi2, double(counts.size()) - 1);
}

inline double ChiSquarePValue(const std::vector<int>& counts, double expected) {
    return ChiSquarePValue(counts, std::vector<double>(counts.size(), expected));
}

}  // namespace plumb
