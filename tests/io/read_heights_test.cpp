#include "io/read_heights.h"

#include <gmock/gmock.h>

#include <limits>

#include "core/error.h"
#include "tests/io/temp_folder.h"
#include "tests/io/write_geotiff.h"
#include "tests/io/write_images.h"

namespace plumb {
namespace {

using Heights = TempFolder;

TEST_F(Heights, IntegersAreSharesOfTheGreatest) {
    WriteStored<std::uint16_t>(Path("a.png"), 3, 1, {"Y"}, {0, 65535, 13107});
    const RawHeights png = ReadHeights(Path("a.png"));
    EXPECT_EQ(png.values.Pixels(), (std::vector<double>{0, 1, 0.2}));
    EXPECT_EQ(png.bits, 16);
    EXPECT_FALSE(png.is_float);
    EXPECT_EQ(png.channel, "Y");
    WriteStored<std::int16_t>(Path("a.tif"), 2, 1, {"Y"}, {-32767, 32767});
    EXPECT_EQ(ReadHeights(Path("a.tif")).values.Pixels(), (std::vector<double>{-1, 1}));
}

TEST_F(Heights, FloatsAreThemselves) {
    WriteStored<float>(Path("a.exr"), 2, 1, {"height"}, {-11.5f, 830.25f});
    const RawHeights heights = ReadHeights(Path("a.exr"));
    EXPECT_EQ(heights.values.Pixels(), (std::vector<double>{-11.5, 830.25}));
    EXPECT_TRUE(heights.is_float);
    EXPECT_EQ(heights.channel, "height");
}

TEST_F(Heights, AGreyPictureInColourIsOneChannel) {
    WriteStored<std::uint8_t>(Path("a.png"), 2, 1, {"R", "G", "B"}, {51, 51, 51, 0, 0, 0});
    EXPECT_EQ(ReadHeights(Path("a.png")).values.Pixels(), (std::vector<double>{0.2, 0}));
    // An alpha beside it is ignored, whatever it holds.
    WriteStored<std::uint8_t>(Path("b.png"), 1, 1, {"R", "G", "B", "A"}, {51, 51, 51, 7});
    EXPECT_EQ(ReadHeights(Path("b.png")).values(0, 0), 0.2);
    WriteStored<std::uint8_t>(Path("c.png"), 1, 1, {"Y", "A"}, {51, 7});
    EXPECT_EQ(ReadHeights(Path("c.png")).values(0, 0), 0.2);
}

TEST_F(Heights, ChannelsThatDifferNeedAChoice) {
    WriteStored<std::uint8_t>(Path("b.png"), 1, 1, {"R", "G", "B"}, {10, 10, 30});
    EXPECT_THROW(ReadHeights(Path("b.png")), Error);
    WriteStored<std::uint8_t>(Path("a.png"), 1, 1, {"R", "G", "B", "A"}, {10, 20, 30, 51});
    EXPECT_EQ(MessageOf<Error>([&] { ReadHeights(Path("a.png")); }),
              Path("a.png").string() +
                  ": has the channels R, G, B, A and they differ, must be one or alike; name "
                  "one in the side file's field \"channel\" (or \"packing\": \"rgb24\")");
    EXPECT_EQ(ReadHeights(Path("a.png"), {.channel = "A"}).values(0, 0), 0.2);
    EXPECT_EQ(MessageOf<Error>([&] { ReadHeights(Path("a.png"), {.channel = "Z"}); }),
              Path("a.png").string() + ": channel = Z, must be one of R, G, B, A");
}

// 65536 * 1 + 256 * 2 + 3 = 66051.
TEST_F(Heights, PackedHeightsHave24Bits) {
    WriteStored<std::uint8_t>(Path("a.png"), 2, 1, {"R", "G", "B"}, {1, 2, 3, 255, 255, 255});
    const RawHeights heights = ReadHeights(Path("a.png"), {.channel = "", .rgb24 = true});
    EXPECT_EQ(heights.full_scale, 16777215);
    EXPECT_EQ(heights.values(0, 0) * heights.full_scale, 66051);
    EXPECT_EQ(heights.values(1, 0), 1);
    EXPECT_EQ(heights.bits, 24);
    WriteStored<std::uint16_t>(Path("b.png"), 1, 1, {"R", "G", "B"}, {1, 2, 3});
    EXPECT_EQ(
        MessageOf<Error>([&] { ReadHeights(Path("b.png"), {.channel = "", .rgb24 = true}); }),
        Path("b.png").string() + ": bits of packing rgb24 = 16, must be 8, unsigned");
}

TEST_F(Heights, WhatIsNoHeightIsNamedByItsPixel) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    WriteStored<float>(Path("a.exr"), 2, 2, {"Y"}, {1, 2, 3, nan});
    EXPECT_EQ(MessageOf<Error>([&] { ReadHeights(Path("a.exr")); }),
              Path("a.exr").string() + ": pixel (1, 1) = nan, must be finite");
    WriteStored<float>(Path("b.exr"), 2, 2, {"Y"}, {1, 2, -INFINITY, 3});
    EXPECT_EQ(MessageOf<Error>([&] { ReadHeights(Path("b.exr")); }),
              Path("b.exr").string() + ": pixel (0, 1) = -inf, must be finite");
    WriteGeoTiff(Path("c.tif"), 2, {5, 6, -32768, 7}, {.no_data = "-32768"});
    EXPECT_EQ(MessageOf<Error>([&] { ReadHeights(Path("c.tif")); }),
              Path("c.tif").string() +
                  ": pixel (0, 1) = -32768, must be measured, is the file's \"no data\" value");
}

// However a program writes "no data" in decimal digits, the number that the pixels hold is meant.
TEST_F(Heights, NoDataIsKnownInEverySpelling) {
    const float lowest = std::numeric_limits<float>::lowest();
    for (const char* spelling :
         {"-3.40282346638529e+38", "-3.4028234663852886e+38", "-3.40282347e+38",
          "-340282346638528859811704183484516925440"}) {
        WriteGeoTiffOf<float>(Path("a.tif"), 2, {5, 6, lowest, 7}, {.no_data = spelling});
        EXPECT_THAT(
            MessageOf<Error>([&] { ReadHeights(Path("a.tif")); }),
            testing::HasSubstr("pixel (0, 1) = -3.4028234663852886e+38, must be measured"))
            << spelling;
    }
    WriteGeoTiffOf<float>(Path("b.tif"), 2, {5, 0.1F, 4, 7}, {.no_data = "0.1"});
    EXPECT_THROW(ReadHeights(Path("b.tif")), Error);
    for (const char* spelling : {"-9999", "-9999.0", "-9.999e3", " -9999 "}) {
        WriteGeoTiffOf<float>(Path("c.tif"), 2, {5, 6, 4, -9999}, {.no_data = spelling});
        EXPECT_THROW(ReadHeights(Path("c.tif")), Error) << spelling;
        WriteGeoTiffOf<double>(Path("d.tif"), 2, {5, 6, 4, -9999}, {.no_data = spelling});
        EXPECT_THROW(ReadHeights(Path("d.tif")), Error) << spelling;
        WriteGeoTiff(Path("e.tif"), 2, {5, 6, 4, -9999}, {.no_data = spelling});
        EXPECT_THROW(ReadHeights(Path("e.tif")), Error) << spelling;
    }
    // A double holds more digits than a float: what differs in them is another number.
    WriteGeoTiffOf<double>(Path("f.tif"), 2, {5, 6, 4, 0.1}, {.no_data = "0.10000000149"});
    EXPECT_EQ(ReadHeights(Path("f.tif")).values(1, 1), 0.1);
}

TEST_F(Heights, TakesTheSpacingOfAGeoTiff) {
    WriteGeoTiff(Path("a.tif"), 2, {5, 6, 8, 7}, {.pixel_scale = {74, 93, 0}});
    EXPECT_EQ(ReadHeights(Path("a.tif")).spacing_m, Vec2(74, 93));
}

TEST_F(Heights, ASingleTexelIsRead) {
    WriteStored<std::uint8_t>(Path("a.png"), 1, 1, {"Y"}, {255});
    EXPECT_EQ(ReadHeights(Path("a.png")).values, Image<double>(1, 1, 1));
}

}  // namespace
}  // namespace plumb
