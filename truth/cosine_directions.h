// Cosine-weighted directions of one net, many at once, in float.
//
//       w = frame (x, y, z),    (x, y) = disk(u) of core/warp.h,    z = sqrt(1 - x^2 - y^2)
//
// The same map as SampleCosineHemisphere, without a call to the C library: the angle within a
// wedge is at most pi/4, where Taylor's series to t^9 (sine) and t^8 (cosine) are good to 2.5e-8.
//
// Symbols  u coordinates of the net's points, cut to 24 bits (the middle of 2^-24 is taken).
// Beware   Within 4e-7 of the directions in double (tests/truth/cosine_directions_test.cpp): what
//          rounding a direction to float does, a few times over.
// Cost     about 6 ns a direction; the way by double takes 25.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"
#include "core/warp.h"

namespace plumb {

/// The digits of two coordinates of each point before scrambling (core/sobol.h): the same for
/// every net.
struct PairDigits {
    std::vector<std::uint32_t> first, second;
};

/// out[s] is the direction of point s of the net, about `frame`.
void CosineDirections(const PairDigits& digits, std::uint64_t net, std::uint32_t pair,
                      const Basis& frame, std::span<Vec3f> out);

}  // namespace plumb
