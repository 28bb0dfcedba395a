#include "io/stored_image.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "io/image_io.h"
#include "tests/io/temp_folder.h"
#include "tests/io/write_images.h"
#include "tests/io/write_png.h"

namespace plumb {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

using Stored = TempFolder;

/// The extremes of T and something between, stored and read back.
template <class T>
void ExpectExtremesSurvive(const std::filesystem::path& path, double full_scale) {
    using Limits = std::numeric_limits<T>;
    const std::vector<T> numbers{Limits::lowest(), Limits::max(), T(1), T(77)};
    WriteStored(path, 4, 1, {"Y"}, numbers);
    const StoredImage image = ReadStoredImage(path);
    ASSERT_EQ(image.channels.size(), 1u);
    EXPECT_EQ(image.channels[0].stored.Pixels(),
              std::vector<double>(numbers.begin(), numbers.end()));
    EXPECT_EQ(image.bits, int(8 * sizeof(T)));
    EXPECT_EQ(image.is_signed, Limits::is_signed);
    EXPECT_EQ(image.is_float, !Limits::is_integer);
    EXPECT_EQ(image.full_scale, full_scale);
}

TEST_F(Stored, NumbersOfEveryTypeAreExact) {
    ExpectExtremesSurvive<std::uint8_t>(Path("8.png"), 255);
    ExpectExtremesSurvive<std::uint16_t>(Path("16.png"), 65535);
    ExpectExtremesSurvive<std::uint8_t>(Path("8.tif"), 255);
    ExpectExtremesSurvive<std::uint16_t>(Path("16.tif"), 65535);
    ExpectExtremesSurvive<std::int16_t>(Path("s16.tif"), 32767);
    ExpectExtremesSurvive<std::uint32_t>(Path("32.tiff"), 4294967295.);
    ExpectExtremesSurvive<std::int32_t>(Path("s32.tif"), 2147483647.);
    ExpectExtremesSurvive<float>(Path("f.tif"), 1);
    ExpectExtremesSurvive<double>(Path("d.tif"), 1);
    ExpectExtremesSurvive<float>(Path("f.exr"), 1);
}

TEST_F(Stored, RowsComeFromTheTop) {
    WriteStored<std::uint8_t>(Path("a.png"), 2, 3, {"Y"}, {1, 2, 3, 4, 5, 6});
    const Image<double> stored = ReadStoredImage(Path("a.png")).channels[0].stored;
    EXPECT_EQ(stored(0, 0), 1);
    EXPECT_EQ(stored(1, 2), 6);
}

// A normal map with heights in its alpha: a decoder that multiplies by alpha would spoil both.
TEST_F(Stored, AlphaIsAChannelLikeAnyOther) {
    WriteStored<std::uint8_t>(Path("a.png"), 1, 1, {"R", "G", "B", "A"}, {200, 100, 50, 128});
    const StoredImage image = ReadStoredImage(Path("a.png"));
    ASSERT_EQ(image.channels.size(), 4u);
    EXPECT_EQ(image.channels[0].stored(0, 0), 200);
    EXPECT_EQ(image.channels[3].name, "A");
    EXPECT_EQ(image.channels[3].stored(0, 0), 128);
}

TEST_F(Stored, KeepsTexts) {
    WriteExr(Path("a.exr"), {{"V", Image<float>(2, 2, 1)}}, {{"plumb:command", "plumb fit"}});
    EXPECT_THAT(ReadStoredImage(Path("a.exr")).metadata,
                testing::Contains(testing::Pair("plumb:command", "plumb fit")));
}

std::vector<std::uint16_t> Noise() {
    std::vector<std::uint16_t> numbers(64 * 64);
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = std::uint16_t(i * 7919);
    return numbers;
}

/// Every file that lost its tail is an error that names it. Readers differ: some report a
/// failure, some only leave a text, some say nothing.
void ExpectCutsAreFound(const std::filesystem::path& path) {
    const auto size = std::filesystem::file_size(path);
    for (double share : {0.999, 0.97, 0.8, 0.5, 0.1}) {
        std::filesystem::resize_file(path, std::uintmax_t(double(size) * share));
        EXPECT_THAT(MessageOf<Error>([&] { ReadStoredImage(path); }),
                    StartsWith(path.string() + ": "))
            << share;
    }
}

TEST_F(Stored, TruncatedFilesAreErrors) {
    WriteStored(Path("a.png"), 64, 64, {"Y"}, Noise());
    ExpectCutsAreFound(Path("a.png"));
    for (const char* compression : {"none", "zip", "lzw"}) {
        WriteStored(Path("a.tif"), 64, 64, {"Y"}, Noise(), compression);
        ExpectCutsAreFound(Path("a.tif"));
    }
    for (const char* compression : {"none", "zip", "piz"}) {
        WriteStored(Path("a.exr"), 64, 64, {"Y"}, std::vector<float>(64 * 64, 0.3f),
                    compression);
        ExpectCutsAreFound(Path("a.exr"));
    }
}

TEST_F(Stored, MissingEmptyAndFalseFilesAreErrors) {
    EXPECT_EQ(MessageOf<Error>([&] { ReadStoredImage(Path("none.png")); }),
              Path("none.png").string() + ": cannot be read: No such file or directory");
    EXPECT_EQ(MessageOf<Error>([&] { ReadStoredImage(Put("empty.png", "")); }),
              Path("empty.png").string() + ": is empty");
    WriteStored<std::uint8_t>(Path("a.jpg"), 8, 8, {"R", "G", "B"},
                              std::vector<std::uint8_t>(8 * 8 * 3, 90));
    std::filesystem::rename(Path("a.jpg"), Path("a.png"));
    EXPECT_EQ(
        MessageOf<Error>([&] { ReadStoredImage(Path("a.png")); }),
        Path("a.png").string() + ": is JPEG by its content, must be PNG as its ending says");
    EXPECT_THAT(
        MessageOf<Error>([&] {
            ReadStoredImage(Put("junk.exr", "\x76\x2f\x31\x01" + std::string(200, 'x')));
        }),
        HasSubstr("junk.exr: cannot be read"));
}

// A header may claim any size: it is refused before memory is taken (6.4 GB in this case).
TEST_F(Stored, HugeImagesAreRefusedByTheirHeader) {
    WriteStored<std::uint8_t>(Path("a.png"), 4, 4, {"Y"}, std::vector<std::uint8_t>(16));
    std::string png = Get("a.png");
    png.replace(16, 8, BigEndian(40000) + BigEndian(40000));
    png.replace(29, 4, BigEndian(PngCrc(png.substr(12, 17))));
    EXPECT_EQ(MessageOf<Error>([&] { ReadStoredImage(Put("huge.png", png)); }),
              Path("huge.png").string() +
                  ": has 40000 x 40000 pixels of 1 channel, must be at most 268435456 numbers");
    EXPECT_THROW(ReadStoredImage(Path("a.png"), 15), Error);
    EXPECT_EQ(ReadStoredImage(Path("a.png"), 16).Width(), 4);
}

// Expected: the numbers as written, and the greatest that so many bits hold, 2^bits - 1.
TEST_F(Stored, FewBitsAreTheNumbersThatTheFileHolds) {
    for (const int bits : {1, 2, 4, 8}) {
        const int greatest = (1 << bits) - 1;
        const std::vector<int> numbers{0,        greatest, 1, greatest / 2, 0,
                                       greatest, 1,        1, greatest};
        const StoredImage image = ReadStoredImage(Put("a.png", GreyPngRow(bits, numbers)));
        EXPECT_EQ(image.bits, bits);
        EXPECT_EQ(image.full_scale, greatest);
        EXPECT_EQ(image.channels[0].stored.Pixels(),
                  std::vector<double>(numbers.begin(), numbers.end()))
            << bits;
    }
}

TEST_F(Stored, SeveralPartsAreRefused) {
    const OIIO::ImageSpec spec(2, 2, 1, OIIO::TypeDesc::FLOAT);
    const OIIO::ImageSpec parts[] = {spec, spec};
    const auto output = OIIO::ImageOutput::create(Path("two.exr").string());
    const std::vector<float> pixels(4, 1);
    ASSERT_TRUE(output->open(Path("two.exr").string(), 2, parts));
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()));
    ASSERT_TRUE(
        output->open(Path("two.exr").string(), parts[1], OIIO::ImageOutput::AppendSubimage));
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()));
    ASSERT_TRUE(output->close());
    EXPECT_EQ(MessageOf<Error>([&] { ReadStoredImage(Path("two.exr")); }),
              Path("two.exr").string() + ": holds several images (parts), must hold one");
}

