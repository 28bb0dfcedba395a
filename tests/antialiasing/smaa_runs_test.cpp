// The runs and diagonals of SMAA: against what a GPU's bilinear fetches find, and by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "screen_space/antialiasing/smaa_search_table.h"
#include "screen_space/antialiasing/smaa_weights.h"
#include "tests/antialiasing/made_pictures.h"

namespace plumb {
namespace {

/// Random edges, most of them along rows.
SmaaEdges RandomEdges(int width, int height, std::uint64_t seed) {
    Image<std::uint8_t> bits(width, height, 0);
    for (std::uint64_t i = 0; i < bits.Pixels().size(); ++i) {
        if (RandomUnit(seed, i, 0, 0) < 0.9) bits.Pixels()[i] |= SmaaEdges::kTop;
        if (RandomUnit(seed, i, 1, 0) < 0.06) bits.Pixels()[i] |= SmaaEdges::kLeft;
    }
    return SmaaEdges(bits);
}

/// Left and top edges at any point, as a GPU reads them: bilinear, pixel centres whole numbers.
struct Fetch {
    double left, top;
};

Fetch FetchEdges(const SmaaEdges& edges, double x, double y) {
    const int i = int(std::floor(x)), j = int(std::floor(y));
    Fetch sum{0, 0};
    for (int k = 0; k < 4; ++k) {
        const int a = i + k % 2, b = j + k / 2;
        const double weight = (1 - std::abs(x - a)) * (1 - std::abs(y - b));
        sum.left += weight * edges.Left(a, b);
        sum.top += weight * edges.Top(a, b);
    }
    return sum;
}

int Reach(const std::vector<std::uint8_t>& table, const Fetch& e, bool right) {
    const int x = int(std::lround(32 * e.left)) + (right ? 33 : 0);
    const int y = 32 - int(std::lround(32 * e.top));
    return x < kSmaaSearchWidth && y < kSmaaSearchHeight
               ? table[std::size_t(y) * kSmaaSearchWidth + x] / 127
               : 0;
}

// Expected: the published search, pairs of pixels a fetch, decoded by the search table, an
// independent way to the same distances; 0.8281 is its threshold for "both edges of the pair".
TEST(FindSmaaRun, ReachesWhatBilinearFetchesReach) {
    const std::vector<std::uint8_t> table = SmaaSearchTable();
    const SmaaEdges edges = RandomEdges(60, 40, 5);
    int runs = 0, longest = 0;
    for (const int steps : {1, 2, 4, 8}) {
        for (int y = 0; y < edges.Height(); ++y) {
            for (int x = 0; x < edges.Width(); ++x) {
                if (!edges.Top(x, y)) continue;
                Fetch e{0, 1};
                double at = x - 0.25;
                while (at > x - 0.25 - 2 * steps && e.top > 0.8281 && e.left == 0) {
                    e = FetchEdges(edges, at, y - 0.125);
                    at -= 2;
                }
                const double before = x - (at + 3.25 - Reach(table, e, false));
                e = {0, 1};
                at = x + 1.25;
                while (at < x + 1.25 + 2 * steps && e.top > 0.8281 && e.left == 0) {
                    e = FetchEdges(edges, at, y - 0.125);
                    at += 2;
                }
                const double after = at - 3.25 + Reach(table, e, true) - x;
                const SmaaRun run = FindSmaaRun(edges, SmaaAxis::kAlongRows, x, y, steps);
                EXPECT_EQ(run.before, before) << x << " " << y << " " << steps;
                EXPECT_EQ(run.after, after) << x << " " << y << " " << steps;
                // A crossing is read a quarter of a pixel higher: 3/4 and 1/4, times 4.
                EXPECT_EQ(run.code_before,
                          std::lround(4 * FetchEdges(edges, x - before, y - 0.25).left));
                EXPECT_EQ(run.code_after,
                          std::lround(4 * FetchEdges(edges, x + after + 1, y - 0.25).left));
                ++runs;
                longest = std::max(longest, run.after);
            }
        }
    }
    EXPECT_GT(runs, 5000);
    EXPECT_GE(longest, 12);
}

// A floor that rises by six stairs of one pixel, columns 10 to 15, from row 20 to row 14.
Image<Rgb> Stairs() {
    return GreyPicture(40, 32, [](int x, int y) {
        return y >= (x < 10 ? 20 : x < 15 ? 29 - x : 14);
    });
}

SmaaOptions ByFormula(int diagonal_steps = 8) {
    SmaaOptions options = SmaaPresetNamed("high");
    options.areas = SmaaAreaSource::kFormula;
    options.diagonal_steps = diagonal_steps;
    return options;
}

// Pixel (12, 17), a stair with both edges. Down left: (11, 18), (10, 19) are stairs, (9, 20) has
// only its top edge: 2 + 1. Up right: (13, 16), (14, 15), (15, 14) are stairs: 3.
// Ends: at (9, 20) the line goes on to the left (top edge of (8, 20)), code 2; at (15, 14) to the
// right, code 2: above left, below right: 4 + 2.
TEST(DiagonalShares, StairsByHand) {
    const SmaaEdges edges = FindSmaaEdges(Stairs(), ByFormula());
    EXPECT_EQ(DiagonalShares(edges, 12, 17, ByFormula()), DiagonalArea(6, 3, 3));
    EXPECT_EQ(DiagonalShares(edges, 10, 19, ByFormula()), DiagonalArea(6, 1, 5));
    // With three steps the walk up stops at its limit after two stairs, so its end is not known.
    // Down it looks at (9, 20) as its third pixel: an end.
    EXPECT_EQ(DiagonalShares(edges, 12, 17, ByFormula(3)), DiagonalArea(4, 3, 2));
    // Beside the stairs there is no diagonal.
    EXPECT_EQ(DiagonalShares(edges, 5, 20, ByFormula()), (SmaaShares{0, 0}));
}

// Two stairs are too few: 1 + 1 stairs beyond the pixel at most.
TEST(DiagonalShares, NeedMoreThanTwoStairs) {
    const Image<Rgb> short_stairs = GreyPicture(40, 32, [](int x, int y) {
        return y >= (x < 10 ? 20 : x < 11 ? 19 : 18);
    });
    const SmaaEdges edges = FindSmaaEdges(short_stairs, ByFormula());
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 40; ++x) {
            EXPECT_EQ(DiagonalShares(edges, x, y, ByFormula()), (SmaaShares{0, 0}));
        }
    }
}

