#include "io/tiff_image.h"

#include <tiffio.h>

#include <algorithm>
#include <cstring>

#include "core/error.h"
#include "core/vec.h"
#include "io/image_format.h"
#include "io/open_tiff.h"

namespace plumb {
namespace {

/// What the directory says of the pixels.
struct Layout {
    std::uint32_t width = 0, height = 0;
    std::uint16_t channels = 1, bits = 1, format = SAMPLEFORMAT_UINT, photometric = 0;
    bool planes_apart = false, tiled = false;
    std::uint32_t block_width = 0, block_height = 0;  ///< Of a tile or strip.
};

template <class T>
T TagOr(TIFF* file, std::uint32_t tag, T otherwise) {
    T value = otherwise;
    return TIFFGetFieldDefaulted(file, tag, &value) == 1 ? value : otherwise;
}

Layout ReadLayout(TIFF* file) {
    Layout layout;
    layout.width = TagOr(file, TIFFTAG_IMAGEWIDTH, 0u);
    layout.height = TagOr(file, TIFFTAG_IMAGELENGTH, 0u);
    layout.channels = TagOr(file, TIFFTAG_SAMPLESPERPIXEL, std::uint16_t(1));
    layout.bits = TagOr(file, TIFFTAG_BITSPERSAMPLE, std::uint16_t(1));
    layout.format = TagOr(file, TIFFTAG_SAMPLEFORMAT, std::uint16_t(SAMPLEFORMAT_UINT));
    layout.photometric =
        TagOr(file, TIFFTAG_PHOTOMETRIC, std::uint16_t(PHOTOMETRIC_MINISBLACK));
    layout.planes_apart = TagOr(file, TIFFTAG_PLANARCONFIG,
                                std::uint16_t(PLANARCONFIG_CONTIG)) == PLANARCONFIG_SEPARATE;
    layout.tiled = TIFFIsTiled(file) != 0;
    layout.block_width = layout.tiled ? TagOr(file, TIFFTAG_TILEWIDTH, 0u) : layout.width;
    layout.block_height = layout.tiled
                              ? TagOr(file, TIFFTAG_TILELENGTH, 0u)
                              : std::min(TagOr(file, TIFFTAG_ROWSPERSTRIP, ~0u), layout.height);
    return layout;
}

using Convert = double (*)(const std::uint8_t*);

template <class T>
double ConvertTo(const std::uint8_t* bytes) {
    T number;
    std::memcpy(&number, bytes, sizeof number);
    return double(number);
}

/// From the bytes of a stored number (which libtiff has put into our byte order); nullptr if
/// there is no such type.
Convert ConversionOf(const Layout& layout) {
    switch (layout.format * 100 + layout.bits) {
        case SAMPLEFORMAT_UINT * 100 + 8:
            return ConvertTo<std::uint8_t>;
        case SAMPLEFORMAT_UINT * 100 + 16:
            return ConvertTo<std::uint16_t>;
        case SAMPLEFORMAT_UINT * 100 + 32:
            return ConvertTo<std::uint32_t>;
        case SAMPLEFORMAT_INT * 100 + 8:
            return ConvertTo<std::int8_t>;
        case SAMPLEFORMAT_INT * 100 + 16:
            return ConvertTo<std::int16_t>;
        case SAMPLEFORMAT_INT * 100 + 32:
            return ConvertTo<std::int32_t>;
        case SAMPLEFORMAT_IEEEFP * 100 + 16:
            return ConvertTo<Eigen::half>;
        case SAMPLEFORMAT_IEEEFP * 100 + 32:
            return ConvertTo<float>;
        case SAMPLEFORMAT_IEEEFP * 100 + 64:
            return ConvertTo<double>;
        default:
            return nullptr;
    }
}

void CheckLayout(const Layout& layout, TIFF* file, const std::string& name,
                 std::int64_t max_numbers) {
    CheckImageSize(name, layout.width, layout.height, layout.channels, max_numbers);
    if (ConversionOf(layout) == nullptr) {
        throw Error(MustBe(name + ": bits per number", layout.bits,
                           "8, 16 or 32 of an integer, 16, 32 or 64 of a float"));
    }
    if (layout.photometric != PHOTOMETRIC_MINISBLACK &&
        layout.photometric != PHOTOMETRIC_MINISWHITE && layout.photometric != PHOTOMETRIC_RGB) {
        throw Error(MustBe(name + ": photometric interpretation", layout.photometric,
                           "0, 1 (grey) or 2 (RGB)"));
    }
    const auto orientation = TagOr(file, TIFFTAG_ORIENTATION, std::uint16_t(1));
    if (orientation != ORIENTATION_TOPLEFT) {
        throw Error(MustBe(name + ": orientation", orientation, "1 (from the top left)"));
    }
    if (layout.block_width == 0 || layout.block_height == 0) {
        throw Error(name + ": has strips or tiles without a size");
    }
}

/// Throws Error if another page says more than the first: a picture of its own, or a mask of
/// what was measured. A smaller copy of the first (an overview) says nothing new.
void CheckFurtherPages(TIFF* file, const std::string& name) {
    for (int page = 2; TIFFReadDirectory(file) == 1; ++page) {
        const auto kind = TagOr(file, TIFFTAG_SUBFILETYPE, 0u);
        if (kind & FILETYPE_MASK) {
            throw Error(name + ": page " + std::to_string(page) +
                        " is a mask of pixels without data, must be left out, and the pixels "
                        "that it hides filled");
        }
        if (!(kind & FILETYPE_REDUCEDIMAGE)) {
            throw Error(name + ": page " + std::to_string(page) +
                        " is a further image, must hold one image (and its overviews)");
        }
    }
}

std::string ChannelName(const Layout& layout, std::size_t channel) {
    const bool rgb = layout.photometric == PHOTOMETRIC_RGB && layout.channels >= 3;
    const std::string_view names = rgb ? "RGBA" : layout.channels <= 2 ? "YA" : "";
    return channel < names.size() ? std::string(1, names[channel])
                                  : "channel" + std::to_string(channel);
}

/// Reads the tile or strip whose first pixel is (x, y); a strip at the lower border is short.
void ReadBlock(TIFF* file, const Layout& layout, std::uint32_t x, std::uint32_t y,
               std::uint16_t plane, std::vector<std::uint8_t>& bytes, const std::string& name) {
    const std::uint32_t rows =
        layout.tiled ? layout.block_height : std::min(layout.block_height, layout.height - y);
    const tmsize_t needed = tmsize_t(rows) * tmsize_t(layout.block_width) * layout.bits / 8 *
                            (layout.planes_apart ? 1 : layout.channels);
    bytes.assign(std::size_t(needed), 0);
    const tmsize_t read = layout.tiled
                              ? TIFFReadEncodedTile(file, TIFFComputeTile(file, x, y, 0, plane),
                                                    bytes.data(), needed)
                              : TIFFReadEncodedStrip(file, TIFFComputeStrip(file, y, plane),
                                                     bytes.data(), needed);
    if (read != needed) {
        throw Error(name + ": is truncated or damaged at row " + std::to_string(y));
    }
}

/// Hands the numbers of a block to the channels that they belong to.
void Distribute(const std::vector<std::uint8_t>& bytes, const Layout& layout, std::uint32_t x,
                std::uint32_t y, std::uint16_t plane, StoredImage& image) {
    const Convert convert = ConversionOf(layout);
    const std::size_t interleaved = layout.planes_apart ? 1 : layout.channels;
    const std::size_t number_bytes = layout.bits / 8;
    const std::uint32_t columns = std::min(layout.block_width, layout.width - x);
    const std::uint32_t rows = std::min(layout.block_height, layout.height - y);
    for (std::size_t c = 0; c < interleaved; ++c) {
        Image<double>& stored = image.channels[plane + c].stored;
        for (std::uint32_t j = 0; j < rows; ++j) {
            for (std::uint32_t i = 0; i < columns; ++i) {
                const std::size_t number =
                    (std::size_t(j) * layout.block_width + i) * interleaved + c;
                stored(int(x + i), int(y + j)) = convert(&bytes[number * number_bytes]);
            }
        }
    }
}

}  // namespace

StoredImage ReadTiffImage(const std::filesystem::path& path, std::int64_t max_numbers) {
    const auto file = OpenTiff(path);
    const Layout layout = ReadLayout(file.get());
    CheckLayout(layout, file.get(), path.string(), max_numbers);
    StoredImage image;
    image.is_float = layout.format == SAMPLEFORMAT_IEEEFP;
    image.is_signed = layout.format != SAMPLEFORMAT_UINT;
    image.bits = layout.bits;
    image.full_scale = image.is_float ? 1 : GreatestInteger(image.bits, image.is_signed);
    for (std::size_t c = 0; c < layout.channels; ++c) {
        image.channels.push_back(
            {ChannelName(layout, c), Image<double>(int(layout.width), int(layout.height))});
    }
    std::vector<std::uint8_t> bytes;
    const std::uint16_t planes = layout.planes_apart ? layout.channels : 1;
    for (std::uint16_t plane = 0; plane < planes; ++plane) {
        for (std::uint32_t y = 0; y < layout.height; y += layout.block_height) {
            for (std::uint32_t x = 0; x < layout.width; x += layout.block_width) {
                ReadBlock(file.get(), layout, x, y, plane, bytes, path.string());
                Distribute(bytes, layout, x, y, plane, image);
            }
        }
    }
    if (layout.photometric == PHOTOMETRIC_MINISWHITE && !image.is_float) {
        for (double& number : image.channels.front().stored.Pixels()) {
            number = image.full_scale - number;
        }
    }
    CheckFurtherPages(file.get(), path.string());
    return image;
}

}  // namespace plumb
