// The first-bounce factor F1: the light of one bounce, guessed from uniform visibility.
//
//       F1(alpha) = A alpha (1 - alpha)^(3/2) exp(-B alpha^(1/4))      [Mayaux18 eq. 11]
//
// Source   [Mayaux18 eq. 11]. A = 86.635502983679205 / pi in the author's notebook: the curve
//          was fitted to E_1 and then divided by pi, so F1 is E_1 as this project has it.
// Symbols  alpha uniform visibility; A, B free constants; in the freer model also the exponents
//          q (3/2) and C (1/4).
// Domain   0 <= alpha <= 1.
// Beware   The published A, B come from 100 bin means with equal weight, set against an edge of
//          their bin: half a bin of shift is baked in.
#pragma once

#include <array>
#include <string_view>

#include "core/visibility.h"
#include "fit/model.h"
#include "fit/models/bounce_curve.h"

namespace plumb {

template <class T = double>
struct FirstBounce {
    T A, B;
};

/// As published.
inline constexpr FirstBounce<> kMayaux18FirstBounce{.A = 27.576937094210385,
                                                    .B = 3.3364392003423804};

/// The exponent C of alpha that the paper fixes for the first bounce.
inline constexpr double kMayaux18FirstBounceExponent = 0.25;

/// F1(alpha). Unitless.
template <class T>
T Evaluate(const FirstBounce<T>& F1, UniformVisibility alpha) {
    // [Mayaux18 eq. 11]
    return Evaluate(BounceCurve<T>{.A = F1.A,
                                   .B = F1.B,
                                   .C = T(kMayaux18FirstBounceExponent),
                                   .q = T(kMayaux18Falloff)},
                    alpha);
}

/// F1 as published, with A and B free: a curve to be fitted to E_1 over alpha.
struct FirstBounceModel {
    static constexpr std::string_view kName = "F1";
    static constexpr std::array<Parameter, 2> kParameters{{
        {"A", kMayaux18FirstBounce.A, 1e-3, 1e5},
        {"B", kMayaux18FirstBounce.B, 0.01, 40},
    }};

    template <class T>
    static T Evaluate(const T* p, UniformVisibility alpha) {
        return plumb::Evaluate(FirstBounce<T>{p[0], p[1]}, alpha);
    }
};

/// F1 with both exponents free as well.
struct FreeFirstBounceModel {
    static constexpr std::string_view kName = "F1, free exponents";
    static constexpr std::array<Parameter, 4> kParameters{{
        {"A", kMayaux18FirstBounce.A, 1e-3, 1e9},
        {"B", kMayaux18FirstBounce.B, 0.01, 100},
        {"C", kMayaux18FirstBounceExponent, 0.02, 4},
        {"q", kMayaux18Falloff, 0.1, 8},
    }};

    template <class T>
    static T Evaluate(const T* p, UniformVisibility alpha) {
        return plumb::Evaluate(BounceCurve<T>{p[0], p[1], p[2], p[3]}, alpha);
    }
};

}  // namespace plumb
