#include "io/tiff_image.h"

#include <gmock/gmock.h>
#include <tiffio.h>

#include "core/error.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

using testing::HasSubstr;

/// How a test writes its file.
struct TiffLayout {
    std::uint16_t compression = COMPRESSION_NONE;
    std::uint16_t planar = PLANARCONFIG_CONTIG;
    std::uint16_t photometric = PHOTOMETRIC_MINISBLACK;
    std::uint16_t orientation = ORIENTATION_TOPLEFT;
    std::uint16_t bits = 16;
    bool tiled = false;
    bool big_endian = false;
};

constexpr int kWidth = 37, kHeight = 21;  // no multiple of the strip (4 rows) or tile (16 x 16)

std::uint16_t Number(int i, int j, int channel) {
    return std::uint16_t(1000 * channel + 40 * j + i + 1);
}

class Tiff : public TempFolder {
  protected:
    /// 16-bit numbers that say where they belong.
    std::filesystem::path Write(int channels, const TiffLayout& layout) const {
        TIFF* file = TIFFOpen(Path("a.tif").c_str(), layout.big_endian ? "wb" : "wl");
        TIFFSetField(file, TIFFTAG_IMAGEWIDTH, kWidth);
        TIFFSetField(file, TIFFTAG_IMAGELENGTH, kHeight);
        TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, channels);
        TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, layout.bits);
        TIFFSetField(file, TIFFTAG_COMPRESSION, layout.compression);
        TIFFSetField(file, TIFFTAG_PLANARCONFIG, layout.planar);
        TIFFSetField(file, TIFFTAG_PHOTOMETRIC, layout.photometric);
        TIFFSetField(file, TIFFTAG_ORIENTATION, layout.orientation);
        std::vector<std::uint16_t> colours(std::size_t{1} << layout.bits);
        if (layout.photometric == PHOTOMETRIC_PALETTE) {
            TIFFSetField(file, TIFFTAG_COLORMAP, colours.data(), colours.data(),
                         colours.data());
        }
        const int block_width = layout.tiled ? 16 : kWidth,
                  block_height = layout.tiled ? 16 : 4;
        if (layout.tiled) {
            TIFFSetField(file, TIFFTAG_TILEWIDTH, block_width);
            TIFFSetField(file, TIFFTAG_TILELENGTH, block_height);
        } else {
            TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, block_height);
        }
        const bool apart = layout.planar == PLANARCONFIG_SEPARATE;
        for (int plane = 0; plane < (apart ? channels : 1); ++plane) {
            for (int y = 0; y < kHeight; y += block_height) {
                for (int x = 0; x < kWidth; x += block_width) {
                    std::vector<std::uint16_t> block;
                    for (int j = y; j < y + block_height; ++j) {
                        for (int i = x; i < x + block_width; ++i) {
                            for (int c = 0; c < (apart ? 1 : channels); ++c) {
                                block.push_back(Number(i, j, plane + c));
                            }
                        }
                    }
                    const auto p = std::uint16_t(plane);
                    if (layout.tiled) {
                        TIFFWriteTile(file, block.data(), std::uint32_t(x), std::uint32_t(y), 0,
                                      p);
                    } else {
                        const auto row = std::uint32_t(y);
                        const int rows = std::min(block_height, kHeight - y);
                        const auto size = block.size() / std::size_t(block_height);
                        TIFFWriteEncodedStrip(file, TIFFComputeStrip(file, row, p),
                                              block.data(), tmsize_t(2 * size) * rows);
                    }
                }
            }
        }
        TIFFClose(file);
        return Path("a.tif");
    }
};

TEST_F(Tiff, EveryLayoutGivesTheSamePixels) {
    for (int channels : {1, 3}) {
        for (auto compression :
             {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE}) {
            for (auto planar : {PLANARCONFIG_CONTIG, PLANARCONFIG_SEPARATE}) {
                for (bool tiled : {false, true}) {
                    const StoredImage image = ReadTiffImage(
                        Write(channels,
                              {.compression = std::uint16_t(compression),
                               .planar = std::uint16_t(planar),
                               .photometric = std::uint16_t(
                                   channels == 3 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK),
                               .tiled = tiled,
                               .big_endian = tiled}),
                        1 << 20);
                    ASSERT_EQ(int(image.channels.size()), channels);
                    for (int c = 0; c < channels; ++c) {
                        Image<double> expected(kWidth, kHeight);
                        for (int j = 0; j < kHeight; ++j) {
                            for (int i = 0; i < kWidth; ++i) expected(i, j) = Number(i, j, c);
                        }
                        EXPECT_EQ(image.channels[std::size_t(c)].stored, expected)
                            << channels << " " << compression << " " << planar << " " << tiled;
                    }
                }
            }
        }
    }
}

