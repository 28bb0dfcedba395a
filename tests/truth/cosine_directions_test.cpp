#include "truth/cosine_directions.h"

#include <gtest/gtest.h>

#include "core/sobol.h"
#include "truth/replicates.h"

namespace plumb {
namespace {

// Definition: the directions of core/warp.h at the points of core/sobol.h. Tolerance: 4e-7, of
// digits cut to 24 bits (2^-24 of u, times the map's slope of up to pi), series (2.5e-8) and
// seven roundings to float; near the rim z grows as the root of the distance to it, so there its
// square is compared.
TEST(CosineDirections, AreThoseInDouble) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const Basis frame(Vec3(0.3, -0.5, 0.7 * double(seed)).normalized());
        PairDigits digits;
        for (std::uint32_t index = 0; index < 20000; ++index) {
            digits.first.push_back(SobolReversed(index, 0));
            digits.second.push_back(SobolReversed(index, 1));
        }
        std::vector<Vec3f> directions(digits.first.size());
        CosineDirections(digits, seed, kFirstDirection, frame, directions);
        for (std::uint32_t index = 0; index < 20000; ++index) {
            const Vec3 expected =
                SampleCosineHemisphere(SobolOwenPair(index, kFirstDirection, seed));
            const Vec3 w = frame.ToLocal(directions[index].cast<double>());
            ASSERT_NEAR(w.x(), expected.x(), 4e-7) << index;
            ASSERT_NEAR(w.y(), expected.y(), 4e-7) << index;
            ASSERT_NEAR(w.z() * w.z(), expected.z() * expected.z(), 8e-7) << index;
            ASSERT_GT(w.z(), -1e-7) << index;
        }
    }
}

// The middle of the square and its corners: no 0 / 0, no root of a negative number.
TEST(CosineDirections, AreFiniteEverywhere) {
    const Basis frame(Vec3(0, 0, 1));
    PairDigits digits;
    for (std::uint32_t k = 0; k < 65536; ++k) {
        digits.first.push_back(k * 0x9e3779b9u);
        digits.second.push_back(k * 0x85ebca6bu);
    }
    std::vector<Vec3f> directions(digits.first.size());
    CosineDirections(digits, 9, 0, frame, directions);
    for (const Vec3f& w : directions) {
        ASSERT_TRUE(w.allFinite());
        ASSERT_NEAR(w.norm(), 1, 1e-6);
    }
}

}  // namespace
}  // namespace plumb
