// The escape family from cosine visibility with a bend: for renderers that have no alpha.
//
//       g = V^b (1 - c (1 - V)),        E as in fit/models/escape_probability.h
//
// Near V = 1 every surface is open and g -> 1, whatever the constants: the power law a V^b of
// EscapeOfV cannot do that unless a = 1. With b >= 0 and 0 <= c <= 1, g lies in [0, 1] without
// a clamp, and every law of fit/models/escape_probability.h holds.
//
// Source   ours; see fit/models/escape_of_alpha_and_v.h.
// Symbols  V cosine visibility, rho albedo, g escape probability.
// Domain   0 <= V <= 1, 0 <= rho <= 1, b >= 0, 0 <= c <= 1.
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "core/visibility.h"
#include "fit/model.h"
#include "fit/models/escape_probability.h"

namespace plumb {

struct EscapeBentOfV {
    static constexpr std::string_view kName = "bent escape of V";
    static constexpr std::array<Parameter, 2> kParameters{{
        {"b", 0.5, 0, 6},
        {"c", 0.5, 0, 1},
    }};
    static constexpr ModelUse kUse = ModelUse::kRefitted;
    static constexpr std::string_view kShader = R"(
    float V = PlumbUnit(cosine_visibility);
    {T} rho = PlumbUnit(albedo);
    float g = V > 0.0f ? PlumbUnit(pow(V, {b}) * (1.0f - {c} * (1.0f - V))) : 0.0f;
    return PlumbUnit(1.0f - (1.0f - V) * ((1.0f - rho) / max((1.0f - rho) + rho * g, 1e-20f)));
)";

    template <class T>
    static T Evaluate(const T* p, CosineVisibility V, Albedo rho) {
        using std::pow;
        const T visibility(V.value);
        const T g =
            V.value > 0 ? T(pow(visibility, p[0]) * (1.0 - p[1] * (1.0 - V.value))) : T(0.0);
        return EscapeTotal(visibility, g, rho);
    }
};

}  // namespace plumb
