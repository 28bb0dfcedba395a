// Scores of colours: the same figures over three channels.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "score/errors.h"
#include "tests/score/made_images.h"

namespace plumb {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

Channels Noise(std::uint64_t seed) {
    Channels channels;
    for (std::uint64_t c = 0; c < 3; ++c)
        channels.push_back(CorrelatedNoise(40, 30, 1, seed, c));
    return channels;
}

// d of a pixel: (1/4, 0, -1/2) and (0, 1/4, 0), six numbers.
TEST(ScoreErrorsOfColours, ByHand) {
    const Channels truth(3, Image<float>(2, 1, 0.5F));
    Channels candidate = truth;
    candidate[0](0, 0) = 0.75F;
    candidate[2](0, 0) = 0;
    candidate[1](1, 0) = 0.75F;
    const ErrorScore score = ScoreChannels(candidate, truth, {}, {}, {.tile_px = 1});
    EXPECT_EQ(score.pixels, 2);
    EXPECT_DOUBLE_EQ(score.bias.value, 0);
    EXPECT_DOUBLE_EQ(score.mae.value, 1.0 / 6);
    EXPECT_DOUBLE_EQ(score.mse.value, (2.0 / 16 + 1.0 / 4) / 6);
    EXPECT_EQ(score.max, 0.5);
    EXPECT_EQ(score.max_column, 0);
    EXPECT_EQ(score.max_channel, 2);
}

TEST(ScoreErrorsOfColours, OneChannelIsTheScalar) {
    const Channels a = Noise(1), b = Noise(2);
    const ErrorScore scalar = ScoreErrors(a[0], b[0]);
    const ErrorScore colour = ScoreChannels(ChannelSpan(&a[0], 1), ChannelSpan(&b[0], 1));
    EXPECT_EQ(scalar.mse.value, colour.mse.value);
    EXPECT_EQ(scalar.mse.interval.high, colour.mse.interval.high);
}

// The MSE of three channels is the mean of theirs, and its tiles add up: equal channels give the
// interval of one, not one that is sqrt(3) shorter.
TEST(ScoreErrorsOfColours, EqualChannelsGiveTheIntervalOfOne) {
    const Channels a = Noise(1), b = Noise(2);
    const ErrorScore one = ScoreErrors(a[0], b[0]);
    const ErrorScore three = ScoreChannels(Channels(3, a[0]), Channels(3, b[0]));
    EXPECT_NEAR(three.mse.value, one.mse.value, 1e-12);
    EXPECT_NEAR(three.mse.interval.high, one.mse.interval.high, 1e-9);
    EXPECT_EQ(three.pixels, one.pixels);
}

// Noise that is the same in all channels moves the mean of the three as that of one: that is the
// worst case, which is stated.
TEST(ScoreErrorsOfColours, NoiseErrorIsThatOfEqualNoises) {
    const Channels a = Noise(1), b = Noise(2);
    const Image<float> s(40, 30, 0.1F);
    const ErrorScore one = ScoreErrors(a[0], b[0], s);
    const ErrorScore three =
        ScoreChannels(Channels(3, a[0]), Channels(3, b[0]), Channels(3, s));
    EXPECT_NEAR(three.bias.noise_error, one.bias.noise_error, 1e-12);
    EXPECT_NEAR(three.mse.noise_error, one.mse.noise_error, 1e-9);
    EXPECT_NEAR(three.mse.value, one.mse.value, 1e-9);
}

TEST(CompareMseOfColours, IsTheDifferenceOfTheScores) {
    const Channels a = Noise(1), b = Noise(2), t = Noise(3);
    const double difference = ScoreChannels(a, t).mse.value - ScoreChannels(b, t).mse.value;
    EXPECT_NEAR(CompareChannels(a, b, t).value, difference, 1e-9);
    EXPECT_EQ(CompareChannels(a, a, t).value, 0);
    EXPECT_EQ(CompareChannels(a, a, t).interval.high, 0);
}

TEST(ScoreTiles, ByHand) {
    const Channels truth(1, Image<float>(3, 1, 0.5F));
    Channels candidate = truth;
    candidate[0](2, 0) = 1;
    const Channels s(1, Image<float>(3, 1, 0.25F));
    const std::vector<TileError> tiles =
        ScoreTiles(candidate, truth, s, {},
                   {.tile_px = 2, .truth_dof = std::numeric_limits<double>::infinity()});
    ASSERT_EQ(tiles.size(), 2u);
    EXPECT_EQ(tiles[0].numbers, 2);
    EXPECT_DOUBLE_EQ(tiles[0].mse, -1.0 / 16);  // 0 - s^2
    EXPECT_DOUBLE_EQ(tiles[1].mse, 1.0 / 4 - 1.0 / 16);
    // v = 4 d^2 s^2 - 2 s^4 = 1/16 - 1/128
    EXPECT_DOUBLE_EQ(tiles[1].noise_error, std::sqrt(1.0 / 16 - 1.0 / 128));
}

TEST(ScoreErrorsOfColours, RefusesWhatDoesNotFit) {
    const Channels three(3, Image<float>(2, 2, 0.0F)), one(1, Image<float>(2, 2, 0.0F));
    Channels odd = three;
    odd[1] = Image<float>(3, 2, 0.0F);
    const auto score = [](Channels c, Channels t, Channels s) {
        return [=] { ScoreChannels(c, t, s); };
    };
    EXPECT_THAT(score(one, three, {}),
                ThrowsMessage<Error>(HasSubstr("candidate: channels = 1, must be as many")));
    EXPECT_THAT(score(three, three, one),
                ThrowsMessage<Error>(HasSubstr("standard error: channels = 1")));
    EXPECT_THAT(score({}, {}, {}), ThrowsMessage<Error>(HasSubstr("truth: channels = 0")));
    EXPECT_THAT(score(odd, three, {}), ThrowsMessage<Error>(HasSubstr("width = 3")));
    EXPECT_THAT(score(three, odd, {}), ThrowsMessage<Error>(HasSubstr("width = 3")));
}

}  // namespace
}  // namespace plumb
