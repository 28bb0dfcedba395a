// A and z in three bytes, for the filters to read: as shipped, with what that loses.
//
//       k = clamp(z / z_min, 0, 1)
//       (R, G, B) = (A, floor(256 k) / 256, fract(256 k))           each stored as round(255 x)
//       A = R / 255,    k = 256/257 G / 255 + 1/257 B / 255
//
// Source   [McGuire12] end of section 2.3; the unpacking: the blur shader of its supplement.
// Symbols  A obscurance, z depth (m, < 0), z_min the farthest depth at which features stay sharp
//          (m, < 0), k the key that the filters compare.
// Beware   Two defects, kept: at k = 129/256 the stored key falls from 0.50390 to 0.50001, so that
//          a filter sees an edge there (z = -100.8 m of -200 m); and k = 1, the sky, comes back as
//          0.9961, so that the test "k = 1 is sky" of the shaders never holds.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace plumb {

struct PackedAoZ {
    std::uint8_t A = 0, key_high = 0, key_low = 0;
    friend bool operator==(const PackedAoZ&, const PackedAoZ&) = default;
};

/// k. The sky's z = -inf has 1.
inline double DepthKey(double z_m, double z_min_m) {
    return std::clamp(z_m / z_min_m, 0.0, 1.0);
}

/// What a texture of 8 bits keeps of x in [0, 1].
template <class Real>
constexpr int ToByte(Real x) {
    return int(Real(255) * x + Real(0.5));
}

/// floor(256 k), of a k that is not negative; and fract(256 k).
template <class Real>
constexpr int HighOfKey(Real key) {
    return int(Real(256) * key);
}
template <class Real>
constexpr Real LowOfKey(Real key, int high) {
    return Real(256) * key - Real(high);
}

template <class Real>
constexpr Real KeyOfBytes(int high, int low) {
    return Real(high) / Real(255) * Real(256.0 / 257) + Real(low) / Real(255) * Real(1.0 / 257);
}

template <class Real>
constexpr PackedAoZ PackAoZ(Real A, Real key) {
    const int high = HighOfKey(key);
    return {std::uint8_t(ToByte(A)), std::uint8_t(ToByte(Real(high) / Real(256))),
            std::uint8_t(ToByte(LowOfKey(key, high)))};
}

template <class Real>
constexpr Real UnpackA(const PackedAoZ& packed) {
    return Real(packed.A) / Real(255);
}

template <class Real>
constexpr Real UnpackKey(const PackedAoZ& packed) {
    return KeyOfBytes<Real>(packed.key_high, packed.key_low);
}

}  // namespace plumb
