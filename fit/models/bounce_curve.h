// The family of curves, one for each bounce: how E_k depends on the uniform visibility.
//
//       E_k(alpha) = A alpha (1 - alpha)^(3/2) exp(-B alpha^C)         A, B, C free for each k
//
// Source   [Mayaux18], "Summing the Curves", the unnumbered log-normal form; for k = 1 and
//          C = 1/4 it is [Mayaux18 eq. 11] (fit/models/first_bounce.h).
// Symbols  alpha uniform visibility; E_k irradiance of bounce k at albedo 1, over pi.
// Domain   0 <= alpha <= 1, C > 0.
// Beware   As C falls, A and B grow and compensate each other: read their correlation and the
//          condition number of the fit before you read A.
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "core/visibility.h"
#include "fit/model.h"

namespace plumb {

/// The general curve A alpha (1 - alpha)^q exp(-B alpha^C).
template <class T = double>
struct BounceCurve {
    T A, B, C, q;
};

template <class T>
T Evaluate(const BounceCurve<T>& curve, UniformVisibility alpha) {
    using std::exp;
    using std::pow;
    return curve.A * alpha.value * pow(1 - alpha.value, curve.q) *
           exp(-curve.B * pow(alpha.value, curve.C));
}

/// The exponent of (1 - alpha) that the paper fixes for every bounce.
inline constexpr double kMayaux18Falloff = 1.5;

/// Bounces that the paper fits.
inline constexpr int kMayaux18Bounces = 20;

/// One bounce's curve, to be fitted to E_k over alpha. Initial values: those that the author's
/// own fits start from.
struct BounceCurveModel {
    static constexpr std::string_view kName = "E_k";
    static constexpr std::array<Parameter, 3> kParameters{{
        {"A", 1, 1e-3, 1e9},
        {"B", 20, 0.01, 100},
        {"C", 1, 0.02, 4},
    }};

    template <class T>
    static T Evaluate(const T* p, UniformVisibility alpha) {
        return plumb::Evaluate(BounceCurve<T>{p[0], p[1], p[2], T(kMayaux18Falloff)}, alpha);
    }
};

}  // namespace plumb
