#include "jobs/score/picture_file.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "io/image_io.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::ThrowsMessage;

class PictureFiles : public TempFolder {
  protected:
    /// Channel k of an EXR of 2 x 1 pixels is k / 8.
    std::filesystem::path Exr(const std::string& name,
                              std::initializer_list<const char*> names) {
        std::vector<NamedChannel> channels;
        for (const char* channel : names)
            channels.push_back({channel, Image<float>(2, 1, float(channels.size()) / 8)});
        WriteExr(Path(name), channels);
        return Path(name);
    }

    PictureFile ReadIt(const std::string& text) {
        return ReadPictureToScore(ParsePictureName(Path(text).string()));
    }
};

TEST_F(PictureFiles, AColonChoosesAChannel) {
    const PictureName plain = ParsePictureName("a/b.exr");
    EXPECT_EQ(plain.path, "a/b.exr");
    EXPECT_EQ(plain.channel, "");
    const PictureName chosen = ParsePictureName("a/b.exr:diffuse.R");
    EXPECT_EQ(chosen.path, "a/b.exr");
    EXPECT_EQ(chosen.channel, "diffuse.R");
    EXPECT_EQ(chosen.Text(), "b.exr:diffuse.R");
    EXPECT_EQ(ParsePictureName("a:b/c.png").path, "a:b/c.png");
    Put("odd:name.pfm", "");
    EXPECT_EQ(ParsePictureName(Path("odd:name.pfm").string()).channel, "");
    EXPECT_THAT([] { ParsePictureName("b.exr:"); }, ThrowsMessage<Error>(HasSubstr("b.exr:")));
}

TEST_F(PictureFiles, AColourAScalarAndAnAlpha) {
    Exr("rgba.exr", {"R", "G", "B", "A"});
    Exr("y.exr", {"Y"});
    Exr("ya.exr", {"Y", "A"});
    const PictureFile rgba = ReadIt("rgba.exr");
    EXPECT_THAT(rgba.channel_names, ElementsAre("R", "G", "B"));
    EXPECT_EQ(rgba.channels[2](1, 0), 0.25F);
    EXPECT_THAT(rgba.all, SizeIs(4));
    EXPECT_TRUE(rgba.is_float);
    EXPECT_THAT(ReadIt("y.exr").channel_names, ElementsAre("Y"));
    EXPECT_THAT(ReadIt("ya.exr").channel_names, ElementsAre("Y"));
}

TEST_F(PictureFiles, LayersAndStandardErrors) {
    Exr("truth.exr",
        {"V", "V.error", "E.R", "E.G", "E.B", "E.error.R", "E.error.G", "E.error.B", "alpha2"});
    const PictureFile V = ReadIt("truth.exr:V");
    EXPECT_THAT(V.channels, SizeIs(1));
    ASSERT_THAT(V.standard_error, SizeIs(1));
    EXPECT_EQ(V.standard_error[0](0, 0), 0.125F);
    const PictureFile E = ReadIt("truth.exr:E");
    EXPECT_THAT(E.channel_names, ElementsAre("E.R", "E.G", "E.B"));
    ASSERT_THAT(E.standard_error, SizeIs(3));
    EXPECT_EQ(E.standard_error[2](0, 0), 7 / 8.0F);
    EXPECT_THAT(ReadIt("truth.exr:alpha2").standard_error, IsEmpty());
}

TEST_F(PictureFiles, AChannelThatIsNotThere) {
    Exr("truth.exr", {"V_near", "V_near.error", "E.R", "E.G", "E.B"});
    EXPECT_THAT([&] { ReadIt("truth.exr:V_nera"); },
                ThrowsMessage<Error>(HasSubstr("truth.exr: channel = V_nera, must be one of V_near, "
                                               "E, V_near.error; did you mean V_near?")));
    EXPECT_THAT([&] { ReadIt("truth.exr"); },
                ThrowsMessage<Error>(HasSubstr("choose by truth.exr:NAME or --channel NAME: V_near, "
                                               "E, V_near.error")));
}

TEST_F(PictureFiles, IntegersAreSharesOfTheirGreatest) {
    WriteGreyPng(Path("g.png"), Image<double>(2, 1, 0.2), 8);
    const PictureFile png = ReadIt("g.png");
    EXPECT_FALSE(png.is_float);
    EXPECT_EQ(png.bits, 8);
    EXPECT_EQ(png.channels[0](0, 0), 51 / 255.0F);
}

// A Radiance file of one pixel, flat: bytes 128, 64, 0 and the exponent 129 are (1, 0.5, 0) * 2^0
// up to half a step ((m + 0.5) / 256 in some readers, m / 256 in others).
TEST_F(PictureFiles, Radiance) {
    Put("a.hdr", std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n") +
                     std::string("\x80\x40\x00\x81", 4));
    const PictureFile hdr = ReadIt("a.hdr");
    EXPECT_TRUE(hdr.is_float);
    ASSERT_THAT(hdr.channels, SizeIs(3));
    EXPECT_NEAR(hdr.channels[0](0, 0), 1, 0.005);
    EXPECT_NEAR(hdr.channels[1](0, 0), 0.5, 0.005);
}

TEST_F(PictureFiles, Pfm) {
    const float pixel = 0.75F;
    Put("a.pfm",
        "Pf\n1 1\n-1\n" + std::string(reinterpret_cast<const char*>(&pixel), sizeof pixel));
    EXPECT_EQ(ReadIt("a.pfm").channels[0](0, 0), 0.75F);
}

TEST_F(PictureFiles, DamagedOnesAreRefusedByName) {
    Put("empty.png", "");
    Put("text.exr", "not a picture");
    Put("a.jpg", "\xff\xd8\xff");
    for (const char* name : {"empty.png", "text.exr", "a.jpg", "gone.png", "gone.hdr"}) {
        EXPECT_THAT([&] { ReadIt(name); }, ThrowsMessage<Error>(HasSubstr(name)));
    }
}

TEST_F(PictureFiles, AMaskIsWhatIsNotNought) {
    Image<Rgb> picture(2, 1, Rgb{0, 0, 0});
    picture(1, 0)[2] = 1;
    WritePreview(Path("m.png"), picture);
    const Mask mask = ReadMask(ParsePictureName(Path("m.png").string()));
    EXPECT_EQ(mask(0, 0), 0);
    EXPECT_NE(mask(1, 0), 0);
}

}  // namespace
}  // namespace plumb
