// Two numbers that share a name in print, a unit and a range, and are not the same.
//
//   uniform  alpha = 1/(2 pi) Int v(w) dw            the share of the hemisphere that is sky
//   cosine   V     = 1/pi     Int v(w) <n, w> dw     E / E_open: what diffuse light needs
//
// They are sure to agree only at 0 and 1; alpha^2 <= V <= alpha (2 - alpha). So they are types:
// neither converts into the other, and a formula made for one does not compile with the other.
//
// Source   [Mayaux18 eq. 4] calls alpha "AO"; V is E_0 / pi of [Mayaux18 eq. 5].
#pragma once

namespace plumb {

/// alpha: the open share of the hemisphere's solid angle. Unitless, in [0, 1].
struct UniformVisibility {
    double value = 1;
    explicit constexpr UniformVisibility(double alpha) : value(alpha) {}
    constexpr UniformVisibility() = default;
    friend bool operator==(const UniformVisibility&, const UniformVisibility&) = default;
};

/// V: the cosine-weighted open share of the hemisphere. Unitless, in [0, 1].
struct CosineVisibility {
    double value = 1;
    explicit constexpr CosineVisibility(double V) : value(V) {}
    constexpr CosineVisibility() = default;
    friend bool operator==(const CosineVisibility&, const CosineVisibility&) = default;
};

/// rho: diffuse albedo. Unitless, in [0, 1].
struct Albedo {
    double value = 0;
    explicit constexpr Albedo(double rho) : value(rho) {}
    constexpr Albedo() = default;
    friend bool operator==(const Albedo&, const Albedo&) = default;
};

/// The least V that a given alpha allows: the open cap lies along the horizon, V = alpha^2.
constexpr double LeastCosineVisibility(UniformVisibility alpha) {
    return alpha.value * alpha.value;
}

/// The greatest V that a given alpha allows: the open cap lies about the normal, V = alpha (2 -
/// alpha).
constexpr double GreatestCosineVisibility(UniformVisibility alpha) {
    return alpha.value * (2 - alpha.value);
}

}  // namespace plumb
