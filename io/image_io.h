// Pictures and float images as files.
//
//       EXR        32-bit floats in named channels, with texts beside them: for machines
//       preview    8-bit PNG, sRGB-encoded from linear values in [0, 1]: for eyes
//       grey PNG   8 or 16 bits, stored = round(value * full scale): for heights
//
// Source   the encoding of previews: [IEC61966] IEC 61966-2-1, sRGB.
// Beware   Previews clamp to [0, 1]; what is not a number is drawn in magenta, because a
//          picture that hides it lies. Files are written whole or not at all, and the same
//          image gives the same bytes.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/image.h"
#include "io/stored_image.h"

namespace plumb {

using ImageTexts = std::vector<std::pair<std::string, std::string>>;

struct NamedChannel {
    std::string name;
    Image<float> pixels;
};

/// Channels of one size. Throws Error if a name is empty or twice, MachineError if the disk
/// fails.
void WriteExr(const std::filesystem::path& path, const std::vector<NamedChannel>& channels,
              const ImageTexts& texts = {});

/// The same channels and texts back from any EXR, PFM, TIFF or PNG; integers become value /
/// full scale, no gamma is applied.
std::vector<NamedChannel> ReadChannels(const std::filesystem::path& path,
                                       std::int64_t max_numbers = kMaxImageNumbers);

void WritePreview(const std::filesystem::path& path, const Image<Rgb>& linear);
void WritePreview(const std::filesystem::path& path, const Image<float>& linear_grey);

/// A picture as linear colours. Integer formats are taken to be sRGB-encoded and are decoded;
/// floats are taken as linear. One channel (or "Y") counts for all three; an alpha is left out.
/// Throws Error if there are neither R, G and B nor one colour channel.
Image<Rgb> ReadPicture(const std::filesystem::path& path,
                       std::int64_t max_numbers = kMaxImageNumbers);

/// `bits` is 8 or 16; values outside [0, 1] are an Error that names the pixel.
void WriteGreyPng(const std::filesystem::path& path, const Image<double>& values, int bits);

}  // namespace plumb
