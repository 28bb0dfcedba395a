#include "io/image_format.h"

#include "core/error.h"
#include "io/image_io.h"
#include "io/whole_file.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

TEST(ImageFormat, IsWhatEndingAndContentAgreeOn) {
    EXPECT_EQ(CheckImageFormat("a.png", "\x89PNG\r\n\x1a\n...."), ImageFormat::kPng);
    EXPECT_EQ(CheckImageFormat("a.TIF", std::string("II*\0....", 8)), ImageFormat::kTiff);
    EXPECT_EQ(CheckImageFormat("a.tiff", std::string("MM\0*....", 8)), ImageFormat::kTiff);
    EXPECT_EQ(CheckImageFormat("a.exr", "\x76\x2f\x31\x01...."), ImageFormat::kExr);
    EXPECT_EQ(CheckImageFormat("a.pfm", "Pf\n1 1\n"), ImageFormat::kPfm);
}

TEST(ImageFormat, NamesWhatAFileReallyIs) {
    const auto message = [](const char* path, const std::string& bytes) {
        return MessageOf<Error>([&] { CheckImageFormat(path, bytes); });
    };
    EXPECT_EQ(message("a.png", "\xff\xd8\xff\xe0...."),
              "a.png: is JPEG by its content, must be PNG as its ending says");
    EXPECT_EQ(message("a.tif", "<!DOCTYPE html>"),
              "a.tif: is web page or XML by its content, must be TIFF as its ending says");
    EXPECT_EQ(message("a.exr", "\x89PNG\r\n\x1a\n"),
              "a.exr: is PNG by its content, must be OpenEXR as its ending says");
    EXPECT_EQ(message("a.png", "hello"),
              "a.png: is of no known format by its content, must be PNG as its ending says");
    EXPECT_EQ(message("a.png", ""), "a.png: is empty");
    EXPECT_EQ(message("a.jpg", "\xff\xd8\xff\xe0"),
              "a.jpg: ends in .jpg, must be .png, .tif, .tiff, .exr or .pfm");
    EXPECT_EQ(message("heights", "\x89PNG"),
              "heights: ends in nothing, must be .png, .tif, .tiff, .exr or .pfm");
}

using WholePng = TempFolder;

TEST_F(WholePng, EveryCutAndEveryFlippedBitIsFound) {
    WriteGreyPng(Path("a.png"), Image<double>(20, 10, 0.5), 16);
    const std::string png = ReadWholeFile(Path("a.png"));
    CheckPngIsWhole("a.png", png);
    for (std::size_t size = 8; size < png.size(); ++size) {
        EXPECT_EQ(MessageOf<Error>([&] { CheckPngIsWhole("a.png", png.substr(0, size)); }),
                  "a.png: is truncated, the end of the PNG is missing");
    }
    for (std::size_t byte = 8; byte < png.size(); ++byte) {
        std::string damaged = png;
        damaged[byte] = char(damaged[byte] ^ 4);
        EXPECT_THROW(CheckPngIsWhole("a.png", damaged), Error) << "byte " << byte;
    }
}

// 40000^2 = 1.6e9 > 2^28; the sizes are multiplied without overflow.
TEST(ImageSize, IsCheckedAgainstTheLimit) {
    CheckImageSize("a.png", 16384, 16384, 1, std::int64_t{1} << 28);
    EXPECT_EQ(
        MessageOf<Error>(
            [] { CheckImageSize("a.png", 40000, 40000, 1, std::int64_t{1} << 28); }),
        "a.png: has 40000 x 40000 pixels of 1 channel, must be at most 268435456 numbers");
    EXPECT_THROW(CheckImageSize("a.png", std::int64_t{1} << 62, std::int64_t{1} << 62, 4,
                                std::int64_t{1} << 28),
                 Error);
}

}  // namespace
}  // namespace plumb
