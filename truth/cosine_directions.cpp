#include "truth/cosine_directions.h"

#include <algorithm>
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

void CosineDirections(std::span<const std::array<std::uint32_t, 2>> digits, std::uint64_t net,
                      std::uint32_t pair, const Basis& frame, std::span<Vec3f> out) {
    assert(out.size() >= digits.size());
    const std::uint64_t key_0 = SobolOwenKey(2 * pair, net);
    const std::uint64_t key_1 = SobolOwenKey(2 * pair + 1, net);
    std::array<float, kBlock> x, y, z;
    const Vec3f s_axis = frame.s.cast<float>(), t_axis = frame.t.cast<float>(),
                n_axis = frame.n.cast<float>();
    for (std::size_t begin = 0; begin < digits.size(); begin += kBlock) {
        const std::size_t count = std::min(kBlock, digits.size() - begin);
        for (std::size_t k = 0; k < count; ++k) {
            const auto& [d_0, d_1] = digits[begin + k];
            x[k] = Centred(ReverseBits(NestedHash(d_0, key_0)));
            y[k] = Centred(ReverseBits(NestedHash(d_1, key_1)));
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
