#include "jobs/score/compared.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/srgb.h"
#include "tests/score/made_images.h"

namespace plumb {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

PictureFile Made(const std::string& label, Channels channels, bool is_float) {
    PictureFile file{.name = {label + ".exr", ""}, .label = label};
    file.channels = std::move(channels);
    for (std::size_t c = 0; c < file.channels.size(); ++c)
        file.channel_names.push_back(file.channels.size() == 1 ? "Y"
                                                               : std::string(1, "RGB"[c]));
    file.is_float = is_float;
    file.bits = is_float ? 32 : 8;
    return file;
}

PictureFile Flat(const std::string& label, float value, bool is_float, int width = 4) {
    return Made(label, {Image<float>(width, 3, value)}, is_float);
}

float ValueOf(const PictureFile& c, const PictureFile& t, Encoding encoding) {
    return Compare({c}, t, {.encoding = encoding}).candidates[0].values[0](0, 0);
}

TEST(Compare, IntegersAreComparedAsStoredAndSeenInLight) {
    const PictureFile c = Flat("c", 0.5F, false), t = Flat("t", 0.25F, false);
    const Compared compared = Compare({c}, t, {});
    EXPECT_EQ(compared.candidates[0].values[0](0, 0), 0.5F);
    EXPECT_FLOAT_EQ(compared.candidates[0].linear(0, 0)[1], float(DecodeSrgb(0.5)));
    EXPECT_THAT(compared.encoding, HasSubstr("which is assumed"));
    const Compared data = Compare({c}, t, {.encoding = Encoding::kLinear});
    EXPECT_EQ(data.candidates[0].linear(0, 0)[1], 0.5F);
    EXPECT_TRUE(data.is_linear);
}

TEST(Compare, IntegersAgainstFloatsMustBeSaid) {
    const PictureFile integers = Flat("i", 0.5F, false), floats = Flat("f", 0.25F, true);
    EXPECT_THAT(
        [&] { Compare({integers}, floats, {}); },
        ThrowsMessage<Error>("i: holds integers and f floats; --encoding must say whether "
                             "the integers are srgb or linear"));
    EXPECT_THAT([&] { Compare({floats}, integers, {}); },
                ThrowsMessage<Error>(HasSubstr("i: holds integers and f floats")));
    EXPECT_FLOAT_EQ(ValueOf(integers, floats, Encoding::kSrgb), float(DecodeSrgb(0.5)));
    EXPECT_EQ(ValueOf(integers, floats, Encoding::kLinear), 0.5F);
    EXPECT_FLOAT_EQ(ValueOf(floats, integers, Encoding::kSrgb), float(EncodeSrgb(0.25)));
    EXPECT_EQ(ValueOf(floats, integers, Encoding::kLinear), 0.25F);
    // What no integer could hold.
    EXPECT_EQ(ValueOf(Flat("f", 7, true), integers, Encoding::kSrgb), 1);
}

TEST(Compare, RefusesSizesAndChannelsThatDiffer) {
    const PictureFile t = Flat("t", 0.5F, true);
    EXPECT_THAT([&] { Compare({Flat("c", 0.5F, true, 5)}, t, {}); },
                ThrowsMessage<Error>("c: is 5 x 3 pixels, must be 4 x 3 as t"));
    const PictureFile colour = Made("c", Channels(3, Image<float>(4, 3, 0.0F)), true);
    EXPECT_THAT([&] { Compare({colour}, t, {}); },
                ThrowsMessage<Error>("c: has 3 channels (R, G, B), must have 1 (Y) as t"));
}

TEST(Compare, CropsAllPictures) {
    PictureFile c = Flat("c", 0, true), t = Flat("t", 0, true);
    c.channels[0](2, 1) = 1;
    t.standard_error = {Image<float>(4, 3, 0.5F)};
    const Compared compared = Compare({c}, t, {.crop = Rectangle{2, 1, 2, 2}});
    EXPECT_EQ(compared.candidates[0].values[0].Width(), 2);
    EXPECT_EQ(compared.candidates[0].values[0](0, 0), 1);
    EXPECT_EQ(compared.standard_error[0].Height(), 2);
    EXPECT_EQ(compared.counted, 4);
    EXPECT_EQ(compared.x, 2);
    for (const Rectangle crop : {Rectangle{-1, 0, 2, 2},
                                 {0, 0, 5, 1},
                                 {3, 0, 2, 1},
                                 {0, 0, 0, 1},
                                 {0, 2147483647, 1, 2147483647}}) {
        EXPECT_THAT([&] { Compare({c}, t, {.crop = crop}); },
                    ThrowsMessage<Error>(HasSubstr("--crop")));
    }
}

TEST(Compare, PixelsThatAreNotFiniteAreRefusedOrLeftOut) {
    PictureFile c = Flat("c", 0.5F, true), t = Flat("t", 0.25F, true);
    c.channels[0](1, 2) = kNan;
    c.channels[0](3, 2) = std::numeric_limits<float>::infinity();
    EXPECT_THAT([&] { Compare({c}, t, {}); },
                ThrowsMessage<Error>("c: 2 pixels are not finite, the first at (1, 2); "
                                     "--bad-pixels skip leaves them out"));
    t.channels[0](0, 0) = kNan;
    const Compared compared = Compare({c}, t, {.bad = BadPixels::kSkip});
    EXPECT_EQ(compared.counted, 9);
    EXPECT_EQ(compared.skipped, 3);
    // FLIP sees the reference there in both, and black where it has none.
    EXPECT_EQ(compared.candidates[0].linear(1, 2)[0], 0.25F);
    EXPECT_EQ(compared.candidates[0].linear(0, 0)[0], 0);
    EXPECT_EQ(compared.reference.linear(0, 0)[0], 0);
    t.standard_error = {Image<float>(4, 3, kNan)};
    EXPECT_THAT([&] { Compare({c}, t, {.bad = BadPixels::kSkip}); },
                ThrowsMessage<Error>("no pixel is left to score"));
}

TEST(Compare, LooksAtWhatCounts) {
    PictureFile c = Flat("c", 0.5F, true), t = Flat("t", 0.25F, true);
    EXPECT_TRUE(Compare({c}, t, {}).in_unit);
    c.channels[0](1, 1) = -1;
    const Compared compared = Compare({c}, t, {});
    EXPECT_FALSE(compared.in_unit);
    EXPECT_EQ(compared.candidates[0].negative, 1);
}

// A wall at 1 m beside sky: the sky is no surface, and the edge is within 3 pixels of it.
TEST(Compare, RegionsNeedATruth) {
    const PictureFile c = Flat("c", 0.5F, true, 12);
    PictureFile t = Flat("t", 0.25F, true, 12);
    EXPECT_THAT([&] { Compare({c}, t, {.region = "seen"}); },
                ThrowsMessage<Error>(HasSubstr("t has no channel depth_m")));
    EXPECT_THAT([&] { Compare({c}, t, {.region = "edge"}); },
                ThrowsMessage<Error>(HasSubstr("did you mean edges?")));
    t.depth_m = MadeImage<float>(12, 3, [](int i, int) {
        return i < 4 ? std::numeric_limits<double>::infinity() : 1.0;
    });
    EXPECT_EQ(Compare({c}, t, {.region = "seen"}).counted, 8 * 3);
    EXPECT_EQ(Compare({c}, t, {.region = "edges"}).counted, 4 * 3);
}

}  // namespace
}  // namespace plumb
