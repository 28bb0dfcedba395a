#include "io/image_format.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <string>

#include "core/error.h"

namespace plumb {
namespace {

using std::string_view_literals::operator""sv;

struct Signature {
    std::string_view name, bytes;
};

// Of the formats that height maps and pictures come in, and of what they are mistaken for.
constexpr std::array kSignatures{
    Signature{"PNG", "\x89PNG\r\n\x1a\n"sv},
    Signature{"TIFF", "II*\0"sv},
    Signature{"TIFF", "MM\0*"sv},
    Signature{"TIFF", "II+\0"sv},
    Signature{"TIFF", "MM\0+"sv},
    Signature{"OpenEXR", "\x76\x2f\x31\x01"sv},
    Signature{"PFM", "Pf"sv},
    Signature{"PFM", "PF"sv},
    Signature{"JPEG", "\xff\xd8\xff"sv},
    Signature{"JPEG 2000", "\0\0\0\x0cjP"sv},
    Signature{"GIF", "GIF8"sv},
    Signature{"BMP", "BM"sv},
    Signature{"WebP (RIFF)", "RIFF"sv},
    Signature{"Radiance HDR", "#?"sv},
    Signature{"Photoshop", "8BPS"sv},
    Signature{"DDS", "DDS "sv},
    Signature{"PGM", "P5"sv},
    Signature{"PPM", "P6"sv},
    Signature{"HDF5", "\x89HDF"sv},
    Signature{"netCDF", "CDF"sv},
    Signature{"zip archive", "PK\x03\x04"sv},
    Signature{"gzip archive", "\x1f\x8b"sv},
    Signature{"xz archive",
              "\xfd"
              "7zXZ"sv},
    Signature{"Git LFS pointer", "version https://git"sv},
    Signature{"web page or XML", "<"sv},
};

struct Format {
    ImageFormat format;
    std::string_view name;
};

Format FormatOfEnding(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    if (ending == ".png") return {ImageFormat::kPng, "PNG"};
    if (ending == ".tif" || ending == ".tiff") return {ImageFormat::kTiff, "TIFF"};
    if (ending == ".exr") return {ImageFormat::kExr, "OpenEXR"};
    if (ending == ".pfm") return {ImageFormat::kPfm, "PFM"};
    throw Error(path.string() + ": ends in " + (ending.empty() ? "nothing" : ending) +
                ", must be .png, .tif, .tiff, .exr or .pfm");
}

std::uint32_t BigEndian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (char byte : bytes.substr(0, 4)) value = value << 8 | std::uint8_t(byte);
    return value;
}

/// The cyclic redundancy check of PNG chunks: ISO 3309, polynomial 0xedb88320 reflected.
std::uint32_t Crc32(std::string_view bytes) {
    static const auto table = [] {
        std::array<std::uint32_t, 256> entries;
        for (std::uint32_t n = 0; n < 256; ++n) {
            std::uint32_t c = n;
            for (int k = 0; k < 8; ++k) c = c & 1 ? 0xedb88320u ^ (c >> 1) : c >> 1;
            entries[n] = c;
        }
        return entries;
    }();
    std::uint32_t crc = 0xffffffffu;
    for (char byte : bytes) crc = table[(crc ^ std::uint8_t(byte)) & 255] ^ (crc >> 8);
    return ~crc;
}

}  // namespace

ImageFormat CheckImageFormat(const std::filesystem::path& path, std::string_view bytes) {
    const Format expected = FormatOfEnding(path);
    if (bytes.empty()) throw Error(path.string() + ": is empty");
    const auto found = std::find_if(
        kSignatures.begin(), kSignatures.end(),
        [&](const Signature& signature) { return bytes.starts_with(signature.bytes); });
    if (found == kSignatures.end() || found->name != expected.name) {
        const std::string really =
            found == kSignatures.end() ? "of no known format" : std::string(found->name);
        throw Error(path.string() + ": is " + really + " by its content, must be " +
                    std::string(expected.name) + " as its ending says");
    }
    return expected.format;
}

void CheckPngIsWhole(const std::filesystem::path& path, std::string_view bytes) {
    // [PNG] ISO/IEC 15948, 5.3: length, type, data, checksum of type and data.
    bytes.remove_prefix(8);
    for (bool ended = false; !ended;) {
        const std::size_t length = bytes.size() < 12 ? 0 : BigEndian(bytes);
        if (bytes.size() < 12 || bytes.size() - 12 < length) {
            throw Error(path.string() + ": is truncated, the end of the PNG is missing");
        }
        const std::string_view type = bytes.substr(4, 4);
        if (Crc32(bytes.substr(4, 4 + length)) != BigEndian(bytes.substr(8 + length))) {
            throw Error(path.string() + ": is damaged, chunk " + std::string(type) +
                        " has a wrong checksum");
        }
        ended = type == "IEND";
        bytes.remove_prefix(12 + length);
    }
}

void CheckPngHoldsItsPixels(const std::string& name, std::string_view bytes) {
    constexpr double kMostExpansion = 1032;  // Of a deflate stream (zlib, Technical Details).
    // [PNG] 11.2.2: after the mark, length and type of IHDR width, height, bit depth, colour type.
    if (bytes.size() < 33) throw Error(name + ": is truncated, must have the header of a PNG");
    const std::uint32_t width = BigEndian(bytes.substr(16)),
                        height = BigEndian(bytes.substr(20));
    const double bits = std::uint8_t(bytes[24]);
    const int type = bytes[25];
    const double channels = type == 2 ? 3 : type == 4 ? 2 : type == 6 ? 4 : 1;
    const double needed = double(width) * double(height) * bits * channels / 8 / kMostExpansion;
    if (double(bytes.size()) < needed) {
        throw Error(name + ": is damaged, " + std::to_string(bytes.size()) +
                    " bytes cannot hold the " + std::to_string(width) + " x " +
                    std::to_string(height) + " pixels of its header");
    }
}

void CheckImageSize(const std::string& name, std::int64_t width, std::int64_t height,
                    std::int64_t channels, std::int64_t max_numbers) {
    const std::string size = std::to_string(width) + " x " + std::to_string(height) +
                             " pixels of " + std::to_string(channels) +
                             (channels == 1 ? " channel" : " channels");
    if (width < 1 || height < 1 || channels < 1) {
        throw Error(name + ": has " + size + ", must have at least one of each");
    }
    // In double, because a header may claim any size; exact below 2^53.
    if (double(width) * double(height) * double(channels) > double(max_numbers)) {
        throw Error(name + ": has " + size + ", must be at most " +
                    std::to_string(max_numbers) + " numbers");
    }
}

}  // namespace plumb
