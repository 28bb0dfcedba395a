// The direction numbers of Sobol's sequence: 64 dimensions, as columns of generator matrices.
//
//       m_k = 2 a_1 m_{k-1} ^ 4 a_2 m_{k-2} ^ ... ^ 2^s m_{k-s} ^ m_{k-s},      k > s
//
// for a primitive polynomial x^s + a_1 x^{s-1} + ... + a_{s-1} x + 1 and the first s numbers of
// a table. Column k of the matrix holds the k binary digits of m_k.
//
// Source   [Joe08] S. Joe, F. Kuo, Constructing Sobol Sequences with Better Two-Dimensional
//          Projections, SIAM J. Sci. Comput. 30, 2008; their file new-joe-kuo-6.21201, rows 2 to
//          64, whose terms follow.
//
// Licence pertaining to the accompanying sets of direction numbers
//
// Copyright (c) 2008, Frances Y. Kuo and Stephen Joe. All rights reserved.
//
// Redistribution and use in source and binary forms, with or without modification, are
// permitted provided that the following conditions are met:
//
//   * Redistributions of source code must retain the above copyright notice, this list of
//     conditions and the following disclaimer.
//   * Redistributions in binary form must reproduce the above copyright notice, this list of
//     conditions and the following disclaimer in the documentation and/or other materials
//     provided with the distribution.
//   * Neither the names of the copyright holders nor the names of the University of New South
//     Wales and the University of Waikato and its contributors may be used to endorse or
//     promote products derived from this software without specific prior written permission.
//
// THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS ``AS IS'' AND ANY EXPRESS OR IMPLIED
// WARRANTIES, INCLUDING, BUT NOT LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND
// FITNESS FOR A PARTICULAR PURPOSE ARE DISCLAIMED. IN NO EVENT SHALL THE COPYRIGHT HOLDERS BE
// LIABLE FOR ANY DIRECT, INDIRECT, INCIDENTAL, SPECIAL, EXEMPLARY, OR CONSEQUENTIAL DAMAGES
// (INCLUDING, BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR SERVICES; LOSS OF USE,
// DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER CAUSED AND ON ANY THEORY OF LIABILITY,
// WHETHER IN CONTRACT, STRICT LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN
// ANY WAY OUT OF THE USE OF THIS SOFTWARE, EVEN IF ADVISED OF THE POSSIBILITY OF SUCH DAMAGE.
#pragma once

#include <array>
#include <cstdint>

