#include "truth/cosine_directions.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "core/conventions.h"
#include "core/sobol.h"

namespace plumb {
namespace {

constexpr std::size_t kBlock = 64;

// 2 u - 1 from the leading 24 of 32 digits.
float Centred(std::uint32_t digits) {
    const std::int32_t leading = std::int32_t(digits >> 8) - (1 << 23);
    return (float(leading) + 0.5f) * 0x1p-23f;
}

}  // namespace

void CosineDirections(const PairDigits& digits, std::uint64_t net, std::uint32_t pair,
                      const Basis& frame, std::span<Vec3f> out) {
    const std::size_t points = digits.first.size();
    assert(digits.second.size() == points && out.size() >= points);
    const std::uint64_t key_0 = SobolOwenKey(2 * pair, net);
    const std::uint64_t key_1 = SobolOwenKey(2 * pair + 1, net);
    const std::uint32_t* const first = digits.first.data();
    const std::uint32_t* const second = digits.second.data();
    std::array<float, kBlock> x, y, z;
    const Vec3f s_axis = frame.s.cast<float>(), t_axis = frame.t.cast<float>(),
                n_axis = frame.n.cast<float>();
    for (std::size_t begin = 0; begin < points; begin += kBlock) {
        const std::size_t count = std::min(kBlock, points - begin);
        for (std::size_t k = 0; k < count; ++k) {
            x[k] = Centred(ReverseBits(NestedHash(first[begin + k], key_0)));
            y[k] = Centred(ReverseBits(NestedHash(second[begin + k], key_1)));
        }
        for (std::size_t k = 0; k < count; ++k) {
            // [Shirley97] as in core/warp.cpp: the larger coordinate is the (signed) radius.
            const float a = x[k], b = y[k];
            const bool wide = std::abs(a) > std::abs(b);
            const float r = wide ? a : b;
            const float t = float(kPi / 4) * ((wide ? b : a) / (r == 0 ? 1 : r));
            const float q = t * t;
            const float sine =
                t * (1 + q * (-1.0f / 6 +
                              q * (1.0f / 120 + q * (-1.0f / 5040 + q * (1.0f / 362880)))));
            const float cosine =
                1 + q * (-1.0f / 2 + q * (1.0f / 24 + q * (-1.0f / 720 + q * (1.0f / 40320))));
            x[k] = r * (wide ? cosine : sine);
            y[k] = r * (wide ? sine : cosine);
            z[k] = std::sqrt((1 - r) * (1 + r));
        }
        for (std::size_t k = 0; k < count; ++k) {
            out[begin + k] = x[k] * s_axis + y[k] * t_axis + z[k] * n_axis;
        }
    }
}

}  // namespace plumb
