// The uniform cavity: the exact total where every point of a hollow sees the same share of sky.
//
//       E(rho) = V / (1 - rho (1 - V))
//
// Each bounce meets the hollow again with probability 1 - V, so E_k = V (1 - V)^k, summed over
// all k. It has no free constant.
//
// Source   the integrating sphere; exact in a spherical bowl and an infinite wedge.
// Symbols  V cosine visibility, rho albedo.
// Domain   0 <= V <= 1, 0 <= rho <= 1, not both V = 0 and rho = 1 (0 / 0; 1 is returned, the
//          limit along rho = 1).
#pragma once

#include <array>
#include <string_view>

#include "core/visibility.h"
#include "fit/model.h"

namespace plumb {

/// E(V, rho). Unitless, in [0, 1].
constexpr double CavityTotal(CosineVisibility V, Albedo rho) {
    if (rho.value >= 1) return 1;
    return V.value / ((1 - rho.value) + rho.value * V.value);
}

struct UniformCavityModel {
    static constexpr std::string_view kName = "cavity";
    static constexpr std::array<Parameter, 0> kParameters{};
    static constexpr std::string_view kShader = R"(
    float V = PlumbUnit(cosine_visibility);
    {T} rho = PlumbUnit(albedo);
    return PlumbUnit(1.0f - (1.0f - V) * ((1.0f - rho) / max((1.0f - rho) + rho * V, 1e-20f)));
)";

    template <class T>
    static T Evaluate(const T*, CosineVisibility V, Albedo rho) {
        return T(CavityTotal(V, rho));
    }
};

}  // namespace plumb
