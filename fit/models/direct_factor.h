// The direct factor F0: cosine visibility guessed from uniform visibility.
//
//       F0(alpha) = alpha (1 + a (1 - alpha)^p)                        [Mayaux18 eq. 7]
//
// Source   [Mayaux18 eq. 7], used for the direct light in [Mayaux18 eq. 6].
// Symbols  alpha uniform visibility; a, p free constants, a = 1/2 and p = 3/4 as published.
// Domain   0 <= alpha <= 1, p > 0.
// Beware   V is no function of alpha: any V in [alpha^2, alpha (2 - alpha)] occurs. F0 keeps
//          the upper bound for every alpha only if a (1 - alpha)^(p - 1) <= 1, that is a <= 1
//          and p >= 1 (or a <= 0); the lower one if a >= 0, or a >= -1 and p >= 1. The
//          published p = 3/4 breaks the upper bound near alpha = 1, and with it F0 <= 1: where,
//          is found by fit/mayaux_faults.h.
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "core/visibility.h"
#include "fit/model.h"

namespace plumb {

template <class T = double>
struct DirectFactor {
    T a, p;
};

/// As published.
inline constexpr DirectFactor<> kMayaux18DirectFactor{.a = 0.5, .p = 0.75};

/// F0(alpha). Unitless.
template <class T>
T Evaluate(const DirectFactor<T>& F0, UniformVisibility alpha) {
    using std::pow;
    return alpha.value * (1.0 + F0.a * pow(1 - alpha.value, F0.p));  // [Mayaux18 eq. 7]
}

/// F0 as a curve to be fitted to E_0 over alpha.
struct DirectFactorModel {
    static constexpr std::string_view kName = "F0";
    static constexpr std::array<Parameter, 2> kParameters{{
        {"a", kMayaux18DirectFactor.a, -1, 4},
        {"p", kMayaux18DirectFactor.p, 0.05, 10},
    }};

    template <class T>
    static T Evaluate(const T* p, UniformVisibility alpha) {
        return plumb::Evaluate(DirectFactor<T>{p[0], p[1]}, alpha);
    }
};

}  // namespace plumb
