// Owen-scrambled Sobol points: samples that fill the square evenly at every power of two.
//
// Dimensions come in pairs (0, 1), (2, 3), ... Each pair is Sobol's first two dimensions, a
// (0, 2)-sequence in base 2: every aligned block of 2^k points has exactly one point in each of
// the 2^k equal boxes 2^-a x 2^-(k-a). Pairs are padded: each visits its points in an order of
// its own, a nested uniform (Owen) scramble of the index, so that different pairs are
// independent at random while a pair keeps its property. Each coordinate is Owen-scrambled with
// a seed of its own: every point is uniform, so a mean over any 2^k points is unbiased, and
// different seeds are independent replicates whose scatter gives the error.
//
// Source   [Sobol67] I. Sobol', On the Distribution of Points in a Cube, 1967; [Owen95]
//          A. Owen, Randomly Permuted (t, m, s)-Nets and (t, s)-Sequences, 1995; scrambling by
//          a hash, padding by shuffled indices: [Burley20] B. Burley, Practical Hash-Based Owen
//          Scrambling, JCGT 9(4), 2020, after [Laine11] S. Laine, T. Karras.
// Domain   index < 2^32, any dimension. A coordinate has 32 bits and is in [0, 1).
// Beware   Take whole blocks of 2^k points: the first 100 of 128 are no net. Across pairs there
//          is no stratification: an integral that couples many pairs converges like a random
//          one in that part.
#pragma once

#include <cstdint>

#include "core/random.h"
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

/// Sobol's second dimension, bits reversed. Its generator is Pascal's triangle mod 2; binomial
/// (i, j) is odd exactly if the bits of j are among those of i (Lucas), so the product is five
/// steps of a sum over supersets of bit numbers.
constexpr std::uint32_t SobolSecondReversed(std::uint32_t index) {
    index ^= (index >> 1) & 0x55555555u;
    index ^= (index >> 2) & 0x33333333u;
    index ^= (index >> 4) & 0x0f0f0f0fu;
    index ^= (index >> 8) & 0x00ff00ffu;
    return index ^ ((index >> 16) & 0x0000ffffu);
}

/// The 32 binary digits of one coordinate of point `index`.
constexpr std::uint32_t SobolOwenBits(std::uint32_t index, std::uint32_t dimension,
                                      std::uint64_t seed) {
    const std::uint64_t pair = Absorb(Absorb(0, seed), dimension / 2);
    const std::uint32_t shuffled = OwenScramble(index, pair);
    const bool second = dimension % 2 == 1;
    const std::uint32_t reversed = second ? SobolSecondReversed(shuffled) : shuffled;
    return ReverseBits(NestedHash(reversed, Absorb(pair, second)));
}

/// One coordinate of point `index`, in [0, 1).
constexpr double SobolOwen(std::uint32_t index, std::uint32_t dimension, std::uint64_t seed) {
    return SobolOwenBits(index, dimension, seed) * 0x1p-32;
}

/// Dimensions 2 pair and 2 pair + 1 of point `index`, which share most of the work.
inline Vec2 SobolOwenPair(std::uint32_t index, std::uint32_t pair, std::uint64_t seed) {
    const std::uint64_t key = Absorb(Absorb(0, seed), pair);
    const std::uint32_t shuffled = OwenScramble(index, key);
    return {ReverseBits(NestedHash(shuffled, Absorb(key, 0))) * 0x1p-32,
            ReverseBits(NestedHash(SobolSecondReversed(shuffled), Absorb(key, 1))) * 0x1p-32};
}

}  // namespace plumb
