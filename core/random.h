// Random numbers by counter: a pure function of who asks, never of who asked before.
//
//       RandomBits(seed, pixel, sample, dimension)  ->  64 bits
//
// Each word is absorbed by a bijection of 64 bits, so two calls that differ in one word only
// never collide, and no state is shared between threads.
//
// Source   the mixer: [Steele14] G. Steele, D. Lea, C. Flood, Fast Splittable Pseudorandom
//          Number Generators, OOPSLA 2014 (SplitMix64, with D. Stafford's "variant 13").
// Beware   Independent samples: for an integral take core/sobol.h, which needs far fewer.
#pragma once

#include <cstdint>

namespace plumb {

/// A bijection of 64 bits in which every output bit depends on every input bit.
constexpr std::uint64_t MixBits(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// `key` with one more word absorbed. The odd constant is 2^64 / golden ratio: it moves small
/// words apart, and the offset keeps 0 from being a fixed point.
constexpr std::uint64_t Absorb(std::uint64_t key, std::uint64_t word) {
    return MixBits(key + (word + 1) * 0x9e3779b97f4a7c15u);
}

constexpr std::uint64_t RandomBits(std::uint64_t seed, std::uint64_t pixel,
                                   std::uint64_t sample, std::uint64_t dimension) {
    return Absorb(Absorb(Absorb(Absorb(0, seed), pixel), sample), dimension);
}

/// The leading 53 bits as a number in [0, 1): every multiple of 2^-53 is equally likely.
constexpr double UnitFromBits(std::uint64_t bits) {
    return double(bits >> 11) * 0x1p-53;
}

/// Uniform in [0, 1).
constexpr double RandomUnit(std::uint64_t seed, std::uint64_t pixel, std::uint64_t sample,
                            std::uint64_t dimension) {
    return UnitFromBits(RandomBits(seed, pixel, sample, dimension));
}

}  // namespace plumb