// Falling stairs are the mirror of rising ones. The areas' points are not: a point on the line
// counts for one side only, 30 of 900 on each line at most. (The pictures differ more: the left
// edges of falling stairs belong to pixels without a top edge, which take them for runs.)
TEST(DiagonalShares, FallingIsRisingMirrored) {
    const Image<Rgb> stairs = Stairs();
    const SmaaEdges rising = FindSmaaEdges(stairs, ByFormula());
    const SmaaEdges falling = FindSmaaEdges(Mirrored(stairs), ByFormula());
    int found = 0;
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 40; ++x) {
            if (!rising.Top(x, y)) continue;
            ASSERT_TRUE(falling.Top(39 - x, y));
            const SmaaShares a = DiagonalShares(rising, x, y, ByFormula());
            const SmaaShares b = DiagonalShares(falling, 39 - x, y, ByFormula());
            for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(a[k], b[k], 30.0 / 900);
            found += a[0] + a[1] > 0;
        }
    }
    EXPECT_EQ(found, 7);  // Six stairs and the pixel left of them.
}

// Everything but the choice between diagonals and runs is the same along rows and columns.
TEST(FindSmaaWeights, TransposeWithThePicture) {
    SmaaOptions options = ByFormula(0);
    options.threshold = 0.05;
    const Image<Rgb> noise = NoisePicture(37, 29, 7);
    const Image<SmaaWeights> a = FindSmaaWeights(FindSmaaEdges(noise, options), options);
    const Image<SmaaWeights> b =
        FindSmaaWeights(FindSmaaEdges(Transposed(noise), options), options);
    int some = 0;
    for (int y = 0; y < 29; ++y) {
        for (int x = 0; x < 37; ++x) {
            const SmaaWeights& w = b(y, x);
            EXPECT_EQ(a(x, y), (SmaaWeights{w[2], w[3], w[0], w[1]})) << x << " " << y;
            some += a(x, y) != SmaaWeights{};
        }
    }
    EXPECT_GT(some, 300);
}

}  // namespace
}  // namespace plumb
