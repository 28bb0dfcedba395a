// Pictures as artists have them: textures and skies in any common format.
//
// PNG, JPEG, TGA, BMP, TIFF, OpenEXR, Radiance HDR, GIF, known by their content; a TGA, which
// has no mark, by its ending. Integers of colours are taken as sRGB-encoded and are
// decoded; floats, and numbers that are no colours, are linear.
//
// Colours are taken as stored, not multiplied by an alpha nor divided by it.
//
// Beware   For data, not looks, take io/stored_image.h: it refuses formats that lose some. Of a
//          cut-off JPEG decoders may return the part that is there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/image.h"
#include "io/stored_image.h"

namespace plumb {

enum class PictureOf { kColours, kNumbers };

struct Picture {
    Image<Rgb> linear;             ///< Finite and >= 0; what was not became 0.
    Image<float> opacity;          ///< In [0, 1]; empty if the file has none.
    bool had_bad_numbers = false;  ///< Some were not finite or negative.
};

/// Throws Error naming the file and what is wrong: missing, damaged, of no known format, or
/// larger than `max_numbers` (before memory is taken).
Picture ReadPictureFile(const std::filesystem::path& path, PictureOf of = PictureOf::kColours,
                        std::int64_t max_numbers = kMaxImageNumbers);

/// The same of a file's bytes; `name` is what errors call it.
Picture DecodePicture(std::string_view bytes, const std::string& name,
                      PictureOf of = PictureOf::kColours,
                      std::int64_t max_numbers = kMaxImageNumbers);

}  // namespace plumb