// A deflate stream grows at most 1032 times: 16384^2 bytes need 260111 of a file.
TEST_F(Stored, APngTooShortForItsPixelsIsRefusedByItsHeader) {
    WriteStored<std::uint8_t>(Path("a.png"), 4, 4, {"Y"}, std::vector<std::uint8_t>(16));
    std::string png = Get("a.png");
    png.replace(16, 8, BigEndian(16384) + BigEndian(16384));
    png.replace(29, 4, BigEndian(PngCrc(png.substr(12, 17))));
    EXPECT_EQ(MessageOf<Error>([&] { ReadStoredImage(Put("short.png", png)); }),
              Path("short.png").string() + ": is damaged, " + std::to_string(png.size()) +
                  " bytes cannot hold the 16384 x 16384 pixels of its header");
    // Zeros take the least that there is: they must pass.
    WriteStored<std::uint8_t>(Path("zeros.png"), 1024, 1024, {"Y"},
                              std::vector<std::uint8_t>(1024 * 1024));
    EXPECT_EQ(ReadStoredImage(Path("zeros.png")).Width(), 1024);
}

TEST_F(Stored, ReadsPfmToo) {
    // 1.0f in little-endian bytes.
    Put("a.pfm", std::string("Pf\n1 1\n-1\n") + std::string("\0\0\x80\x3f", 4));
    EXPECT_EQ(ReadStoredImage(Path("a.pfm")).channels[0].stored(0, 0), 1);
}

}  // namespace
}  // namespace plumb
