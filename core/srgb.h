// The curve by which pictures of integers are encoded.
//
//       encoded = 12.92 x                          x <= 0.0031308
//                 1.055 x^(1/2.4) - 0.055          above
//
// Source   [IEC61966] IEC 61966-2-1, sRGB.
// Symbols  x linear light.
// Domain   [0, 1]; a clamp is the caller's.
#pragma once

#include <cmath>

namespace plumb {

inline double EncodeSrgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

inline double DecodeSrgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace plumb
