// The angle by which a pixel's taps are turned: the XOR hash of AlchemyAO, in all its readings.
//
//       phi = 30 x ^ y + 10 x y                                     [McGuire12 eq. 8]
//
//       code           10 ((3x) ^ (y + x y))       the shader that was shipped
//       C precedence   (30x) ^ (y + 10 x y)        "+" before "^", as C has it
//       xor first      ((30x) ^ y) + 10 x y
//
// No reading has a unit; all of them use the number as radians.
//
// Source   [McGuire12 eq. 8]; the code: the shader of its supplement and of G3D 10.
// Symbols  (x, y) column and row of the pixel in the drawn picture, its border included.
// Beware   phi grows to 2e7 at 1080p. As a float32 it then has steps of 2 rad, and so has each
//          angle that it is added to: the spiral collapses onto few directions. That is what was
//          shipped (kFloat32). Reduced modulo 2 pi first (kReduced) the spiral keeps its
//          shape, turned by an angle that is off by up to 1 rad. kExact has neither fault.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/conventions.h"

namespace plumb {

enum class HashReading { kCode, kCPrecedence, kXorFirst };

enum class PhiArithmetic {
    kExact,    ///< phi modulo 2 pi in double, then the tap's angle in double.
    kReduced,  ///< phi modulo 2 pi in float32, before the tap's angle is added.
    kFloat32,  ///< phi in float32, the tap's angle added to it in float32.
};

/// The hash as an integer. Never negative; below 2^32 for x, y < 16384.
constexpr std::int64_t RotationHash(int x, int y, HashReading reading) {
    const std::int64_t X = x, Y = y;
    switch (reading) {  // [McGuire12 eq. 8]
        case HashReading::kCode:
            return 10 * ((3 * X) ^ (Y + X * Y));
        case HashReading::kCPrecedence:
            return (30 * X) ^ (Y + 10 * X * Y);
        case HashReading::kXorFirst:
            return ((30 * X) ^ Y) + 10 * X * Y;
    }
    return 0;
}

/// The angle of a tap at `spiral_rad` of its spiral, turned by the hash.
inline double TurnedAngle(double spiral_rad, std::int64_t hash, PhiArithmetic arithmetic) {
    switch (arithmetic) {
        case PhiArithmetic::kExact:
            return spiral_rad + std::fmod(double(hash), 2 * kPi);
        case PhiArithmetic::kReduced: {
            const float turn = float(2 * kPi), phi = float(hash);
            return spiral_rad + double(phi - turn * std::floor(phi / turn));
        }
        case PhiArithmetic::kFloat32:
            return double(float(spiral_rad) + float(hash));
    }
    return spiral_rad;
}

}  // namespace plumb
