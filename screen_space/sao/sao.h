// Scalable Ambient Obscurance (SAO): what one tap adds, and what a pixel's taps make.
//
//       eq. 1    A = max(0, 1 - 2 sigma / s  Sum f)^k,     f = max(0, v.n + z_C beta) / (v.v + eps)
//       A to D   A = max(0, 1 - 5 sigma / (s r^6)  Sum f)
//           A    f = 0.6 r^2 [v.v < r^2] max(0, v.n - beta) / (v.v + eps)
//           B    f = max(0, r^2 - v.v)^3 max(0, v.n - beta) / (v.v + eps)
//           C    f = 4 max(0, 1 - v.v / r^2) max(0, v.n - beta)
//           D    f = 2 [v.v < r^2] max(0, v.n - beta)
//       high     A = max(0, 1 - sqrt(3 / s  Sum f))^sigma
//       quality  f = max(0, 1 - v.v / r^2) max(0, v.n - beta) / sqrt(v.v + eps)
//                    (0.65 + 0.35 max(0, 1.5 n_z))
//
// Source   [McGuire12 eq. 1]; B: the appendix of [McGuire12]; A, C, D: the shader of its
//          supplement; high quality: the shader of G3D 10.
// Symbols  C, n position (m) and unit normal of the pixel in the camera's frame, Q_i what tap i
//          met (m), v_i = Q_i - C, r radius (m), beta bias, sigma intensity, eps (m^2), k
//          exponent, s number of taps, z_C depth of C (m, < 0), n_z the normal's part to the eye.
// Beware   Sigma has a unit: m in eq. 1 and in B, m^5 in A, C and D, none in high quality. As
//          shipped, every f of A to D is divided by r^6, so that A, C and D change with r as
//          r^-4 or r^-6 where B keeps its size. IntensityPower says which; InOtherUnit applies it.
//          Eq. 1's beta has no unit, being multiplied by z_C; the appendix's is a length. Both
//          stand in SaoParams, and their biases add. Eq. 1 has no limit of reach but the disc.
#pragma once

#include <span>

#include "core/vec.h"

namespace plumb {

enum class SaoFalloffKind {
    kEquation1,    ///< The paper's own.
    kHpg12,        ///< A of the shader.
    kSmooth,       ///< B: the appendix, recommended.
    kNoDivision,   ///< C
    kLowContrast,  ///< D
    kHighQuality,  ///< Of G3D 10.
};

/// Everything that SAO lets an artist or a fit change. Defaults: the supplement of 2012.
struct SaoParams {
    SaoFalloffKind falloff = SaoFalloffKind::kSmooth;
    double radius_m = 1;   ///< r, reach in the world. [1e-4, 1e7]
    double bias_m = 0.01;  ///< beta of A to D, hides the self-occlusion of corners. [0, 1e7]
    double bias_per_depth = 0;  ///< beta of eq. 1, times the depth -z_C. [0, 1e3]
    double intensity = 1;       ///< sigma, in m^IntensityPower(falloff). [0, 1e30]
    double epsilon_m2 = 0.01;   ///< eps, keeps f finite at Q = C. [1e-12, 1e12]
    double exponent = 1;        ///< k, contrast of eq. 1. [0, 100]
    bool lift_dark = false;     ///< A to D: A becomes (A^0.2 + 1.2 A^4) / 2.2, as in G3D 10.

    friend bool operator==(const SaoParams&, const SaoParams&) = default;
};

/// Throws Error, naming the first field that breaks its range above.
void Validate(const SaoParams& params);

/// The power of a length that sigma carries: 1, 5 or 0.
int IntensityPower(SaoFalloffKind falloff);

/// The parameters that give the same A once each length of the scene is `scale` times as great.
SaoParams InOtherUnit(const SaoParams& params, double scale);

/// f(v) of one tap, as above. [m^-1 in eq. 1, m^5 in B, m in A, C, D, none in high quality]
double SaoFalloff(const Vec3& v_m, const Vec3& n, double z_C_m, const SaoParams& params);

/// A from the mean of f over the taps, 1/s Sum f. In [0, 1].
double SaoFromMean(double mean_f, const SaoParams& params);

/// A of a pixel from its taps v_i = Q_i - C in metres. In [0, 1].
double SaoVisibility(std::span<const Vec3> taps_m, const Vec3& n, double z_C_m,
                     const SaoParams& params);

}  // namespace plumb
