#include "score/temporal.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace plumb {
namespace {

using Frames = std::vector<Image<float>>;

Frames Of(std::initializer_list<float> values) {
    Frames frames;
    for (float value : values) frames.emplace_back(2, 1, value);
    return frames;
}

// Mean 2; squares about it 1 + 0 + 1, over F - 1 = 2. The other pixel stands still.
TEST(OverFrames, ByHand) {
    Frames frames = Of({1, 2, 3});
    for (Image<float>& frame : frames) frame(1, 0) = 5;
    const MeanAndVariance result = OverFrames(frames);
    EXPECT_EQ(result.mean(0, 0), 2);
    EXPECT_EQ(result.variance(0, 0), 1);
    EXPECT_EQ(result.mean(1, 0), 5);
    EXPECT_EQ(result.variance(1, 0), 0);
}

// Truth 1 2 3 varies by 1. A candidate that is 0.5 too low in every frame varies as much and
// does not flicker; one of errors 1, -1, 0 flickers by (1 + 1 + 0) / 2 = 1.
TEST(Temporal, FlickerIsTheVarianceOfTheErrorByHand) {
    const TemporalScore steady = ScoreTemporal(Of({0.5f, 1.5f, 2.5f}), Of({1, 2, 3}));
    EXPECT_DOUBLE_EQ(steady.candidate.value, 1);
    EXPECT_DOUBLE_EQ(steady.truth.value, 1);
    EXPECT_DOUBLE_EQ(steady.flicker.value, 0);
    const TemporalScore flickers = ScoreTemporal(Of({2, 1, 3}), Of({1, 2, 3}));
    EXPECT_DOUBLE_EQ(flickers.candidate.value, 1);
    EXPECT_DOUBLE_EQ(flickers.flicker.value, 1);
}

// mean s^2 = (1/4 + 1/4 + 0) / 3 = 1/6 is taken off what the truth's noise adds to.
TEST(Temporal, TakesOffTheNoiseByHand) {
    const TemporalScore score =
        ScoreTemporal(Of({2, 1, 3}), Of({1, 2, 3}), Of({0.5f, 0.5f, 0}));
    EXPECT_DOUBLE_EQ(score.candidate.value, 1);
    EXPECT_DOUBLE_EQ(score.truth.value, 1 - 1.0 / 6);
    EXPECT_DOUBLE_EQ(score.flicker.value, 1 - 1.0 / 6);
}

TEST(Temporal, CountsTheMaskAlone) {
    Frames candidates = Of({2, 1, 3});
    for (Image<float>& frame : candidates) frame(1, 0) = 0;
    Mask mask(2, 1, 1);
    mask(1, 0) = 0;
    EXPECT_DOUBLE_EQ(ScoreTemporal(candidates, Of({1, 2, 3}), {}, mask).flicker.value, 1);
}

TEST(Temporal, ValidatesItsInput) {
    EXPECT_THROW(OverFrames(Of({1})), Error);
    EXPECT_THROW(OverFrames(Frames{Image<float>(2, 1), Image<float>(1, 1)}), Error);
    EXPECT_THROW(ScoreTemporal(Of({1, 2}), Of({1, 2, 3})), Error);
    EXPECT_THROW(ScoreTemporal(Of({1, 2}), Of({1, 2}), Of({1})), Error);
    EXPECT_THROW(ScoreTemporal(Of({1, 2}), Of({1, 2}), {}, Mask(1, 1)), Error);
}

}  // namespace
}  // namespace plumb
