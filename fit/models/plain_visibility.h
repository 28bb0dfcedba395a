// No interreflection at all: what a renderer does that multiplies by its occlusion map.
//
//       E(rho) = alpha        [Mayaux18 eq. 4]
//       E(rho) = V            the direct light alone
//
// Source   [Mayaux18 eq. 4], which the paper calls incorrectly simplified.
// Symbols  alpha uniform visibility, V cosine visibility, rho albedo (of no effect).
#pragma once

#include <array>
#include <string_view>

#include "core/visibility.h"
#include "fit/model.h"

namespace plumb {

struct PlainAlphaModel {
    static constexpr std::string_view kName = "plain alpha";
    static constexpr std::array<Parameter, 0> kParameters{};

    template <class T>
    static T Evaluate(const T*, UniformVisibility alpha, Albedo) {
        return T(alpha.value);  // [Mayaux18 eq. 4]
    }
};

struct PlainVModel {
    static constexpr std::string_view kName = "plain V";
    static constexpr std::array<Parameter, 0> kParameters{};

    template <class T>
    static T Evaluate(const T*, CosineVisibility V, Albedo) {
        return T(V.value);
    }
};

}  // namespace plumb