namespace plumb {

inline constexpr std::uint32_t kSobolDimensions = 64;

/// A primitive polynomial over GF(2) and the numbers that start its recurrence.
struct SobolRow {
    int s;                           ///< Degree.
    std::uint32_t a;                 ///< a_1 ... a_{s-1} as binary digits, a_1 the greatest.
    std::array<std::uint32_t, 9> m;  ///< m_1 ... m_s, each odd and below 2^k.
};

/// Dimensions 1 to 63; dimension 0 is the reversal of the index's bits.
// clang-format off
inline constexpr std::array<SobolRow, kSobolDimensions - 1> kSobolRows{{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
    {7, 4, {1, 3, 7, 13, 13, 15, 69}},
    {7, 7, {1, 1, 3, 13, 7, 35, 63}},
    {7, 8, {1, 3, 5, 9, 1, 25, 53}},
    {7, 14, {1, 3, 1, 13, 9, 35, 107}},
    {7, 19, {1, 3, 1, 5, 27, 61, 31}},
    {7, 21, {1, 1, 5, 11, 19, 41, 61}},
    {7, 28, {1, 3, 5, 3, 3, 13, 69}},
    {7, 31, {1, 1, 7, 13, 1, 19, 1}},
    {7, 32, {1, 3, 7, 5, 13, 19, 59}},
    {7, 37, {1, 1, 3, 9, 25, 29, 41}},
    {7, 41, {1, 3, 5, 13, 23, 1, 55}},
    {7, 42, {1, 3, 7, 3, 13, 59, 17}},
    {7, 50, {1, 3, 1, 3, 5, 53, 69}},
    {7, 55, {1, 1, 5, 5, 23, 33, 13}},
    {7, 56, {1, 1, 7, 7, 1, 61, 123}},
    {7, 59, {1, 1, 7, 9, 13, 61, 49}},
    {7, 62, {1, 3, 3, 5, 3, 55, 33}},
    {8, 14, {1, 3, 1, 15, 31, 13, 49, 245}},
    {8, 21, {1, 3, 5, 15, 31, 59, 63, 97}},
    {8, 22, {1, 3, 1, 11, 11, 11, 77, 249}},
    {8, 38, {1, 3, 1, 11, 27, 43, 71, 9}},
    {8, 47, {1, 1, 7, 15, 21, 11, 81, 45}},
    {8, 49, {1, 3, 7, 3, 25, 31, 65, 79}},
    {8, 50, {1, 3, 1, 1, 19, 11, 3, 205}},
    {8, 52, {1, 1, 5, 9, 19, 21, 29, 157}},
    {8, 56, {1, 3, 7, 11, 1, 33, 89, 185}},
    {8, 67, {1, 3, 3, 3, 15, 9, 79, 71}},
    {8, 70, {1, 3, 7, 11, 15, 39, 119, 27}},
    {8, 84, {1, 1, 3, 1, 11, 31, 97, 225}},
    {8, 97, {1, 1, 1, 3, 23, 43, 57, 177}},
    {8, 103, {1, 3, 7, 7, 17, 17, 37, 71}},
    {8, 115, {1, 3, 1, 5, 27, 63, 123, 213}},
    {8, 122, {1, 1, 3, 5, 11, 43, 53, 133}},
    {9, 8, {1, 3, 5, 5, 29, 17, 47, 173, 479}},
    {9, 13, {1, 3, 3, 11, 3, 1, 109, 9, 69}},
    {9, 16, {1, 1, 1, 5, 17, 39, 23, 5, 343}},
    {9, 22, {1, 3, 1, 5, 25, 15, 31, 103, 499}},
    {9, 25, {1, 1, 1, 11, 11, 17, 63, 105, 183}},
    {9, 44, {1, 1, 5, 11, 9, 29, 97, 231, 363}},
    {9, 47, {1, 1, 5, 15, 19, 45, 41, 7, 383}},
    {9, 52, {1, 3, 7, 7, 31, 19, 83, 137, 221}},
    {9, 55, {1, 1, 1, 3, 23, 15, 111, 223, 83}},
    {9, 59, {1, 1, 5, 13, 31, 15, 55, 25, 161}},
    {9, 62, {1, 1, 3, 13, 25, 47, 39, 87, 257}},
}};
// clang-format on

/// Columns 1 to 32 of a dimension's matrix, the first digit in the least bit.
constexpr std::array<std::uint32_t, 32> SobolColumns(const SobolRow& row) {
    std::array<std::uint32_t, 32> m{};
    for (int k = 0; k < 32; ++k) {
        if (k < row.s) {
            m[k] = row.m[k];
            continue;
        }
        m[k] = (m[k - row.s] << row.s) ^ m[k - row.s];
        for (int j = 1; j < row.s; ++j) {
            if ((row.a >> (row.s - 1 - j)) & 1) m[k] ^= m[k - j] << j;
        }
    }
    std::array<std::uint32_t, 32> columns{};
    for (int c = 0; c < 32; ++c) {
        for (int digit = 0; digit <= c; ++digit) {
            columns[c] |= ((m[c] >> (c - digit)) & 1) << digit;
        }
    }
    return columns;
}

/// A dimension's matrix times an index, four bits of the index at a time: entry [k][b] is the
/// product with b 16^k.
using SobolMatrix = std::array<std::array<std::uint32_t, 16>, 8>;

constexpr SobolMatrix MakeSobolMatrix(const std::array<std::uint32_t, 32>& columns) {
    SobolMatrix matrix{};
    for (int k = 0; k < 8; ++k) {
        for (int bits = 0; bits < 16; ++bits) {
            for (int j = 0; j < 4; ++j) {
                if ((bits >> j) & 1) matrix[k][bits] ^= columns[4 * k + j];
            }
        }
    }
    return matrix;
}

inline constexpr std::array<SobolMatrix, kSobolDimensions> kSobolMatrices = [] {
    std::array<SobolMatrix, kSobolDimensions> all{};
    std::array<std::uint32_t, 32> identity{};
    for (int c = 0; c < 32; ++c) identity[c] = std::uint32_t{1} << c;
    all[0] = MakeSobolMatrix(identity);
    for (std::uint32_t d = 1; d < kSobolDimensions; ++d) {
        all[d] = MakeSobolMatrix(SobolColumns(kSobolRows[d - 1]));
    }
    return all;
}();

}  // namespace plumb
