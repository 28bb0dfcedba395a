// The example of docs/extending.md: a fit model of one free constant, with its shader code.
//
//       E(rho) = V (1 + c rho (1 - V))
//
// The direct light and the first bounce, as if the surfaces around were lit like the point itself:
// the beginning of the cavity's series (fit/models/uniform_cavity.h), of which c is kept.
//
// Symbols  V cosine visibility, rho albedo, c the share of the bounce that comes back.
// Domain   0 <= V <= 1, 0 <= rho <= 1, 0 <= c <= 1: then V <= E <= V (2 - V) <= 1.
// Beware   E(1) is not 1: the bounces after the first are missing.
#pragma once

#include <array>
#include <string_view>

#include "core/visibility.h"
#include "fit/model.h"

namespace plumb {

struct OneBounceModel {
    static constexpr std::string_view kName = "one bounce";
    static constexpr std::array<Parameter, 1> kParameters{{{"c", 0.5, 0, 1}}};
    static constexpr ModelUse kUse = ModelUse::kRefitted;
    static constexpr std::string_view kShader = R"(
    float V = PlumbUnit(cosine_visibility);
    {T} rho = PlumbUnit(albedo);
    return PlumbUnit(V * (1.0f + {c} * (1.0f - V) * rho));
)";

    template <class T>
    static T Evaluate(const T* p, CosineVisibility V, Albedo rho) {
        return V.value * (1.0 + p[0] * rho.value * (1 - V.value));
    }
};

}  // namespace plumb
