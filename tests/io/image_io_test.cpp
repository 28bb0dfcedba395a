#include "io/image_io.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "tests/io/temp_folder.h"
#include "tests/io/write_images.h"

namespace plumb {
namespace {

using ImageFiles = TempFolder;

const float kNan = std::numeric_limits<float>::quiet_NaN();

Image<float> Ramp(int width, int height, float scale) {
    Image<float> image(width, height);
    for (std::size_t k = 0; k < image.Pixels().size(); ++k) {
        image.Pixels()[k] = scale * float(k);
    }
    return image;
}

TEST_F(ImageFiles, ExrKeepsEveryChannelByName) {
    const std::vector<NamedChannel> channels{
        {"V", Ramp(5, 3, 0.1f)}, {"E1", Ramp(5, 3, -1e-30f)}, {"alpha", Ramp(5, 3, 1e30f)}};
    WriteExr(Path("a.exr"), channels);
    for (const auto& [name, pixels] : ReadChannels(Path("a.exr"))) {
        const auto original =
            std::find_if(channels.begin(), channels.end(),
                         [&, &wanted = name](const auto& c) { return c.name == wanted; });
        ASSERT_NE(original, channels.end()) << name;
        EXPECT_EQ(pixels, original->pixels) << name;
    }
    EXPECT_EQ(ReadChannels(Path("a.exr")).size(), 3u);
}

TEST_F(ImageFiles, TheSameImageGivesTheSameBytes) {
    WriteExr(Path("a.exr"), {{"V", Ramp(50, 30, 0.1f)}}, {{"plumb:version", "0"}});
    WriteExr(Path("b.exr"), {{"V", Ramp(50, 30, 0.1f)}}, {{"plumb:version", "0"}});
    EXPECT_EQ(Get("a.exr"), Get("b.exr"));
    // Two files of the same second prove little: no other second may be in them either.
    for (const auto& [key, text] : ReadStoredImage(Path("a.exr")).metadata) {
        EXPECT_EQ(text.find("20"), std::string::npos) << key << " " << text;
    }
    WritePreview(Path("a.png"), Ramp(50, 30, 0.001f));
    WritePreview(Path("b.png"), Ramp(50, 30, 0.001f));
    EXPECT_EQ(Get("a.png"), Get("b.png"));
}

TEST_F(ImageFiles, ExrNamesMustDiffer) {
    EXPECT_EQ(MessageOf<Error>([&] {
                  WriteExr(Path("a.exr"), {{"V", Ramp(2, 2, 1)}, {"V", Ramp(2, 2, 1)}});
              }),
              Path("a.exr").string() + ": channel name = \"V\", must be a name of its own");
    EXPECT_EQ(FileCount(), 0);
}

// [IEC61966]: linear 0.5 is 1.055 * 0.5^(1/2.4) - 0.055 = 0.735357 encoded, 187.5 of 255: 188;
// linear 0.002 lies on the straight piece, 12.92 * 0.002 * 255 = 6.59: 7.
TEST_F(ImageFiles, PreviewsAreSrgbAndClamped) {
    Image<float> grey(5, 1);
    grey.Pixels() = {0.5f, 0.002f, -1, 7, 1};
    WritePreview(Path("a.png"), grey);
    const StoredImage image = ReadStoredImage(Path("a.png"));
    ASSERT_EQ(image.channels.size(), 3u);
    for (const StoredImage::Channel& channel : image.channels) {
        EXPECT_EQ(channel.stored.Pixels(), (std::vector<double>{188, 7, 0, 255, 255}));
    }
}

TEST_F(ImageFiles, PreviewsShowWhatIsNotANumber) {
    Image<Rgb> rgb(2, 1, Rgb{0, 1, 0});
    rgb(1, 0) = {0.5f, kNan, 0.5f};
    WritePreview(Path("a.png"), rgb);
    const StoredImage image = ReadStoredImage(Path("a.png"));
    EXPECT_EQ(image.channels[0].stored.Pixels(), (std::vector<double>{0, 255}));
    EXPECT_EQ(image.channels[1].stored.Pixels(), (std::vector<double>{255, 0}));
    EXPECT_EQ(image.channels[2].stored.Pixels(), (std::vector<double>{0, 255}));
}

// Tolerance: half a step of 255 encoded, times the steepest decoding slope, 2.4 / 1.055 = 2.28
// at white.
TEST_F(ImageFiles, APreviewReadsBackAsThePicture) {
    Image<Rgb> rgb(4, 4);
    for (int k = 0; k < 16; ++k) rgb(k % 4, k / 4) = {float(k) / 15, 0.3f, 1 - float(k) / 15};
    WritePreview(Path("a.png"), rgb);
    const Image<Rgb> back = ReadPicture(Path("a.png"));
    for (std::size_t k = 0; k < 16; ++k) {
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(back.Pixels()[k][c], rgb.Pixels()[k][c], 0.5 / 255 * 2.28);
        }
    }
}

TEST_F(ImageFiles, FloatPicturesAreLinear) {
    WriteExr(Path("rgb.exr"),
             {{"B", Ramp(2, 1, 3)}, {"G", Ramp(2, 1, 2)}, {"R", Ramp(2, 1, 0.25f)}});
    EXPECT_EQ(ReadPicture(Path("rgb.exr"))(1, 0), (Rgb{0.25f, 2, 3}));
    WriteExr(Path("grey.exr"), {{"V", Ramp(2, 1, 0.25f)}});
    EXPECT_EQ(ReadPicture(Path("grey.exr"))(1, 0), (Rgb{0.25f, 0.25f, 0.25f}));
}

TEST_F(ImageFiles, APictureNeedsColoursOrOneChannel) {
    WriteExr(Path("a.exr"), {{"V", Ramp(2, 1, 1)}, {"W", Ramp(2, 1, 1)}});
    EXPECT_EQ(
        MessageOf<Error>([&] { ReadPicture(Path("a.exr")); }),
        Path("a.exr").string() + ": has the channels V W, must have R, G and B or only one");
}

TEST_F(ImageFiles, GreyPngRoundsToTheNearestStep) {
    Image<double> values(4, 1);
    values.Pixels() = {0, 0.5, 1. / 3, 1};
    WriteGreyPng(Path("16.png"), values, 16);
    EXPECT_EQ(ReadStoredImage(Path("16.png")).channels[0].stored.Pixels(),
              (std::vector<double>{0, 32768, 21845, 65535}));
    WriteGreyPng(Path("8.png"), values, 8);
    EXPECT_EQ(ReadStoredImage(Path("8.png")).channels[0].stored.Pixels(),
              (std::vector<double>{0, 128, 85, 255}));
    EXPECT_EQ(ReadStoredImage(Path("8.png")).bits, 8);
}

TEST_F(ImageFiles, GreyPngNamesThePixelOutOfRange) {
    Image<double> values(3, 2, 0.5);
    values(2, 1) = 1.25;
    EXPECT_EQ(MessageOf<Error>([&] { WriteGreyPng(Path("a.png"), values, 16); }),
              Path("a.png").string() + ": value at pixel (2, 1) = 1.25, must be in [0, 1]");
    values(2, 1) = kNan;
    EXPECT_THROW(WriteGreyPng(Path("a.png"), values, 16), Error);
    EXPECT_EQ(FileCount(), 0);
}

}  // namespace
}  // namespace plumb
