#include "io/pfm.h"

#include <bit>

#include "core/error.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

std::string Floats(std::initializer_list<float> values, bool little_endian = true) {
    std::string bytes;
    for (float value : values) {
        const auto bits = std::bit_cast<std::uint32_t>(value);
        for (int k = 0; k < 4; ++k) {
            bytes += char(bits >> 8 * (little_endian ? k : 3 - k));
        }
    }
    return bytes;
}

// By the format's definition: the last row comes first.
TEST(ParsePfm, TurnsTheRows) {
    const StoredImage image = ParsePfm("Pf\n2 3\n-1.0\n" + Floats({1, 2, 3, 4, 5, 6}), "", 99);
    ASSERT_EQ(image.channels.size(), 1u);
    EXPECT_EQ(image.channels[0].stored.Pixels(), (std::vector<double>{5, 6, 3, 4, 1, 2}));
    EXPECT_TRUE(image.is_float);
    EXPECT_EQ(image.bits, 32);
}

TEST(ParsePfm, ReadsBothByteOrders) {
    const StoredImage image = ParsePfm("Pf 1 1 1\n" + Floats({0.1f}, false), "", 99);
    EXPECT_EQ(image.channels[0].stored(0, 0), double(0.1f));
}

// The size of the scale is a factor, whatever its sign.
TEST(ParsePfm, AppliesTheScale) {
    for (const bool little_endian : {true, false}) {
        const std::string scale = little_endian ? "-0.25" : "0.25";
        const StoredImage image =
            ParsePfm("Pf 2 1 " + scale + "\n" + Floats({8, -3}, little_endian), "", 99);
        EXPECT_EQ(image.channels[0].stored.Pixels(), (std::vector<double>{2, -0.75}));
    }
}

TEST(ParsePfm, ReadsThreeChannels) {
    const StoredImage image =
        ParsePfm("PF\n2 1\n-1\n" + Floats({1, 2, 3, 4, 5, 6}), "a.pfm", 99);
    ASSERT_EQ(image.channels.size(), 3u);
    EXPECT_EQ(image.channels[1].name, "G");
    EXPECT_EQ(image.channels[1].stored.Pixels(), (std::vector<double>{2, 5}));
}

TEST(ParsePfm, NamesWhatIsWrong) {
    const auto message = [](const std::string& bytes) {
        return MessageOf<Error>([&] { ParsePfm(bytes, "a.pfm", 99); });
    };
    EXPECT_EQ(message("Pf\n2 2\n-1\n" + Floats({1, 2, 3})),
              "a.pfm: is truncated, has 12 bytes of pixels, must have 16");
    EXPECT_EQ(message("Pf\n2 x\n-1\n"), "a.pfm: height = x, must be a number");
    EXPECT_EQ(message("Pf\n2 2\n0\n"), "a.pfm: scale = 0, must be finite and not 0");
    EXPECT_EQ(message("Pf\n2 2\ninf\n"), "a.pfm: scale = inf, must be finite and not 0");
    EXPECT_EQ(message("Pf\n2 2"), "a.pfm: has a PFM header that breaks off");
    EXPECT_EQ(message("Pf\n0 2\n-1\n"),
              "a.pfm: has 0 x 2 pixels of 1 channel, must have at least one of each");
    EXPECT_EQ(message("PF\n40000 40000\n-1\n"),
              "a.pfm: has 40000 x 40000 pixels of 3 channels, must be at most 99 numbers");
}

}  // namespace
}  // namespace plumb
