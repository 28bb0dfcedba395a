// The total of the paper: direct light plus a geometric series of bounces, from alpha alone.
//
//       E(rho) = F0 + rho / (1 - rho tau) F1             [Mayaux18 eq. 10] [Mayaux18 eq. 12]
//
// with F0, tau, F1 at the same alpha [Mayaux18 eq. 7] [Mayaux18 eq. 9] [Mayaux18 eq. 11].
//
// Source   [Mayaux18 eq. 8] is the series that eq. 10 sums; [Mayaux18 eq. 12] is eq. 10 with
//          the alpha of a map put in. E_0(x, n) of the paper is 1 here (core/conventions.h).
// Symbols  alpha uniform visibility, rho albedo.
// Domain   0 <= alpha <= 1, 0 <= rho <= 1.
// Beware   As printed (PoleGuard::kNone) the formula has a pole for every rho in (0, 1):
//          fit/mayaux_faults.h finds it. At alpha = 1 it is 0 / 0. Programs that ship it guard
//          it, each in its own way: the enumerators.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "core/visibility.h"
#include "fit/model.h"
#include "fit/models/bounce_ratio.h"
#include "fit/models/direct_factor.h"
#include "fit/models/first_bounce.h"

namespace plumb {

template <class T = double>
struct MayauxConstants {
    DirectFactor<T> F0;
    FirstBounce<T> F1;
};

/// As published.
inline constexpr MayauxConstants<> kMayaux18{.F0 = kMayaux18DirectFactor,
                                             .F1 = kMayaux18FirstBounce};

/// How a program keeps away from the pole.
enum class PoleGuard {
    kNone,  ///< As printed.
    kDemo,  ///< The author's demo: tau = 1 - F1 / (0.01 + sat(1 - F0)), 1 - sat(rho tau).
    kPort,  ///< A port in an engine: alpha <= 0.999, 1 - F0 >= 1e-5, 1 - rho tau >= 1e-5.
    kPortHalfAlbedo,  ///< The same with rho <= 0.5, as that engine ships it.
};

/// E of a direct factor, a first bounce and a ratio [Mayaux18 eq. 10].
template <class T>
T GeometricTotal(const T& F0, const T& F1, const T& tau, Albedo rho) {
    return F0 + rho.value / (1.0 - rho.value * tau) * F1;  // [Mayaux18 eq. 10]
}

/// E(alpha, rho) [Mayaux18 eq. 12], guarded or not.
template <class T>
T Evaluate(const MayauxConstants<T>& constants, PoleGuard guard, UniformVisibility alpha,
           Albedo rho) {
    using std::max;
    using std::min;
    const T zero(0.0), one(1.0), least(1e-5);
    if (guard == PoleGuard::kPort || guard == PoleGuard::kPortHalfAlbedo)
        alpha = UniformVisibility(std::min(alpha.value, 0.999));
    if (guard == PoleGuard::kPortHalfAlbedo) rho = Albedo(std::min(rho.value, 0.5));

    const T F0 = Evaluate(constants.F0, alpha);
    const T F1 = Evaluate(constants.F1, alpha);
    switch (guard) {
        case PoleGuard::kNone:
            break;
        case PoleGuard::kDemo: {
            const T tau = one - F1 / (0.01 + min(max(one - F0, zero), one));
            return F0 + rho.value * F1 / (one - min(max(rho.value * tau, zero), one));
        }
        case PoleGuard::kPort:
        case PoleGuard::kPortHalfAlbedo: {
            const T tau = one - F1 / max(one - F0, least);
            return F0 + rho.value * F1 / max(one - rho.value * tau, least);
        }
    }
    return GeometricTotal(F0, F1, BounceRatio(F0, F1), rho);
}

/// [Mayaux18 eq. 12] under PoleGuard::kPort, for shaders. With D = 1 - F0, the fraction is widened
/// by D: F1 / (1 - rho tau) = F1 D / ((1 - rho) D + rho F1), which does not subtract nearly equal
/// floats. The last max is the guard 1 - rho tau >= 1e-5.
inline constexpr std::string_view kMayauxPortShader = R"(
    float alpha = min(PlumbUnit(uniform_visibility), 0.999f);
    {T} rho = PlumbUnit(albedo);
    float F0 = alpha * (1.0f + {a} * pow(1.0f - alpha, {p}));
    float F1 = {A} * alpha * pow(1.0f - alpha, 1.5f) * exp(-{B} * sqrt(sqrt(alpha)));
    float D = max(1.0f - F0, 1e-5f);
    return PlumbUnit(F0 + rho * F1 * D / max((1.0f - rho) * D + rho * F1, 1e-5f * D));
)";

/// The total with its four constants as parameters, for one guard.
template <PoleGuard kGuard>
struct MayauxTotalModel {
    static constexpr std::string_view kName =
        kGuard == PoleGuard::kNone   ? "Mayaux18"
        : kGuard == PoleGuard::kDemo ? "Mayaux18, guard 0.01"
        : kGuard == PoleGuard::kPort ? "Mayaux18, guard 1e-5"
                                     : "Mayaux18, guard 1e-5, rho <= 0.5";
    static constexpr std::array<Parameter, 4> kParameters{{
        DirectFactorModel::kParameters[0],
        DirectFactorModel::kParameters[1],
        FirstBounceModel::kParameters[0],
        FirstBounceModel::kParameters[1],
    }};
    static constexpr std::string_view kShader =
        kGuard == PoleGuard::kPort ? kMayauxPortShader : "";

    template <class T>
    static T Evaluate(const T* p, UniformVisibility alpha, Albedo rho) {
        return plumb::Evaluate(MayauxConstants<T>{{p[0], p[1]}, {p[2], p[3]}}, kGuard, alpha,
                               rho);
    }
};

}  // namespace plumb
