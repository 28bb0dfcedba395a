// An image as its file stores it: numbers, not colours.
//
// PNG, TIFF, OpenEXR and PFM. No gamma, no colour profile, no multiplication by alpha. A file
// with several images is refused (an overview of a TIFF is no image of its own).
//
// Beware   Row 0 is the top row of the picture, as everywhere but in a PFM file, whose rows are
//          turned.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/image.h"

namespace plumb {

/// Numbers (pixels times channels) that an image may have unless its reader says otherwise:
/// 2 GB in memory.
inline constexpr std::int64_t kMaxImageNumbers = std::int64_t{1} << 28;

struct StoredImage {
    struct Channel {
        std::string name;  ///< As the file has it; "Y" or "R", "G", "B", "A" if it has none.
        Image<double> stored;  ///< The numbers as stored: 0 ... 65535 for 16 bits.
    };
    std::vector<Channel> channels;  ///< At least one, all of one size.
    bool is_float = false;
    bool is_signed = false;  ///< Of integers.
    int bits = 0;            ///< Of a stored number: 1, 2, 4 (PNG), 8, 16, 32; 64 for double.
    double full_scale = 1;   ///< Greatest integer: 1, 255, 65535, 32767 ...; 1 for floats.
    std::vector<std::pair<std::string, std::string>> metadata;  ///< Texts of the file.

    int Width() const { return channels.front().stored.Width(); }
    int Height() const { return channels.front().stored.Height(); }
};

/// 255, 65535, 32767 ...: the greatest integer of so many bits, in two's complement if signed.
constexpr double GreatestInteger(int bits, bool is_signed) {
    return double((std::uint64_t{1} << (bits - (is_signed ? 1 : 0))) - 1);
}

/// Throws Error naming the file and what is wrong: missing, empty, truncated, damaged, of
/// another format than its ending says, or larger than `max_numbers` (before memory is taken).
StoredImage ReadStoredImage(const std::filesystem::path& path,
                            std::int64_t max_numbers = kMaxImageNumbers);

}  // namespace plumb
