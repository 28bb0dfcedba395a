// The cubic that turns cosine visibility into the total of all bounces.
//
//       E(rho) = max( V, ((a V + b) V + c) V )
//       a = a1 rho + a0      b = b1 rho + b0      c = c1 rho + c0
//
// Source   [Jimenez16] J. Jimenez et al., Practical Real-Time Strategies for Accurate Indirect
//          Occlusion, 2016, the multi-bounce approximation: fitted there to three bounces.
// Symbols  V cosine visibility, rho albedo.
// Domain   0 <= V <= 1, 0 <= rho <= 1.
// Beware   V is its input by definition. Maps that hold alpha are often fed to it: that misuse
//          is a model of its own here, so that its price shows. E(1) is not 1.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "core/visibility.h"
#include "fit/model.h"

namespace plumb {

struct GtaoCubic {
    double a1, a0, b1, b0, c1, c0;
};

/// As published.
inline constexpr GtaoCubic kJimenez16{
    .a1 = 2.0404, .a0 = -0.3324, .b1 = -4.7951, .b0 = 0.6417, .c1 = 2.7552, .c0 = 0.6903};

/// E(V, rho). Unitless.
constexpr double Evaluate(const GtaoCubic& cubic, CosineVisibility visibility, Albedo albedo) {
    const double V = visibility.value, rho = albedo.value;
    const double a = cubic.a1 * rho + cubic.a0;
    const double b = cubic.b1 * rho + cubic.b0;
    const double c = cubic.c1 * rho + cubic.c0;
    return std::max(V, ((a * V + b) * V + c) * V);
}

struct GtaoCubicModel {
    static constexpr std::string_view kName = "GTAO cubic";
    static constexpr std::array<Parameter, 0> kParameters{};

    template <class T>
    static T Evaluate(const T*, CosineVisibility V, Albedo rho) {
        return T(plumb::Evaluate(kJimenez16, V, rho));
    }
};

/// The same, fed alpha as if it were V: wrong on purpose.
struct GtaoCubicFedAlphaModel {
    static constexpr std::string_view kName = "GTAO cubic, fed alpha";
    static constexpr std::array<Parameter, 0> kParameters{};

    template <class T>
    static T Evaluate(const T*, UniformVisibility alpha, Albedo rho) {
        return T(plumb::Evaluate(kJimenez16, CosineVisibility(alpha.value), rho));
    }
};

}  // namespace plumb
