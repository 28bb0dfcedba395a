// The tables of SMAA against the published files (by checksum) and single values of the reference.
#include <gtest/gtest.h>

#include <cmath>

#include "screen_space/antialiasing/smaa_area.h"
#include "screen_space/antialiasing/smaa_search_table.h"

namespace plumb {
namespace {

/// CRC-32 as zip and PNG have it: reflected polynomial 0xedb88320.
std::uint32_t Crc32(const std::vector<std::uint8_t>& bytes) {
    std::uint32_t crc = ~0u;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    return ~crc;
}

TEST(Crc32, CheckValueOfItsDefinition) {
    EXPECT_EQ(Crc32({'1', '2', '3', '4', '5', '6', '7', '8', '9'}), 0xcbf43926u);
}

// Checksum and channel sums of the published table's block for one sample a pixel.
TEST(SmaaAreaTable, IsThePublishedOneByteForByte) {
    const std::vector<std::uint8_t>& table = SmaaAreaTable();
    std::uint64_t sums[2][2] = {};
    for (std::size_t i = 0; i < table.size(); ++i) {
        sums[i / 2 % kSmaaAreaWidth >= kSmaaAreaWidth / 2][i % 2] += table[i];
    }
    EXPECT_EQ(sums[0][0], 94434u);
    EXPECT_EQ(sums[0][1], 94434u);
    EXPECT_EQ(sums[1][0], 358890u);
    EXPECT_EQ(sums[1][1], 341637u);
    EXPECT_EQ(Crc32(table), 0x5fbca771u);
}

TEST(SmaaSearchTable, IsThePublishedOneByteForByte) {
    const std::vector<std::uint8_t> table = SmaaSearchTable();
    int once = 0, twice = 0;
    for (const std::uint8_t byte : table) {
        once += byte == 127;
        twice += byte == 254;
    }
    EXPECT_EQ(once, 140);
    EXPECT_EQ(twice, 20);
    EXPECT_EQ(Crc32(table), 0x77423453u);
}

struct Known {
    int pattern, left, right;
    double first, second;
};

// Values of the reference script, printed to six decimals: half of the last one, rounded either way.
TEST(OrthogonalArea, KnownValues) {
    for (const Known& k : {Known{1, 0, 0, .125, 0},
                           {1, 0, 1, .25, 0},
                           {3, 0, 0, .492188, 0},
                           {3, 1, 1, .269424, 0},
                           {6, 0, 0, .125, .125},
                           {6, 1, 1, .041667, .041667},
                           {6, 2, 3, 0, .083333},
                           {7, 0, 3, 0, .375},
                           {9, 3, 0, 0, .375},
                           {13, 4, 4, .013889, .013889},
                           {12, 9, 9, 0, .054413}}) {
        const SmaaShares shares = OrthogonalArea(k.pattern, k.left, k.right);
        EXPECT_NEAR(shares[0], k.first, 5.1e-7) << k.pattern << " " << k.left << " " << k.right;
        EXPECT_NEAR(shares[1], k.second, 5.1e-7)
            << k.pattern << " " << k.left << " " << k.right;
    }
}

TEST(DiagonalArea, KnownValues) {
    for (const Known& k : {Known{0, 0, 0, .254444, .241667},
                           {3, 0, 0, .507778, 0},
                           {12, 2, 2, .001111, .483333},
                           {6, 1, 3, .032222, .232222}}) {
        const SmaaShares shares = DiagonalArea(k.pattern, k.left, k.right);
        EXPECT_NEAR(shares[0], k.first, 5.1e-7) << k.pattern << " " << k.left << " " << k.right;
        EXPECT_NEAR(shares[1], k.second, 5.1e-7)
            << k.pattern << " " << k.left << " " << k.right;
    }
}

// The mirrored run has the same shares: bits 1 and 2, 4 and 8 exchanged, and the distances.
TEST(OrthogonalArea, MirrorsAndTurnsOver) {
    for (int pattern = 0; pattern < 16; ++pattern) {
        const int mirrored =
            (pattern & 1) << 1 | (pattern & 2) >> 1 | (pattern & 4) << 1 | (pattern & 8) >> 1;
        const int over = (pattern & 3) << 2 | pattern >> 2;
        for (int l = 0; l < 20; ++l) {
            for (int r = 0; r < 20; ++r) {
                const SmaaShares a = OrthogonalArea(pattern, l, r);
                // 7 and 13 (11 and 14) have three crossing edges: their line is their own choice.
                if (pattern != 7 && pattern != 11 && pattern != 13 && pattern != 14) {
                    const SmaaShares b = OrthogonalArea(over, l, r);
                    EXPECT_NEAR(a[0], b[1], 1e-12) << pattern << " " << l << " " << r;
                    EXPECT_NEAR(a[1], b[0], 1e-12);
                }
                const SmaaShares c = OrthogonalArea(mirrored, r, l);
                EXPECT_NEAR(a[0], c[0], 1e-12) << pattern << " " << l << " " << r;
                EXPECT_NEAR(a[1], c[1], 1e-12);
            }
        }
    }
}

TEST(Patterns, AreWhereTheTableHasThem) {
    for (int bits = 0; bits < 16; ++bits) {
        const int below_l = bits & 1, below_r = bits >> 1 & 1, above_l = bits >> 2 & 1,
                  above_r = bits >> 3;
        EXPECT_EQ(OrthogonalPattern(3 * below_l + above_l, 3 * below_r + above_r), bits);
        EXPECT_EQ(DiagonalPattern(below_l + 2 * above_l, 2 * below_r + above_r), bits);
    }
}

// At square distances the table holds the value itself, rounded down to 1/255; between them its
// bilinear mean is within what the curve bends: for these runs below 0.02.
TEST(TabledOrthogonalArea, IsTheAreaToItsRounding) {
    for (const int code_l : {0, 1, 3, 4}) {
        for (const int code_r : {0, 1, 3, 4}) {
            const int pattern = OrthogonalPattern(code_l, code_r);
            for (const int l : {0, 1, 4, 9, 100, 225}) {
                for (const int r : {0, 1, 16, 81, 225}) {
                    const SmaaShares exact = OrthogonalArea(pattern, l, r);
                    const SmaaShares tabled = TabledOrthogonalArea(code_l, code_r, l, r);
                    for (std::size_t k = 0; k < 2; ++k) {
                        EXPECT_LE(tabled[k], exact[k] + 1e-12)
                            << pattern << " " << l << " " << r;
                        EXPECT_GE(tabled[k], exact[k] - 1.0 / 255)
                            << pattern << " " << l << " " << r;
                    }
                }
            }
        }
    }
    EXPECT_NEAR(TabledOrthogonalArea(3, 1, 5, 7)[0], OrthogonalArea(9, 5, 7)[0], 0.02);
}

TEST(TabledDiagonalArea, IsTheAreaToItsRounding) {
    for (int code_l = 0; code_l < 4; ++code_l) {
        for (int code_r = 0; code_r < 4; ++code_r) {
            const SmaaShares exact = DiagonalArea(DiagonalPattern(code_l, code_r), 3, 6);
            const SmaaShares tabled = TabledDiagonalArea(code_l, code_r, 3, 6);
            for (std::size_t k = 0; k < 2; ++k) {
                EXPECT_LE(tabled[k], exact[k] + 1e-12);
                EXPECT_GE(tabled[k], exact[k] - 1.0 / 255);
            }
        }
    }
}

}  // namespace
}  // namespace plumb
