#include "score/quantiles.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>

#include "core/error.h"
#include "tests/score/made_images.h"

namespace plumb {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

// |d| = 1/8 ... 8/8 in some order and sign: exact in float.
Channels Ladder() {
    return {MadeImage<float>(4, 2, [](int i, int j) {
        const int k = (3 * (i + 4 * j)) % 8 + 1;
        return (k % 2 ? 1 : -1) * k / 8.0;
    })};
}
const Channels kNought{Image<float>(4, 2, 0.0F)};

std::vector<double> QuantilesOf(const Channels& c, std::initializer_list<double> shares,
                                const Mask& mask = {}) {
    std::vector<double> values;
    for (const Measured& figure :
         AbsoluteErrorQuantiles(c, kNought, std::vector(shares), mask)) {
        values.push_back(figure.value);
    }
    return values;
}

// Of eight numbers the least holds the first eighth, the greatest the last.
TEST(AbsoluteErrorQuantiles, ByHand) {
    EXPECT_THAT(QuantilesOf(Ladder(), {0.01, 0.125, 0.126, 0.5, 0.9, 1}),
                ElementsAre(0.125, 0.125, 0.25, 0.5, 1, 1));
}

TEST(AbsoluteErrorQuantiles, OfAMask) {
    Mask mask(4, 2, 0);
    mask(0, 0) = mask(1, 0) = 1;  // 1/8 and 4/8
    EXPECT_THAT(QuantilesOf(Ladder(), {0.5, 1}, mask), ElementsAre(0.125, 0.5));
    EXPECT_TRUE(std::isnan(QuantilesOf(Ladder(), {0.5}, Mask(4, 2, 0))[0]));
}

TEST(AbsoluteErrorQuantiles, RefusesASharesThatIsNone) {
    for (const double share : {0.0, -0.5, 1.5, double(NAN)}) {
        EXPECT_THAT([&] { QuantilesOf(Ladder(), {share}); },
                    ThrowsMessage<Error>(HasSubstr("share = ")));
    }
}

// The median and the 90 % quantile of |normal| are 0.67449 and 1.64485 ([Abramowitz64] table
// 26.5). A 95 % interval fails in 5 of 100 pictures, in 14 or more with a chance of 5e-4.
TEST(AbsoluteErrorQuantiles, IntervalsHoldTheTruth) {
    const Channels nought{Image<float>(64, 64, 0.0F)};
    const std::array shares{0.5, 0.9};
    const std::array expected{0.674490, 1.644854};
    std::array missed{0, 0};
    for (std::uint64_t run = 0; run < 100; ++run) {
        const Channels noise{CorrelatedNoise(64, 64, 3, 77, run)};
        const std::vector<Measured> q = AbsoluteErrorQuantiles(noise, nought, shares);
        for (std::size_t k = 0; k < 2; ++k) {
            missed[k] +=
                !(q[k].interval.low <= expected[k] && expected[k] <= q[k].interval.high);
        }
    }
    EXPECT_LT(missed[0], 14);
    EXPECT_LT(missed[1], 14);
}

// Values 1, 2, 3, 4 of sum 10: up to 2 they add up to 3, up to 3 to 6, all to 10.
TEST(WeightedQuantiles, ByHand) {
    const auto map = MadeImage<float>(2, 2, [](int i, int j) { return 4 - i - 2 * j; });
    EXPECT_THAT(WeightedQuantiles(map, std::array{0.05, 0.25, 0.31, 0.59, 0.61, 1.0}),
                ElementsAre(1, 2, 3, 3, 4, 4));
    EXPECT_EQ(WeightedQuantiles(Image<float>(3, 3, 0.0F), std::array{0.5})[0], 0);
    EXPECT_TRUE(std::isnan(WeightedQuantiles(map, std::array{0.5}, Mask(2, 2, 0))[0]));
}

// A large part without error does not hide the rest; a plain median would be 0.
TEST(WeightedQuantiles, MindWhatIsWrong) {
    Image<float> map(10, 10, 0.0F);
    map(3, 3) = 0.75F;
    EXPECT_EQ(WeightedQuantiles(map, std::array{0.5})[0], 0.75);
}

// Two pixels in bin 10 (weight 0.105 each), two in bin 30 (0.305 each): 0.82 in all, half of it
// 0.41; bin 30 begins at 0.21 and holds 0.61, so it is reached 0.2 / 0.61 of the way through.
TEST(BinnedWeightedQuantiles, ByHand) {
    const auto map = MadeImage<float>(2, 2, [](int i, int) { return i == 0 ? 0.104 : 0.307; });
    EXPECT_NEAR(BinnedWeightedQuantiles(map, std::array{0.5})[0], 0.30 + 0.01 * 0.2 / 0.61,
                1e-12);
}

}  // namespace
}  // namespace plumb
