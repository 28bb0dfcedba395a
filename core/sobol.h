// Owen-scrambled Sobol points: samples that fill a cube evenly at every power of two.
//
// Every aligned block of 2^k points has exactly one point in each of the 2^k equal intervals of
// every dimension, and in each of the 2^k equal boxes 2^-a x 2^-(k-a) of dimensions (0, 1); of
// other dimensions together in coarser boxes, so that an integral over the first few bounces of
// a walk gains too. Each coordinate is Owen-scrambled with a seed of its own, which keeps all
// that: every point is uniform, so a mean over any block is unbiased, and different seeds are
// independent replicates whose scatter gives the error.
//
// Source   [Sobol67] I. Sobol', On the Distribution of Points in a Cube, 1967; direction
//          numbers: [Joe08] (core/sobol_directions.h); [Owen95] A. Owen, Randomly Permuted
//          (t, m, s)-Nets and (t, s)-Sequences, 1995; scrambling by a hash, padding by shuffled
//          indices: [Burley20] B. Burley, Practical Hash-Based Owen Scrambling, JCGT 9(4),
//          2020, after [Laine11] S. Laine, T. Karras.
// Domain   index < 2^32, any dimension. A coordinate has 32 bits and is in [0, 1).
// Beware   Take whole blocks of 2^k points: the first 100 of 128 are no net. The lower the
//          dimension the evener: give dimensions 0 and 1 to what matters most. Dimensions from
//          64 on are padding: the first 64 again in another order of the points, so that
//          between blocks of 64 there is only random evenness.
#pragma once

#include <cstdint>

#include "core/random.h"
#include "core/sobol_directions.h"
#include "core/vec.h"

namespace plumb {

constexpr std::uint32_t ReverseBits(std::uint32_t x) {
    x = ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
    x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
    x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
    return (x << 24) | ((x & 0xff00u) << 8) | ((x >> 8) & 0xff00u) | (x >> 24);
}

/// A permutation in which an output bit depends on the input bits up to its own place only,
/// counted from the least: read from the greatest after ReverseBits, that is an Owen scramble.
///
/// Each line is such a permutation: adding, multiplying by an odd number, and x ^= x * even.
/// Adding 32 seed bits makes the result uniform; multiplying by 31 others makes the flips of a
/// bit depend on the bits below it. The even constants were chosen at random and kept because
/// the flip rates of tests/core/sobol_test.cpp lie near 1/2.
constexpr std::uint32_t NestedHash(std::uint32_t x, std::uint64_t key) {
    x ^= x * 0x61855bacu;
    x += std::uint32_t(key);
    x ^= x * 0x6497de00u;
    x *= std::uint32_t(key >> 32) | 1u;
    x ^= x * 0x10e1344au;
    x ^= x * 0xaca0eb36u;
    return x;
}

/// Owen scramble of the 32 binary digits of a coordinate.
constexpr std::uint32_t OwenScramble(std::uint32_t digits, std::uint64_t key) {
    return ReverseBits(NestedHash(ReverseBits(digits), key));
}

/// The 32 binary digits of Sobol's point `index`, unscrambled, the first digit in the least bit.
constexpr std::uint32_t SobolReversed(std::uint32_t index, std::uint32_t dimension) {
    const SobolMatrix& matrix = kSobolMatrices[dimension];
    std::uint32_t digits = 0;
    for (int k = 0; index != 0; ++k, index >>= 4) digits ^= matrix[k][index & 15];
    return digits;
}

/// The 32 binary digits of one coordinate of point `index`, the first in the greatest bit.
constexpr std::uint32_t SobolOwenBits(std::uint32_t index, std::uint32_t dimension,
                                      std::uint64_t seed) {
    const std::uint64_t key = Absorb(0, seed);
    const std::uint32_t block = dimension / kSobolDimensions;
    if (block > 0) index = OwenScramble(index, Absorb(~key, block));
    const std::uint32_t digits = SobolReversed(index, dimension % kSobolDimensions);
    return ReverseBits(NestedHash(digits, Absorb(key, dimension)));
}

/// One coordinate of point `index`, in [0, 1).
constexpr double SobolOwen(std::uint32_t index, std::uint32_t dimension, std::uint64_t seed) {
    return SobolOwenBits(index, dimension, seed) * 0x1p-32;
}

/// Key of a dimension below kSobolDimensions: the digits of a point, which all nets share,
/// scrambled with it are that coordinate of the net `seed`.
constexpr std::uint64_t SobolOwenKey(std::uint32_t dimension, std::uint64_t seed) {
    return Absorb(Absorb(0, seed), dimension);
}
constexpr double ScrambleReversed(std::uint32_t digits_of_sobol_reversed, std::uint64_t key) {
    return ReverseBits(NestedHash(digits_of_sobol_reversed, key)) * 0x1p-32;
}

/// Dimensions 2 pair and 2 pair + 1 of point `index`.
inline Vec2 SobolOwenPair(std::uint32_t index, std::uint32_t pair, std::uint64_t seed) {
    return {SobolOwen(index, 2 * pair, seed), SobolOwen(index, 2 * pair + 1, seed)};
}

}  // namespace plumb
