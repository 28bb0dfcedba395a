// The cubic that turns cosine visibility into the total of all bounces.
//
//       E(rho) = max( V, ((a V + b) V + c) V )
//       a = a1 rho + a0      b = b1 rho + b0      c = c1 rho + c0
//
// Source   [Jimenez16] J. Jimenez et al., Practical Real-Time Strategies for Accurate Indirect
//          Occlusion, 2016, the multi-bounce approximation: fitted there to three bounces. Its
//          six constants are a fit's initial values; fitted to all bounces they are others.
// Symbols  V cosine visibility, rho albedo.
// Domain   0 <= V <= 1, 0 <= rho <= 1.
// Beware   V is its input by definition. Maps that hold alpha are often fed to it: that misuse
//          is a model of its own here, so that its price shows. E(1) is not 1 and E may exceed
//          1, whatever the constants: no law holds by construction but E >= V.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "core/visibility.h"
#include "fit/model.h"

namespace plumb {

template <class T = double>
struct GtaoCubic {
    T a1, a0, b1, b0, c1, c0;
};

/// As published.
inline constexpr GtaoCubic<> kJimenez16{
    .a1 = 2.0404, .a0 = -0.3324, .b1 = -4.7951, .b0 = 0.6417, .c1 = 2.7552, .c0 = 0.6903};

/// E(V, rho). Unitless.
template <class T>
constexpr T Evaluate(const GtaoCubic<T>& cubic, CosineVisibility visibility, Albedo albedo) {
    using std::max;
    const double V = visibility.value, rho = albedo.value;
    const T a = cubic.a1 * rho + cubic.a0;
    const T b = cubic.b1 * rho + cubic.b0;
    const T c = cubic.c1 * rho + cubic.c0;
    return max(T(V), T(((a * V + b) * V + c) * V));
}

/// With its six constants free.
struct GtaoCubicModel {
    static constexpr std::string_view kName = "GTAO cubic";
    // The ranges hold the published constants several times over.
    static constexpr std::array<Parameter, 6> kParameters{{
        {"a1", kJimenez16.a1, -20, 20},
        {"a0", kJimenez16.a0, -20, 20},
        {"b1", kJimenez16.b1, -20, 20},
        {"b0", kJimenez16.b0, -20, 20},
        {"c1", kJimenez16.c1, -20, 20},
        {"c0", kJimenez16.c0, -20, 20},
    }};
    static constexpr ModelUse kUse = ModelUse::kRefitted;
    static constexpr std::string_view kShader = R"(
    float V = PlumbUnit(cosine_visibility);
    {T} rho = PlumbUnit(albedo);
    {T} a = {a1} * rho + {a0};
    {T} b = {b1} * rho + {b0};
    {T} c = {c1} * rho + {c0};
    return PlumbUnit(max(((a * V + b) * V + c) * V, V));
)";

    template <class T>
    static T Evaluate(const T* p, CosineVisibility V, Albedo rho) {
        return plumb::Evaluate(GtaoCubic<T>{p[0], p[1], p[2], p[3], p[4], p[5]}, V, rho);
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
