// The escape family: the paper's geometric series, written so that it cannot break.
//
//                                  rho g                    (1 - V) (1 - rho)
//       E(rho) = V + (1 - V) ----------------- = 1 - ---------------------
//                             1 - rho (1 - g)          (1 - rho) + rho g
//
//       g = clamp(a V^b, 0, 1)
//
// Light that does not come straight from the sky (1 - V) comes from a surface; from there it
// leads on to the sky with probability g at every bounce. This is [Mayaux18 eq. 10] with
// F1 = (1 - F0) g and tau = 1 - g, so [Mayaux18 eq. 9] holds by construction; but g is fitted,
// not F1, and for 0 <= g <= 1 these are laws, not hopes:
//
//       no pole;  0 <= V <= E <= 1;  E(0) = V;  E(1) = 1;  E rises with rho.
//
// The cavity (fit/models/uniform_cavity.h) is the member a = b = 1.
//
// Source   ours, from [Mayaux18 eq. 9] and [Mayaux18 eq. 10]. Initial values: a fit to the
//          author's own curves.
// Symbols  V cosine visibility, alpha uniform visibility, rho albedo, g escape probability.
// Domain   0 <= V <= 1, 0 <= alpha <= 1, 0 <= rho <= 1, any a, b.
// Beware   Without V the family guesses it by F0(alpha). What keeps it within alpha^2 and
//          alpha (2 - alpha) (fit/models/direct_factor.h) is either -1 <= a0 <= 1 and p0 >= 1, or,
//          with a0 >= 0 and any p0, min(F0, alpha (2 - alpha)). The first is smooth; the second
//          has a kink near alpha = 1 and reaches surfaces whose V rises faster than the first
//          can.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/visibility.h"
#include "fit/model.h"
#include "fit/models/direct_factor.h"

namespace plumb {

template <class T = double>
struct EscapeProbability {
    T a, b;
};

/// g(V), in [0, 1]. Where there is no sky there is no escape: g(0) = 0.
template <class T>
T Evaluate(const EscapeProbability<T>& g, const T& V) {
    using std::max;
    using std::min;
    using std::pow;
    if (!(V > 0.0)) return T(0.0);
    return min(max(g.a * pow(V, g.b), T(0.0)), T(1.0));
}

/// E of a visibility and an escape probability. The second form above, in which the quotient
/// cannot exceed 1: so 0 <= E <= 1 holds to the last bit, the other laws to a rounding of 1.
template <class T>
T EscapeTotal(const T& V, const T& g, Albedo rho) {
    if (rho.value >= 1) return T(1.0);
    return 1.0 - (1.0 - V) * ((1 - rho.value) / ((1 - rho.value) + rho.value * g));
}

/// From V: two free constants.
struct EscapeOfV {
    static constexpr std::string_view kName = "escape of V";
    static constexpr std::array<Parameter, 2> kParameters{{
        {"a", 1.027, 0.05, 4},
        {"b", 0.441, 0.01, 6},
    }};
    static constexpr ModelUse kUse = ModelUse::kRefitted;
    // 1e-20 keeps 0 / 0 away at rho = 1 and g = 0, where the numerator is 0, and is far below
    // anything that a float 1 - rho can be.
    static constexpr std::string_view kShader = R"(
    float V = PlumbUnit(cosine_visibility);
    {T} rho = PlumbUnit(albedo);
    float g = PlumbUnit({a} * pow(V, {b}));
    return PlumbUnit(1.0f - (1.0f - V) * ((1.0f - rho) / max((1.0f - rho) + rho * g, 1e-20f)));
)";

    template <class T>
    static T Evaluate(const T* p, CosineVisibility V, Albedo rho) {
        const T visibility(V.value);
        return EscapeTotal(visibility,
                           plumb::Evaluate(EscapeProbability<T>{p[0], p[1]}, visibility), rho);
    }
};

/// From alpha: V is guessed by F0, with two more constants.
struct EscapeOfAlpha {
    static constexpr std::string_view kName = "escape of alpha";
    static constexpr std::array<Parameter, 4> kParameters{{
        {"a0", 0.5, -1, 1},
        {"p0", 1, 1, 10},
        {"a", 1.022, 0.05, 4},
        {"b", 0.397, 0.01, 6},
    }};
    static constexpr std::string_view kShader = R"(
    float alpha = PlumbUnit(uniform_visibility);
    {T} rho = PlumbUnit(albedo);
    float V = PlumbUnit(alpha * (1.0f + {a0} * pow(1.0f - alpha, {p0})));
    float g = PlumbUnit({a} * pow(V, {b}));
    return PlumbUnit(1.0f - (1.0f - V) * ((1.0f - rho) / max((1.0f - rho) + rho * g, 1e-20f)));
)";

    template <class T>
    static T Evaluate(const T* p, UniformVisibility alpha, Albedo rho) {
        const T V = plumb::Evaluate(DirectFactor<T>{p[0], p[1]}, alpha);
        return EscapeTotal(V, plumb::Evaluate(EscapeProbability<T>{p[2], p[3]}, V), rho);
    }
};

/// From alpha, V guessed by min(F0, alpha (2 - alpha)).
struct EscapeOfAlphaClamped {
    static constexpr std::string_view kName = "escape of alpha, clamped";
    static constexpr std::array<Parameter, 4> kParameters{{
        {"a0", 0.485, 0, 4},
        {"p0", 0.78, 0.05, 10},
        {"a", 1.022, 0.05, 4},
        {"b", 0.397, 0.01, 6},
    }};
    static constexpr ModelUse kUse = ModelUse::kRefitted;
    // F0 is kept under alpha (2 - alpha), which no V exceeds.
    static constexpr std::string_view kShader = R"(
    float alpha = PlumbUnit(uniform_visibility);
    {T} rho = PlumbUnit(albedo);
    float F0 = alpha * (1.0f + {a0} * pow(1.0f - alpha, {p0}));
    float V = PlumbUnit(min(F0, alpha * (2.0f - alpha)));
    float g = PlumbUnit({a} * pow(V, {b}));
    return PlumbUnit(1.0f - (1.0f - V) * ((1.0f - rho) / max((1.0f - rho) + rho * g, 1e-20f)));
)";

    template <class T>
    static T Evaluate(const T* p, UniformVisibility alpha, Albedo rho) {
        using std::min;
        const T V = min(plumb::Evaluate(DirectFactor<T>{p[0], p[1]}, alpha),
                        T(GreatestCosineVisibility(alpha)));
        return EscapeTotal(V, plumb::Evaluate(EscapeProbability<T>{p[2], p[3]}, V), rho);
    }
};

}  // namespace plumb
