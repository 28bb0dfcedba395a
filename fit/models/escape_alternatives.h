// The forms of the escape probability that the recommended one was chosen from.
//
//       E as in fit/models/escape_probability.h, with
//
//       linear of V      g = a + b V
//       of alpha         g = alpha^c
//       of closures      g = 1 - (1 - V)^b (1 - alpha)^c
//       scaled           g = a V^b alpha^c
//       raised           g = a + (1 - a) V^b alpha^c
//
// each clamped to [0, 1], and two in which light escapes at its first bounce with g_1 and at
// every later one with g:
//
//       E(rho) = V + (1 - V) rho (g_1 + (1 - g_1) rho g / (1 - rho (1 - g)))
//
//       two, linear      g_1 = a + b V,            g = c + d V
//       two, powers      g_1 = V^b alpha^c,        g = V^d alpha^e
//
// Source   ours. `plumb fit --forms` fits them all and scores each on maps held out.
// Symbols  V cosine visibility, alpha uniform visibility, rho albedo, g escape probability.
// Domain   0 <= V, alpha, rho <= 1; any constants, as g is clamped.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/visibility.h"
#include "fit/model.h"
#include "fit/models/escape_probability.h"

namespace plumb {

template <class T>
T Probability(const T& g) {
    using std::max;
    using std::min;
    return min(max(g, T(0.0)), T(1.0));
}

/// x^p for a visibility x; 0 where there is no sky, whatever the power.
template <class T>
T PowerOf(double x, const T& p) {
    using std::pow;
    return x > 0 ? T(pow(T(x), p)) : T(0.0);
}

/// The total of two escapes. The second form is the share that is still dark, which cannot
/// leave [0, 1] by rounding.
template <class T>
T TwoEscapesTotal(double V, const T& g_1, const T& g, Albedo rho) {
    if (rho.value >= 1) return T(1.0);
    const T later = rho.value * g / ((1.0 - rho.value) + rho.value * g);
    return 1.0 - (1.0 - V) * (1.0 - rho.value * (g_1 + (1.0 - g_1) * later));
}

struct EscapeLinearOfV {
    static constexpr std::string_view kName = "escape a + b V";
    static constexpr std::array<Parameter, 2> kParameters{
        {{"a", 0.3, -1, 2}, {"b", 0.7, -2, 3}}};
    static constexpr ModelUse kUse = ModelUse::kForm;

    template <class T>
    static T Evaluate(const T* p, CosineVisibility V, Albedo rho) {
        return EscapeTotal(T(V.value), Probability(T(p[0] + p[1] * V.value)), rho);
    }
};

struct TwoEscapesLinearOfV {
    static constexpr std::string_view kName = "two escapes, linear";
    static constexpr std::array<Parameter, 4> kParameters{
        {{"a", 0.3, -1, 2}, {"b", 0.7, -2, 3}, {"c", 0.3, -1, 2}, {"d", 0.7, -2, 3}}};
    static constexpr ModelUse kUse = ModelUse::kForm;

    template <class T>
    static T Evaluate(const T* p, CosineVisibility V, Albedo rho) {
        return TwoEscapesTotal(V.value, Probability(T(p[0] + p[1] * V.value)),
                               Probability(T(p[2] + p[3] * V.value)), rho);
    }
};

struct EscapePowerOfAlpha {
    static constexpr std::string_view kName = "escape alpha^c";
    static constexpr std::array<Parameter, 1> kParameters{{{"c", 0.5, 0, 6}}};
    static constexpr ModelUse kUse = ModelUse::kForm;

    template <class T>
    static T Evaluate(const T* p, UniformVisibility alpha, CosineVisibility V, Albedo rho) {
        return EscapeTotal(T(V.value), PowerOf(alpha.value, p[0]), rho);
    }
};

struct EscapeOfClosures {
    static constexpr std::string_view kName = "escape 1 - (1 - V)^b (1 - alpha)^c";
    static constexpr std::array<Parameter, 2> kParameters{{{"b", 0.5, 0, 6}, {"c", 0.5, 0, 6}}};
    static constexpr ModelUse kUse = ModelUse::kForm;

    template <class T>
    static T Evaluate(const T* p, UniformVisibility alpha, CosineVisibility V, Albedo rho) {
        const T g = 1.0 - PowerOf(1 - V.value, p[0]) * PowerOf(1 - alpha.value, p[1]);
        return EscapeTotal(T(V.value), Probability(g), rho);
    }
};

struct EscapeScaledOfBoth {
    static constexpr std::string_view kName = "escape a V^b alpha^c";
    static constexpr std::array<Parameter, 3> kParameters{
        {{"a", 1, 0.05, 4}, {"b", 0.5, 0, 6}, {"c", 0.5, 0, 6}}};
    static constexpr ModelUse kUse = ModelUse::kForm;

    template <class T>
    static T Evaluate(const T* p, UniformVisibility alpha, CosineVisibility V, Albedo rho) {
        const T g = p[0] * PowerOf(V.value, p[1]) * PowerOf(alpha.value, p[2]);
        return EscapeTotal(T(V.value), Probability(g), rho);
    }
};

struct EscapeRaisedOfBoth {
    static constexpr std::string_view kName = "escape a + (1 - a) V^b alpha^c";
    static constexpr std::array<Parameter, 3> kParameters{
        {{"a", 0.05, -1, 1}, {"b", 0.5, 0, 6}, {"c", 0.5, 0, 6}}};
    static constexpr ModelUse kUse = ModelUse::kForm;

    template <class T>
    static T Evaluate(const T* p, UniformVisibility alpha, CosineVisibility V, Albedo rho) {
        const T power = PowerOf(V.value, p[1]) * PowerOf(alpha.value, p[2]);
        return EscapeTotal(T(V.value), Probability(T(p[0] + (1.0 - p[0]) * power)), rho);
    }
};

struct TwoEscapesOfBoth {
    static constexpr std::string_view kName = "two escapes, powers";
    static constexpr std::array<Parameter, 4> kParameters{
        {{"b", 0.5, 0, 6}, {"c", 0.5, 0, 6}, {"d", 0.5, 0, 6}, {"e", 0.5, 0, 6}}};
    static constexpr ModelUse kUse = ModelUse::kForm;

    template <class T>
    static T Evaluate(const T* p, UniformVisibility alpha, CosineVisibility V, Albedo rho) {
        return TwoEscapesTotal(V.value, T(PowerOf(V.value, p[0]) * PowerOf(alpha.value, p[1])),
                               T(PowerOf(V.value, p[2]) * PowerOf(alpha.value, p[3])), rho);
    }
};

}  // namespace plumb
