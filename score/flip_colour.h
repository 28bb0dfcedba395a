// Colours as FLIP sees them: opponent coordinates to filter in, CIELAB to take differences in.
//
//       XYZ   = M RGB                                linear sRGB, white (1, 1, 1) is D65
//       YCxCz   Y = 116 y - 16,  Cx = 500 (x - y),  Cz = 200 (y - z)      x = X / X_white ...
//       CIELAB  the same of f(x), f(y), f(z);  f(t) = t^(1/3), straight below (6/29)^3
//       Hunt    a, b times 0.01 L:  dark colours are less colourful
//       HyAB    |dL| + sqrt(da^2 + db^2)
//
//       d = HyAB^0.7,   c = 0.4 d_max,   d_max that of green against blue
//       E = 0.95 d / c                                 below c
//           0.95 + 0.05 (d - c) / (d_max - c)          above
//
// Source   [Andersson20] section 4.1.
// Symbols  d colour difference; E in [0, 1].
// Domain   RGB in [0, 1].
// Beware   The matrix is the one of sRGB's primaries in exact fractions, that of the published
//          program; with the four rounded digits of most tables E moves by 1e-4.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace plumb {

using Triple = std::array<double, 3>;

inline constexpr std::array<Triple, 3> kXyzOfRgb{
    {{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
     {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
     {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}};

/// The inverse of kXyzOfRgb, to ten digits.
inline constexpr std::array<Triple, 3> kRgbOfXyz{{{3.241003275, -1.537398934, -0.498615861},
                                                  {-0.969224334, 1.875930071, 0.041554224},
                                                  {0.055639423, -0.204011202, 1.057148933}}};

inline constexpr Triple kWhiteXyz{0.950428545, 1, 1.088900371};

inline Triple Times(const std::array<Triple, 3>& m, const Triple& v) {
    return {m[0][0] * v[0] + m[0][1] * v[1] + m[0][2] * v[2],
            m[1][0] * v[0] + m[1][1] * v[1] + m[1][2] * v[2],
            m[2][0] * v[0] + m[2][1] * v[1] + m[2][2] * v[2]};
}

/// X, Y, Z over those of white.
inline Triple OverWhite(const Triple& rgb) {
    const Triple xyz = Times(kXyzOfRgb, rgb);
    return {xyz[0] / kWhiteXyz[0], xyz[1] / kWhiteXyz[1], xyz[2] / kWhiteXyz[2]};
}

/// The coordinates of YCxCz or CIELAB, of the three numbers that each is made of.
inline Triple Opponent(const Triple& xyz) {
    return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

inline Triple YCxCzOfRgb(const Triple& rgb) {
    return Opponent(OverWhite(rgb));
}

inline Triple RgbOfYCxCz(const Triple& ycc) {
    const double y = (ycc[0] + 16) / 116;
    return Times(kRgbOfXyz, {(y + ycc[1] / 500) * kWhiteXyz[0], y * kWhiteXyz[1],
                             (y - ycc[2] / 200) * kWhiteXyz[2]});
}

/// x^(1/3) to 1e-13 of it, for x in [1e-3, 10]; a third of the time of std::cbrt. The exponent divided
/// by three begins within e = 4 %; each of two steps of Halley leaves 2/3 e^3.
inline double CubeRoot(double x) {
    constexpr std::uint64_t kBias = std::uint64_t{715094163}
                                    << 32;  // 2/3 of the exponent of 1.
    double y = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) / 3 + kBias);
    for (int step = 0; step < 2; ++step) {
        const double y3 = y * y * y;
        y *= (y3 + 2 * x) / (2 * y3 + x);
    }
    return y;
}

/// CIELAB with a and b scaled for the Hunt effect.
inline Triple HuntLabOfRgb(const Triple& rgb) {
    constexpr double kDelta = 6.0 / 29;
    Triple f = OverWhite(rgb);
    for (double& t : f) {
        t = t > kDelta * kDelta * kDelta ? CubeRoot(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
    }
    const Triple lab = Opponent(f);
    return {lab[0], 0.01 * lab[0] * lab[1], 0.01 * lab[0] * lab[2]};
}

inline double HyAb(const Triple& p, const Triple& q) {
    const double da = p[1] - q[1], db = p[2] - q[2];
    return std::abs(p[0] - q[0]) + std::sqrt(da * da + db * db);
}

inline constexpr double kFlipColourPower = 0.7;  ///< q_c

/// d_max = 41.276096.
inline double GreatestColourDifference() {
    return std::pow(HyAb(HuntLabOfRgb({0, 1, 0}), HuntLabOfRgb({0, 0, 1})), kFlipColourPower);
}

/// E of two colours in HuntLab; `d_max` = GreatestColourDifference().
inline double ColourError(const Triple& p, const Triple& q, double d_max) {
    constexpr double kShareOfMax = 0.4, kErrorThere = 0.95;  // p_c, p_t
    const double c = kShareOfMax * d_max, d = std::pow(HyAb(p, q), kFlipColourPower);
    if (d < c) return kErrorThere * d / c;
    return kErrorThere + (1 - kErrorThere) * (d - c) / (d_max - c);
}

}  // namespace plumb
