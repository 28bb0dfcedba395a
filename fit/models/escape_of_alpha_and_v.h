// The escape family from both visibilities: the model that plumb recommends.
//
//                                  rho g
//       E(rho) = V + (1 - V) -----------------,        g = V^b alpha^c
//                             1 - rho (1 - g)
//
// The probability g that light leads on to the sky is a product of powers of the two
// visibilities. With b, c >= 0 it lies in [0, 1] without a clamp, so every law of
// fit/models/escape_probability.h holds: no pole; V <= E <= 1; E(0) = V; E(1) = 1; E rises with rho. V
// alone cannot tell the floor of a narrow pit, whose sky stands about the normal, from the side
// of a crest, whose sky lies along the horizon; the pair can, and the surfaces that surround
// the two have different escapes.
//
// Source   ours; found by comparing some thirty forms of none to four constants, each map held
//          out in turn (docs/models.md). The cavity (fit/models/uniform_cavity.h) is b = 1, c = 0.
// Symbols  V cosine visibility, alpha uniform visibility, rho albedo, g escape probability.
// Domain   0 <= V <= 1, 0 <= alpha <= 1, 0 <= rho <= 1, b >= 0, c >= 0.
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "core/visibility.h"
#include "fit/model.h"
#include "fit/models/escape_probability.h"

namespace plumb {

struct EscapeOfAlphaAndV {
    static constexpr std::string_view kName = "escape of alpha and V";
    static constexpr std::string_view kText =
        "g = V^b alpha^c;  E(rho) = V + (1 - V) rho g / (1 - rho (1 - g))";
    static constexpr std::array<Parameter, 2> kParameters{{
        {"b", 0.5, 0, 6},
        {"c", 0.5, 0, 6},
    }};
    static constexpr ModelUse kUse = ModelUse::kRefitted;
    // pow(0, 0) is undefined in GLSL and HLSL: b and c may be 0 where no sky is left.
    static constexpr std::string_view kShader = R"(
    float alpha = PlumbUnit(uniform_visibility);
    float V = PlumbUnit(cosine_visibility);
    {T} rho = PlumbUnit(albedo);
    float g = min(alpha, V) > 0.0f ? PlumbUnit(pow(V, {b}) * pow(alpha, {c})) : 0.0f;
    return PlumbUnit(1.0f - (1.0f - V) * ((1.0f - rho) / max((1.0f - rho) + rho * g, 1e-20f)));
)";

    template <class T>
    static T Evaluate(const T* p, UniformVisibility alpha, CosineVisibility V, Albedo rho) {
        using std::pow;
        // Where there is no sky there is no escape.
        const T g = V.value > 0 && alpha.value > 0
                        ? T(pow(T(V.value), p[0]) * pow(T(alpha.value), p[1]))
                        : T(0.0);
        return EscapeTotal(T(V.value), g, rho);
    }
};

}  // namespace plumb
