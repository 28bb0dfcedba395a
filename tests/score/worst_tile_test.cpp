#include "score/worst_tile.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "tests/score/made_images.h"

namespace plumb {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

// 70 x 40 pixels are 3 x 2 tiles, the last column 6 wide and the last row 8 high. Half of that of
// the corner is off by 1/2.
TEST(FindWorstTile, ByHand) {
    const Channels truth{Image<float>(70, 40, 0.25F)};
    Channels candidate = truth;
    for (int j = 32; j < 36; ++j)
        for (int i = 64; i < 70; ++i) candidate[0](i, j) = 0.75F;
    const WorstTile worst = FindWorstTile(candidate, truth);
    EXPECT_EQ(worst.tiles, 6);
    EXPECT_EQ(worst.column_px, 64);
    EXPECT_EQ(worst.row_px, 32);
    EXPECT_EQ(worst.width_px, 6);
    EXPECT_EQ(worst.height_px, 8);
    EXPECT_DOUBLE_EQ(worst.mse, 0.125);
    EXPECT_DOUBLE_EQ(worst.mse_at_least, 0.125);  // Of an exact truth.
}

TEST(FindWorstTile, OfNothingIsNothing) {
    const Channels truth{Image<float>(4, 4, 0.25F)};
    EXPECT_EQ(FindWorstTile(truth, truth, {}, Mask(4, 4, 0)).tiles, 0);
    EXPECT_EQ(FindWorstTile(truth, truth).mse, 0);
    EXPECT_THAT([&] { FindWorstTile(truth, truth, {}, {}, {}, 0); },
                ThrowsMessage<Error>(HasSubstr("tile_px = 0, must be >= 1")));
}

// A perfect candidate under noise of known size: the worst of 64 tiles looks bad each time, and
// `at least` says more than 0 in 5 of 100 pictures. 14 or more have a chance of 5e-4.
TEST(FindWorstTile, DoesNotTakeChanceForAFault) {
    const Channels truth{Image<float>(128, 128, 0.0F)}, s{Image<float>(128, 128, 1.0F)};
    const ErrorOptions known{.truth_dof = std::numeric_limits<double>::infinity()};
    int alarms = 0;
    for (std::uint64_t run = 0; run < 100; ++run) {
        const Channels noisy{CorrelatedNoise(128, 128, 1, 5, run)};
        const WorstTile worst = FindWorstTile(truth, noisy, s, {}, known, 16);
        EXPECT_GT(worst.mse, 0);
        alarms += worst.mse_at_least > 0;
    }
    EXPECT_LT(alarms, 14);
}

TEST(FindWorstTile, FindsAFaultUnderNoise) {
    const Channels s{Image<float>(128, 128, 1.0F)};
    Channels noisy{CorrelatedNoise(128, 128, 1, 5, 0)}, candidate{Image<float>(128, 128, 0.0F)};
    for (int j = 32; j < 48; ++j)
        for (int i = 16; i < 32; ++i) candidate[0](i, j) = 1.5F;
    const WorstTile worst = FindWorstTile(candidate, noisy, s, {}, {}, 16);
    EXPECT_EQ(worst.column_px, 16);
    EXPECT_EQ(worst.row_px, 32);
    EXPECT_GT(worst.mse_at_least, 1);
    EXPECT_LT(worst.mse_at_least, 2.25);  // 1.5^2
}

}  // namespace
}  // namespace plumb