TEST_F(Tiff, ChannelsHaveNames) {
    const auto names = [&](int channels, std::uint16_t photometric) {
        std::string text;
        for (const auto& channel :
             ReadTiffImage(Write(channels, {.photometric = photometric}), 1 << 20).channels) {
            text += channel.name + " ";
        }
        return text;
    };
    EXPECT_EQ(names(1, PHOTOMETRIC_MINISBLACK), "Y ");
    EXPECT_EQ(names(2, PHOTOMETRIC_MINISBLACK), "Y A ");
    EXPECT_EQ(names(5, PHOTOMETRIC_RGB), "R G B A channel4 ");
    EXPECT_EQ(names(3, PHOTOMETRIC_MINISBLACK), "channel0 channel1 channel2 ");
}

TEST_F(Tiff, WhiteMayBeZero) {
    const StoredImage image =
        ReadTiffImage(Write(1, {.photometric = PHOTOMETRIC_MINISWHITE}), 1 << 20);
    EXPECT_EQ(image.channels[0].stored(3, 2), 65535 - Number(3, 2, 0));
}

// A damaged strip must not come back as pixels: OpenImageIO 2.4 lets this very file pass.
TEST_F(Tiff, ADamagedStripIsAnError) {
    Write(1, {.compression = COMPRESSION_ADOBE_DEFLATE});
    std::string bytes = Get("a.tif");
    for (std::size_t k = 60; k < 100; ++k) bytes[k] = char(bytes[k] ^ 0x55);
    EXPECT_THAT(MessageOf<Error>([&] { ReadTiffImage(Put("a.tif", bytes), 1 << 20); }),
                HasSubstr("a.tif: is truncated or damaged at row "));
}

// An overview is the same picture, smaller; anything else would be left out without a word.
TEST_F(Tiff, FurtherPagesAreRefusedUnlessTheyAreOverviews) {
    const auto with_page = [&](std::uint32_t kind) {
        TIFF* file = TIFFOpen(Write(1, {}).c_str(), "a");
        const std::uint16_t row[2] = {7, 8};
        TIFFSetField(file, TIFFTAG_SUBFILETYPE, kind);
        TIFFSetField(file, TIFFTAG_IMAGEWIDTH, 2);
        TIFFSetField(file, TIFFTAG_IMAGELENGTH, 1);
        TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, 1);
        TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 16);
        TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
        TIFFWriteEncodedStrip(file, 0, const_cast<std::uint16_t*>(row), sizeof row);
        TIFFClose(file);
        return Path("a.tif");
    };
    const StoredImage image = ReadTiffImage(with_page(FILETYPE_REDUCEDIMAGE), 1 << 20);
    EXPECT_EQ(image.Width(), kWidth);
    EXPECT_EQ(image.channels[0].stored(3, 2), Number(3, 2, 0));
    EXPECT_THAT(MessageOf<Error>([&] { ReadTiffImage(with_page(0), 1 << 20); }),
                HasSubstr("a.tif: page 2 is a further image, must hold one image"));
    EXPECT_THAT(MessageOf<Error>([&] {
                    ReadTiffImage(with_page(FILETYPE_MASK | FILETYPE_REDUCEDIMAGE), 1 << 20);
                }),
                HasSubstr("a.tif: page 2 is a mask of pixels without data"));
}

TEST_F(Tiff, NamesWhatItCannotRead) {
    const auto message = [&](const TiffLayout& layout) {
        const std::string text =
            MessageOf<Error>([&] { ReadTiffImage(Write(1, layout), 1 << 20); });
        return text.substr(folder_.string().size() + 1);
    };
    EXPECT_EQ(message({.bits = 4}),
              "a.tif: bits per number = 4, must be 8, 16 or 32 of an integer, 16, 32 or 64 of "
              "a float");
    EXPECT_EQ(message({.photometric = PHOTOMETRIC_PALETTE}),
              "a.tif: photometric interpretation = 3, must be 0, 1 (grey) or 2 (RGB)");
    EXPECT_EQ(message({.orientation = ORIENTATION_BOTLEFT}),
              "a.tif: orientation = 4, must be 1 (from the top left)");
    EXPECT_EQ(MessageOf<Error>([&] { ReadTiffImage(Write(1, {}), 99); }),
              Path("a.tif").string() +
                  ": has 37 x 21 pixels of 1 channel, must be at most 99 numbers");
}

}  // namespace
}  // namespace plumb
